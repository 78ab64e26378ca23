#include "shell/options.hpp"

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <iostream>

#include "base/edit_distance.hpp"
#include "base/text.hpp"
#include "manual/describe.hpp"
#include "manual/mistake.hpp"
#include "shell/report.hpp"
#include "shell/terminal.hpp"

namespace geminga::shell {
namespace {

/// The error in a --timeout; empty: none. (CLI::Range would accept NaN.)
std::string complaint_about_seconds(const std::string& text) {
  double seconds = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), seconds);
  const bool is_number = !text.empty() && read.ec == std::errc() && read.ptr == text.data() + text.size();
  if (is_number && seconds >= 0 && seconds <= max_timeout_seconds) return {};
  return "must be seconds from 0 to " + std::to_string(static_cast<long>(max_timeout_seconds));
}

}  // namespace

void CommonOptions::add_to(CLI::App& app, const std::string& timeout_meaning) {
  add_without_json_to(app, timeout_meaning);
  app.add_flag("--json", is_json, "Print JSON: one document, or one object a line for what goes on");
}

void CommonOptions::add_without_json_to(CLI::App& app, const std::string& timeout_meaning) {
  app.add_option("--connect", connect,
                 "Where the daemon listens: an address or the path of a Unix socket; else $GEMINGA_CONNECT, else "
                 "127.0.0.1:4717 and then [::1]:4717")
      ->type_name("ADDRESS:PORT|PATH");
  add_seconds(app, "--timeout", timeout_seconds, timeout_meaning);
  app.set_version_flag("--version", app.get_name() + " " GEMINGA_VERSION, "Print the version and exit");
}

std::chrono::milliseconds CommonOptions::timeout_or(std::chrono::milliseconds usual) const {
  return timeout_seconds ? in_milliseconds(*timeout_seconds) : usual;
}

void IdentityOptions::add_to(CLI::App& app) {
  app.add_option("--id", id, "The identity is this 32-bit number, decimal or 0x")->type_name("N");
  app.add_option("--text", text, "The identity is this text")->type_name("NAME");
  app.add_option("--representation", representation, "The representation of the concept")->type_name("R");
}

bool IdentityOptions::takes(const std::string& word) {
  const auto pair = key_and_value(word);
  if (!pair) return false;
  const auto& [key, value] = *pair;
  const bool is_id = key == "id";
  const bool is_text = key == "text";
  if (!is_id && !is_text && key != "representation") return false;
  if (value.empty()) throw CLI::ValidationError(key + '=', std::string(nothing_behind));
  if (is_id ? id.has_value() : is_text ? text.has_value() : !representation.empty()) {
    throw CLI::ValidationError("--" + key, "is given twice: give it once");
  }
  if (is_id) {
    id = value;
  } else if (is_text) {
    text = value;
  } else {
    representation = value;
  }
  return true;
}

std::optional<std::pair<std::string, std::string>> key_and_value(const std::string& word) {
  const auto equals = word.find('=');
  if (equals == 0 || equals == std::string::npos) return std::nullopt;
  const auto is_of_a_key = [](char c) {
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '.' ||
           c == '-';
  };
  if (!std::all_of(word.begin(), word.begin() + static_cast<std::ptrdiff_t>(equals), is_of_a_key)) return std::nullopt;
  return std::pair{word.substr(0, equals), word.substr(equals + 1)};
}

std::optional<NamedIdentity> IdentityOptions::identity(const std::string& concept_name) const {
  if ((id ? 1 : 0) + (text ? 1 : 0) + (concept_name.empty() ? 0 : 1) > 1) {
    throw CLI::ValidationError("IDENTITY", "is stated twice: give one of --id, --text and a concept");
  }
  if (concept_name.empty() && !representation.empty()) {
    throw CLI::ValidationError("--representation", "belongs to a concept: name the concept, too");
  }
  if (id) {
    const auto value = base::parse_id32(*id);
    if (!value) throw CLI::ValidationError("--id", "must be a number from 0 to 4294967295, decimal or 0x");
    return NumericIdentity{*value};
  }
  if (text) return TextIdentity{*text};
  if (!concept_name.empty()) return ConceptNames{concept_name, representation};
  return std::nullopt;
}

std::function<std::string(const std::string&)> whole_number(std::int64_t least, std::int64_t most) {
  return [least, most](const std::string& text) -> std::string {
    std::int64_t number = 0;
    if (CLI::detail::lexical_cast(text, number) && number >= least && number <= most) return {};
    return "must be a whole number from " + std::to_string(least) + " to " + std::to_string(most);
  };
}

CLI::Option* add_seconds(CLI::App& app, const std::string& flag, std::optional<double>& seconds,
                         const std::string& meaning) {
  return app.add_option(flag, seconds, meaning)->type_name("SECONDS")->check(complaint_about_seconds, "", "");
}

std::chrono::milliseconds in_milliseconds(double seconds) {
  return std::chrono::ceil<std::chrono::milliseconds>(std::chrono::duration<double>(seconds));
}

void add_mode(CLI::App& app, std::optional<ChannelMode>& mode, const std::string& meaning) {
  app.add_option_function<std::string>(
         "--mode",
         [&mode](const std::string& word) {
           mode = channel_mode(word);
           if (!mode) throw CLI::ValidationError("--mode", "must be oto, otm/stream or otm/pubsub");
         },
         meaning)
      ->type_name("oto|otm/stream|otm/pubsub");
}

void add_degree(CLI::App& app, Degree& degree) {
  app.add_option_function<std::string>(
         "--degree",
         [&degree](const std::string& word) {
           const auto value = geminga::degree(word);
           if (!value || *value == Degree::converted)
             throw CLI::ValidationError("--degree", "must be exact, equivalent, narrower, broader or overlapping");
           degree = *value;
         },
         "The weakest degree of match that counts (default: narrower)")
      ->type_name("exact|equivalent|narrower|broader|overlapping");
}

namespace {

/// The name of a variable that may mean GEMINGA_CONNECT, the only one that the programs read; empty where there is
/// none.
/// `--exec` sets GEMINGA_CONVERT.
std::string mistyped_variable() {
  constexpr std::string_view known = "GEMINGA_CONNECT";
  for (char** variable = environ; variable != nullptr && *variable != nullptr; ++variable) {
    const std::string_view name = std::string_view(*variable).substr(0, std::string_view(*variable).find('='));
    if (name != known && name.starts_with("GEMINGA_") && base::edit_distance(name, known, 1) <= 1)
      return std::string(name);
  }
  return {};
}

}  // namespace

std::optional<ExitStatus> parse(CLI::App& app, int argc, char** argv) {
  if (const auto description = manual::described(app, argc, argv)) {
    std::cout << *description;
    return written(app.get_name(), ExitStatus::found);
  }
  try {
    app.parse(argc, argv);
    const std::string variable = mistyped_variable();
    const auto empty = manual::empty_text(app);
    if (variable.empty() && !empty) return std::nullopt;
    complain(app.get_name(), empty ? *empty : variable + ": unknown: did you mean GEMINGA_CONNECT?");
    return ExitStatus::wrong_use;
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) {
      app.exit(error, std::cout, std::cerr);  // --help and --version
      return ExitStatus::found;
    }
    complain(app.get_name(), manual::mistake(app, error));
    return ExitStatus::wrong_use;
  }
}

}  // namespace geminga::shell
