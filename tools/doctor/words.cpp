#include <cstdlib>

#include "doctor/checks.hpp"

namespace geminga::doctor {

double number(std::string_view text) { return std::strtod(std::string(text).c_str(), nullptr); }

std::vector<std::string> parts_of(std::string_view list) {
  std::vector<std::string> parts;
  while (!list.empty()) {
    const std::size_t comma = std::min(list.find(','), list.size());
    if (comma > 0) parts.emplace_back(list.substr(0, comma));
    list.remove_prefix(std::min(comma + 1, list.size()));
  }
  return parts;
}

std::string words_for_count(const Answers& answers, std::string_view key) {
  const std::string_view count = answers.status[key];
  const bool is_of_before = answers.earlier_status[key] == count && !answers.earlier_status.fields.empty();
  return "status: " + std::string(key) + '=' + std::string(count) +
         (is_of_before ? " since the daemon started, none of them just now" : "");
}

std::string words_for(const Record& participant, std::string_view id_key) {
  const std::string id(participant[id_key]);
  const std::string name(participant["name"]);
  return name.empty() ? id : name + " (" + id + ')';
}

}  // namespace geminga::doctor
