#include "query/filter.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace geminga::query {
namespace {

constexpr std::array<std::string_view, 6> keys_of_the_daemon{"concept", "representation", "id",
                                                             "text",    "mode",           "provider"};

bool is_key(std::string_view word) {
  return !word.empty() && std::ranges::all_of(word, [](char c) {
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '.' ||
           c == '-';
  });
}

bool has_text(const Record& record, const std::string& text) {
  const auto occurs = [&](const auto& pair) { return pair.second.contains(text); };
  return std::ranges::any_of(record.fields, occurs) || std::ranges::any_of(record.attributes, occurs);
}

bool has_value(const Record& record, const std::string& key, const std::string& value) {
  const auto attribute = record.attributes.find(key);
  return record[key] == value || (attribute != record.attributes.end() && attribute->second == value);
}

}  // namespace

Filter read_filter(const std::vector<std::string>& words) {
  Filter filter;
  std::vector<std::pair<std::string, std::string>> values;
  std::vector<std::string> texts;
  for (const auto& word : words) {
    const auto equals = word.find('=');
    const std::string key = word.substr(0, equals);
    if (equals == std::string::npos || !is_key(key)) {
      texts.push_back(word);
      continue;
    }
    const bool is_for_daemon = std::ranges::find(keys_of_the_daemon, key) != keys_of_the_daemon.end();
    (is_for_daemon ? filter.parameters : values).emplace_back(key, word.substr(equals + 1));
  }
  filter.keeps = [values = std::move(values), texts = std::move(texts)](const Record& record) {
    return std::ranges::all_of(texts, [&](const auto& text) { return has_text(record, text); }) &&
           std::ranges::all_of(values, [&](const auto& pair) { return has_value(record, pair.first, pair.second); });
  };
  return filter;
}

}  // namespace geminga::query
