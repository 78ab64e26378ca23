#include "query/filter.hpp"

#include <CLI/Error.hpp>
#include <algorithm>
#include <array>
#include <regex>

#include "geminga/attribute.hpp"
#include "shell/options.hpp"

namespace geminga::query {
namespace {

constexpr std::array<std::string_view, 6> keys_of_the_daemon{"concept", "representation", "id",
                                                             "text",    "mode",           "provider"};

/// The attribute of this name, also behind `attr.`.
Attributes::const_iterator attribute_of(const Record& record, const std::string& key) {
  return record.attributes.find(key.starts_with(attribute_prefix) ? key.substr(attribute_prefix.size()) : key);
}

bool has_key(const Record& record, const std::string& key) {
  return attribute_of(record, key) != record.attributes.end() ||
         std::ranges::any_of(record.fields, [&](const auto& field) { return field.first == key; });
}

bool has_value(const Record& record, const std::string& key, const std::string& value) {
  const auto attribute = attribute_of(record, key);
  return record[key] == value || (attribute != record.attributes.end() && attribute->second == value);
}

}  // namespace

bool Filter::keeps(const Record& record) const {
  return std::ranges::all_of(texts, [&](const auto& text) { return mentions(record, text); }) &&
         std::ranges::all_of(values, [&](const auto& pair) { return has_value(record, pair.first, pair.second); });
}

std::string Filter::unknown_key(const std::vector<Record>& records) const {
  const auto is_unknown = [&](const auto& pair) {
    return std::ranges::none_of(records, [&](const Record& record) { return has_key(record, pair.first); });
  };
  const auto found = std::ranges::find_if(values, is_unknown);
  return found == values.end() ? std::string() : found->first;
}

bool mentions(const Record& record, const std::string& text) {
  const auto occurs = [&](const auto& pair) { return pair.second.contains(text); };
  return std::ranges::any_of(record.fields, occurs) || std::ranges::any_of(record.attributes, occurs);
}

Filter read_filter(const std::vector<std::string>& words) {
  static const std::regex name(R"([A-Za-z_][\w.-]*:[A-Za-z_][\w.-]*|<[^<>]+>)");
  Filter filter;
  for (const auto& word : words) {
    if (auto pair = shell::key_and_value(word)) {
      const bool is_for_daemon = std::ranges::find(keys_of_the_daemon, pair->first) != keys_of_the_daemon.end();
      if (is_for_daemon && pair->second.empty()) throw CLI::ValidationError(word, std::string(shell::nothing_behind));
      (is_for_daemon ? filter.parameters : filter.values).push_back(std::move(*pair));
    } else {
      (std::regex_match(word, name) ? filter.names : filter.texts).push_back(word);
    }
  }
  return filter;
}

}  // namespace geminga::query
