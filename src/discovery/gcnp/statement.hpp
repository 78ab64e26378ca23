// One line of GCNP, read and written (src/discovery/gcnp/GCNP.md; paper section 3.2.1).
#ifndef GEMINGA_DISCOVERY_GCNP_STATEMENT_HPP
#define GEMINGA_DISCOVERY_GCNP_STATEMENT_HPP

#include <cstddef>
#include <cstdint>
#include <expected>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geminga/error.hpp"

namespace geminga::gcnp {

/// The longest line, its end not counted.
inline constexpr std::size_t max_line_bytes = 64 * 1024;
/// The most parameters of one statement.
inline constexpr std::size_t max_parameters = 256;
/// The longest text of an error. A longer one is cut and ends in `...`.
inline constexpr std::size_t max_error_text_bytes = 4096;

/// `key` or `key=value`. A key is one or more of `[A-Za-z0-9_.-]`.
struct Parameter {
  std::string key;
  std::optional<std::string> value;
  friend bool operator==(const Parameter&, const Parameter&) = default;
};

/// `<id> <command> <subcommand> [<key>[=<value>]]...`
struct Statement {
  std::uint32_t id = 0;
  std::string command;
  std::string subcommand;
  std::vector<Parameter> parameters;

  /// The value of the first parameter with this key; nothing if there is none or it has no value.
  [[nodiscard]] std::optional<std::string_view> value(std::string_view key) const;
  [[nodiscard]] bool has(std::string_view key) const;

  friend bool operator==(const Statement&, const Statement&) = default;
};

/// A line that is no statement: its id as far as it could be read, and what is wrong at which octet.
struct Malformed {
  std::uint32_t id = 0;  ///< 0: not even the id could be read
  Error error;
  friend bool operator==(const Malformed&, const Malformed&) = default;
};

/// Reads one line without its end. Linear in its length; allocates nothing that the line does not contain.
[[nodiscard]] std::expected<Statement, Malformed> parse(std::string_view line);

/// The answer to a line over max_line_bytes.
[[nodiscard]] Error line_too_long();

/// Writes a statement with CR LF. A value is bare if it can be, and quoted otherwise. parse() of the line gives an
/// equal statement, except that octets that no value can hold (bad UTF-8, control characters without an escape) are
/// replaced. Requires that command, subcommand and keys are words.
[[nodiscard]] std::string to_line(const Statement& statement);

/// Writes `<id> <code> <text>` with CR LF.
[[nodiscard]] std::string to_line(std::uint32_t id, const Error& error);

}  // namespace geminga::gcnp

#endif
