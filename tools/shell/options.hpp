// The flags that the programs share.
#ifndef GEMINGA_SHELL_OPTIONS_HPP
#define GEMINGA_SHELL_OPTIONS_HPP

#include <CLI/App.hpp>
#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "geminga/client.hpp"
#include "geminga/match.hpp"
#include "geminga/named.hpp"
#include "geminga/service.hpp"
#include "shell/exit_status.hpp"

namespace geminga::shell {

/// The longest --timeout: a year, so that no sum of times can overflow.
inline constexpr double max_timeout_seconds = 366.0 * 24 * 3600;

/// --connect, --json, --timeout, --version.
struct CommonOptions {
  std::string connect;
  bool is_json = false;
  std::optional<double> timeout_seconds;

  /// Adds the flags to a program. Borrows this for the life of `app`.
  void add_to(CLI::App& app, const std::string& timeout_meaning);
  /// The same without --json, for a program that prints nothing.
  void add_without_json_to(CLI::App& app, const std::string& timeout_meaning);
  [[nodiscard]] std::chrono::milliseconds timeout_or(std::chrono::milliseconds usual) const;
};

/// The error of a word `KEY=` of an identity.
inline constexpr std::string_view nothing_behind =
    "has nothing behind it: see whether the variable that it comes from is set";

/// --id, --text, --representation, or the same as words (`text=camera`); a concept comes as a positional word.
struct IdentityOptions {
  std::optional<std::string> id;
  std::optional<std::string> text;
  std::string representation;

  void add_to(CLI::App& app);
  /// Takes a word `id=N`, `text=NAME` or `representation=R` as the flag of that name; false where it is none of these.
  /// Throws CLI::ValidationError where it was given already, or is empty.
  bool takes(const std::string& word);
  /// The identity with this concept (empty: none); nothing where no identity is given. Throws CLI::ValidationError
  /// where two are given or one cannot be read.
  [[nodiscard]] std::optional<NamedIdentity> identity(const std::string& concept_name) const;
  [[nodiscard]] bool needs_no_concept() const { return id.has_value() || text.has_value(); }
};

/// A check that a flag's value is a whole number between these.
[[nodiscard]] std::function<std::string(const std::string&)> whole_number(std::int64_t least, std::int64_t most);

/// Adds a flag with a time of at most max_timeout_seconds, e.g. `--timeout SECONDS`.
CLI::Option* add_seconds(CLI::App& app, const std::string& flag, std::optional<double>& seconds,
                         const std::string& meaning);
/// Rounds up, so that only 0 becomes 0.
[[nodiscard]] std::chrono::milliseconds in_milliseconds(double seconds);

/// `key` and `value` of a word `KEY=VALUE`; nothing where the word has another form. Class expressions never have this
/// one.
[[nodiscard]] std::optional<std::pair<std::string, std::string>> key_and_value(const std::string& word);

/// Adds `--mode M` (oto, otm/stream, otm/pubsub).
void add_mode(CLI::App& app, std::optional<ChannelMode>& mode, const std::string& meaning);
/// Adds `--degree D` (exact, equivalent, narrower, broader, overlapping).
void add_degree(CLI::App& app, Degree& degree);

/// Reads the command line. Returns the exit status where the program ends here: after printing help, version or
/// description on standard output, or a mistake on standard error.
[[nodiscard]] std::optional<ExitStatus> parse(CLI::App& app, int argc, char** argv);

}  // namespace geminga::shell

#endif
