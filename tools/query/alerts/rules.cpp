#include "query/alerts/rules.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <system_error>

#include "base/edit_distance.hpp"
#include "base/text.hpp"
#include "base/utf8.hpp"

#define TOML_EXCEPTIONS 0
#define TOML_ENABLE_FORMATTERS 0
#include <toml++/toml.h>

namespace geminga::query::alerts {
namespace {

using Errors = std::vector<std::string>;

/// The keys of a rule that are passed on to the daemon as they stand, for services and for participants.
constexpr auto service_keys =
    std::to_array<std::string_view>({"concept", "text", "id", "representation", "mode", "degree", "where", "provider"});
constexpr auto participant_keys = std::to_array<std::string_view>({"participants", "degree", "where", "provider"});
constexpr auto other_keys = std::to_array<std::string_view>({"name", "at-least", "at-most", "for"});

std::string joined_keys() {
  std::string words;
  for (const auto key : other_keys) words += std::string(key) + ", ";
  for (const auto key : service_keys) words += std::string(key) + ", ";
  return words + "participants";
}

bool is_one_of(std::string_view key, auto keys) { return std::ranges::find(keys, key) != keys.end(); }

bool is_name(std::string_view name) {
  return !name.empty() && name.size() <= max_rule_name_bytes && base::is_valid_utf8(name) &&
         !base::has_control_character(name);
}

class RuleReader {
 public:
  explicit RuleReader(const std::string& path) : path_(path) {}

  std::expected<std::vector<Rule>, Errors> read(const toml::table& document) {
    for (const auto& [key, node] : document) {
      if (key.str() == "rule") continue;
      fail(key.source(), "unknown key '" + base::printable(key.str(), 60) + "': each rule is a table [[rule]]");
    }
    const toml::node* list = document.get("rule");
    const toml::array* rules = list == nullptr ? nullptr : list->as_array();
    if (list != nullptr && rules == nullptr) fail(list->source(), "rule must be a list: write [[rule]] before each");
    if (rules != nullptr) {
      for (const toml::node& node : *rules) take(node);
    }
    if (errors_.empty() && rules_.empty()) errors_.push_back(path_ + ":1: no rule: write [[rule]] before each");
    if (!errors_.empty()) return std::unexpected(std::move(errors_));
    return std::move(rules_);
  }

 private:
  void fail(const toml::source_region& at, const std::string& what) {
    errors_.push_back(path_ + ':' + std::to_string(at.begin.line) + ": " + what);
  }

  void take(const toml::node& node) {
    const toml::table* table = node.as_table();
    if (table == nullptr) return fail(node.source(), "a rule must be a table: write [[rule]] before it");
    if (rules_.size() == max_rules) {
      if (!is_full_) fail(node.source(), "more than " + std::to_string(max_rules) + " rules: leave some out");
      is_full_ = true;
      return;
    }
    Rule rule;
    rule.origin = path_ + ':' + std::to_string(node.source().begin.line);
    const bool is_of_participants = table->contains("participants");
    rule.question.kind = is_of_participants ? "participants" : "match";
    bool has_count = false;
    for (const auto& [key, value] : *table) {
      const std::string_view name = key.str();
      if (name == "name") {
        take_name(value, rule);
      } else if (name == "at-least" || name == "at-most") {
        has_count = true;
        take_count(name, value, rule);
      } else if (name == "for") {
        take_time(value, rule);
      } else if (is_of_participants ? is_one_of(name, participant_keys) : is_one_of(name, service_keys)) {
        take_word(name, value, rule);
      } else {
        refuse_key(key, is_of_participants);
      }
    }
    check(node, *table, rule, has_count);
    rules_.push_back(std::move(rule));
  }

  void take_name(const toml::node& value, Rule& rule) {
    const auto name = value.value_exact<std::string>();
    if (!name || !is_name(*name)) {
      return fail(value.source(), "name must be a text of 1 to " + std::to_string(max_rule_name_bytes) + " octets");
    }
    const auto same = std::ranges::find(rules_, *name, &Rule::name);
    if (same != rules_.end()) {
      fail(value.source(),
           "the name '" + base::printable(*name) + "' is that of " + same->origin + ", too: give each rule its own");
    }
    rule.name = *name;
  }

  void take_count(std::string_view key, const toml::node& value, Rule& rule) {
    const auto count = value.value_exact<std::int64_t>();
    if (!count || *count < 0) return fail(value.source(), std::string(key) + " must be a whole number from 0");
    if (key == "at-least") {
      rule.at_least = static_cast<std::uint64_t>(*count);
    } else {
      rule.at_most = static_cast<std::uint64_t>(*count);
    }
  }

  /// A number of seconds.
  void take_time(const toml::node& value, Rule& rule) {
    const auto whole = value.value_exact<std::int64_t>();
    const auto seconds = whole ? std::optional<double>(static_cast<double>(*whole)) : value.value_exact<double>();
    const double most = std::chrono::duration<double>(max_rule_time).count();
    if (!seconds || !std::isfinite(*seconds) || *seconds < 0 || *seconds > most)
      return fail(value.source(), "for must be a number of seconds from 0 to 86400: for = 3.0");
    rule.time = std::chrono::duration_cast<base::Duration>(std::chrono::duration<double>(*seconds));
  }

  void take_word(std::string_view key, const toml::node& value, Rule& rule) {
    auto text = value.value_exact<std::string>();
    const auto number = value.value_exact<std::int64_t>();
    if (!text && key == "id" && number) text = std::to_string(*number);
    if (!text || text->empty()) return fail(value.source(), std::string(key) + " must be a text in quotes");
    rule.question.parameters.emplace_back(key == "participants" ? "concept" : std::string(key), std::move(*text));
  }

  void refuse_key(const toml::key& key, bool is_of_participants) {
    const std::string_view name = key.str();
    if (is_of_participants && is_one_of(name, service_keys))
      return fail(key.source(),
                  std::string(name) + " is about services, and this rule counts participants: leave one out");
    std::string likely;
    for (const auto known :
         {std::span<const std::string_view>(other_keys), std::span<const std::string_view>(service_keys),
          std::span<const std::string_view>(participant_keys)}) {
      for (const std::string_view one : known) {
        if (base::edit_distance(name, one, 2) <= 2 && likely.empty())
          likely = "did you mean '" + std::string(one) + "'? ";
      }
    }
    fail(key.source(), "unknown key '" + base::printable(name, 60) + "': " + likely + "there are " + joined_keys());
  }

  void check(const toml::node& node, const toml::table& table, const Rule& rule, bool has_count) {
    if (!table.contains("name")) fail(node.source(), "the rule has no name: write name = \"...\"");
    const int identities = int{table.contains("concept")} + int{table.contains("text")} + int{table.contains("id")} +
                           int{table.contains("participants")};
    if (identities != 1) {
      fail(node.source(),
           "a rule counts one thing: write participants = \"EXPRESSION\", or concept, text or id of services");
    }
    if (!has_count) fail(node.source(), "the rule has no count: write at-least = 1, at-most, or both");
    if (rule.at_most && *rule.at_most < rule.at_least)
      fail(node.source(), "at-most is less than at-least: no count can hold");
    if (has_count && rule.at_least == 0 && !rule.at_most)
      fail(node.source(), "at-least = 0 always holds: write at-least = 1 or more, or at-most");
  }

  const std::string& path_;
  std::vector<Rule> rules_;
  Errors errors_;
  bool is_full_ = false;
};

}  // namespace

std::string wanted_words(const Rule& rule) {
  if (!rule.at_most) return "at least " + std::to_string(rule.at_least);
  if (*rule.at_most == 0) return "none";
  if (rule.at_least == 0) return "at most " + std::to_string(*rule.at_most);
  return std::to_string(rule.at_least) + " to " + std::to_string(*rule.at_most);
}

std::string counted_words(const Rule& rule) {
  std::string words;
  for (const auto& [key, value] : rule.question.parameters) {
    if (!words.empty()) words += ' ';
    words += key == "concept" ? value : key == "where" ? "where " + value : key + '=' + value;
  }
  return words;
}

std::expected<std::vector<Rule>, Errors> read_rules(std::string_view text, const std::string& path) {
  const toml::parse_result parsed = toml::parse(text, std::string_view(path));
  if (!parsed) {
    return std::unexpected(Errors{path + ':' + std::to_string(parsed.error().source().begin.line) + ": " +
                                  base::printable(parsed.error().description(), 300) + ": mend the TOML"});
  }
  return RuleReader(path).read(parsed.table());
}

std::expected<std::vector<Rule>, Errors> read_rules_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string text(max_rules_file_bytes + 1, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (file.bad() || (!file && file.gcount() == 0 && !file.eof()))
    return std::unexpected(Errors{path + ": cannot be read: name a file of rules"});
  text.resize(static_cast<std::size_t>(file.gcount()));
  if (text.size() > max_rules_file_bytes)
    return std::unexpected(Errors{path + ": longer than 256 KiB: leave rules out"});
  return read_rules(text, path);
}

}  // namespace geminga::query::alerts
