#include "shell/changes.hpp"

#include <boost/json/serialize.hpp>

namespace geminga::shell {

namespace json = boost::json;

json::object former(const json::object& before, const json::object& now) {
  json::object changed;
  for (const auto& [key, value] : before) {
    const json::value* other = now.if_contains(key);
    if (other != nullptr && value.is_object() && other->is_object()) {
      auto inner = former(value.as_object(), other->as_object());
      if (!inner.empty()) changed[key] = std::move(inner);
    } else if (other == nullptr || value != *other) {
      changed[key] = value;
    }
  }
  for (const auto& member : now) {
    if (!before.contains(member.key())) changed[member.key()] = nullptr;
  }
  return changed;
}

std::string words_of(const json::object& former) {
  std::string words;
  for (const auto& [key, value] : former) {
    if (!words.empty()) words += ", ";
    if (const auto* inner = value.if_object()) {
      words += words_of(*inner);
      continue;
    }
    words += std::string(key) + " was ";
    if (value.is_null() || (value.is_string() && value.as_string().empty())) {
      words += "absent";
    } else {
      words += value.is_string() ? std::string(value.as_string()) : json::serialize(value);
    }
  }
  return words;
}

}  // namespace geminga::shell
