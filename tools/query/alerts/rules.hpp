// The rules of alerts: what should hold in the team, read from a file in TOML.
#ifndef GEMINGA_QUERY_ALERTS_RULES_HPP
#define GEMINGA_QUERY_ALERTS_RULES_HPP

#include <cstddef>
#include <cstdint>
#include <expected>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/time.hpp"

namespace geminga::query::alerts {

/// The most rules of a file, the octets of a rule's name, the octets of the file, and the longest time of a rule.
inline constexpr std::size_t max_rules = 256;
inline constexpr std::size_t max_rule_name_bytes = 64;
inline constexpr std::size_t max_rules_file_bytes = std::size_t{256} * 1024;
inline constexpr base::Duration max_rule_time = std::chrono::hours(24);

/// A question to the daemon; the records of its answer are counted.
struct Question {
  std::string kind;  ///< `match` or `participants` of GCNP
  std::vector<std::pair<std::string, std::string>> parameters;
  friend bool operator==(const Question&, const Question&) = default;
};

struct Rule {
  std::string name;
  Question question;
  std::uint64_t at_least = 0;
  std::optional<std::uint64_t> at_most;  ///< nothing: however many
  base::Duration time{};                 ///< how long the count must be wrong before it is told
  std::string origin;                    ///< `alerts.toml:3`

  [[nodiscard]] bool holds(std::uint64_t count) const { return count >= at_least && (!at_most || count <= *at_most); }
};

/// The count that a rule asks for, in words: `at least 2`, `at most 1`, `2 to 4`, `none`.
[[nodiscard]] std::string wanted_words(const Rule& rule);
/// The things that it counts, in words: `canSee some Ball`, `soccer:BallInfo where rate >= 10`.
[[nodiscard]] std::string counted_words(const Rule& rule);

/// Reads the text of a file that is called `path`. The errors are lines `path:line: what is wrong: what to do`.
[[nodiscard]] std::expected<std::vector<Rule>, std::vector<std::string>> read_rules(std::string_view text,
                                                                                    const std::string& path);
/// Reads a file of rules.
[[nodiscard]] std::expected<std::vector<Rule>, std::vector<std::string>> read_rules_file(const std::string& path);

}  // namespace geminga::query::alerts

#endif
