#include "daemon/configuration/layer.hpp"

#include <algorithm>

#include "base/edit_distance.hpp"
#include "base/text.hpp"

namespace geminga::daemon {
namespace {

constexpr std::string_view variable_prefix = "GEMINGA_";
/// Variables of the other programs and of the tests.
constexpr std::array<std::string_view, 3> other_variables{"GEMINGA_CONNECT", "GEMINGA_SEED", "GEMINGA_TEST_DATA"};

/// GEMINGA_LOG_LEVEL for log-level.
std::string variable_of(std::string_view key) {
  std::string name(variable_prefix);
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

std::vector<std::string> mistyped_variables(const char* const* environment) {
  std::vector<std::string> lines;
  for (const char* const* entry = environment; *entry != nullptr; ++entry) {
    const std::string_view assignment(*entry);
    const std::string_view name = assignment.substr(0, assignment.find('='));
    if (!name.starts_with(variable_prefix) || std::ranges::find(other_variables, name) != other_variables.end())
      continue;
    const std::string_view rest = name.substr(variable_prefix.size());
    const std::size_t limit = base::tolerated_slips(rest);
    const auto distance = [&](const Key& key) {
      return base::edit_distance(rest, std::string_view(variable_of(key.name)).substr(variable_prefix.size()), limit);
    };
    const auto* const nearest = std::ranges::min_element(keys, {}, distance);
    if (variable_of(nearest->name) == name || distance(*nearest) > limit) continue;
    lines.push_back(base::printable(name) + ": unknown: did you mean " + variable_of(nearest->name) + '?');
  }
  return lines;
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
