#include "daemon/layer.hpp"

#include <algorithm>

namespace geminga::daemon {
namespace {

/// GEMINGA_LOG_LEVEL for log-level.
std::string variable_of(std::string_view key) {
  std::string name = "GEMINGA_";
  for (const char c : key) name += c == '-' ? '_' : static_cast<char>(c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c);
  return name;
}

std::vector<Stated> split(std::string_view text, const std::string& origin) {
  std::vector<Stated> values;
  while (!text.empty()) {
    const auto comma = std::min(text.find(','), text.size());
    if (comma > 0) values.push_back({std::string(text.substr(0, comma)), origin});
    text.remove_prefix(std::min(comma + 1, text.size()));
  }
  return values;
}

}  // namespace

const Key* find_key(std::string_view name) {
  const auto* const found = std::ranges::find(keys, name, &Key::name);
  return found == keys.end() ? nullptr : found;
}

Layer read_service(const char* const* environment) {
  Layer layer;
  constexpr std::string_view variable = "STATE_DIRECTORY";
  for (const char* const* entry = environment; *entry != nullptr; ++entry) {
    const std::string_view assignment(*entry);
    if (!assignment.starts_with(variable) || assignment.substr(variable.size(), 1) != "=") continue;
    const std::string_view folders = assignment.substr(variable.size() + 1);
    const std::string_view first = folders.substr(0, folders.find(':'));
    if (!first.empty()) layer.values["state-folder"] = {{std::string(first), std::string(variable)}};
    break;
  }
  return layer;
}

Layer read_environment(const char* const* environment) {
  Layer layer;
  for (const Key& key : keys) {
    const std::string variable = variable_of(key.name);
    for (const char* const* entry = environment; *entry != nullptr; ++entry) {
      const std::string_view assignment(*entry);
      if (!assignment.starts_with(variable) || assignment.substr(variable.size(), 1) != "=") continue;
      const std::string_view value = assignment.substr(variable.size() + 1);
      if (value.empty()) break;  // counts as unset
      auto& stated = layer.values[std::string(key.name)];
      if (key.type == ValueType::texts) {
        stated = split(value, variable);
      } else {
        stated = {{std::string(value), variable}};
      }
      break;
    }
  }
  return layer;
}

}  // namespace geminga::daemon
