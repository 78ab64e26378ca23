#include "shell/event_variables.hpp"

#include <unistd.h>

#include <algorithm>
#include <boost/json/serialize.hpp>
#include <optional>

namespace geminga::shell {
namespace {

namespace json = boost::json;

constexpr std::string_view prefix = "GEMINGA_";
constexpr std::string_view attribute_infix = "ATTRIBUTE_";
constexpr std::string_view connect_variable = "GEMINGA_CONNECT=";

bool may_be_in_a_name(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
}

char in_upper_case(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

/// The text of a value; nothing where a variable cannot hold it, as an object or a list.
std::optional<std::string> text_of(const json::value& value) {
  if (value.is_number() || value.is_bool()) return json::serialize(value);
  if (!value.is_string()) return std::nullopt;
  std::string text(value.as_string());
  if (text.contains('\0')) return std::nullopt;
  return text;
}

}  // namespace

std::vector<std::string> event_variables(const json::object& event) {
  std::vector<std::string> variables;
  const auto add = [&](const std::string& name, const json::value& value) {
    if (!std::ranges::all_of(name, may_be_in_a_name)) return;
    if (const auto text = text_of(value)) variables.push_back(std::string(prefix) + name + '=' + *text);
  };
  for (const auto& [key, value] : event) {
    if (key == "attributes" && value.is_object()) {
      for (const auto& [name, attribute] : value.as_object()) {
        add(std::string(attribute_infix) + std::string(name), attribute);
      }
      continue;
    }
    std::string name(key);
    std::ranges::transform(name, name.begin(), in_upper_case);
    add(name, value);
  }
  return variables;
}

std::vector<std::string> environment_with(const std::vector<std::string>& variables, const std::string& connect) {
  std::vector<std::string> environment;
  for (char** variable = environ; variable != nullptr && *variable != nullptr; ++variable) {
    const std::string_view text(*variable);
    const bool is_connect = connect.empty() && text.starts_with(connect_variable);
    if (is_connect || !text.starts_with(prefix)) environment.emplace_back(text);
  }
  if (!connect.empty()) environment.push_back(std::string(connect_variable) + connect);
  environment.insert(environment.end(), variables.begin(), variables.end());
  return environment;
}

}  // namespace geminga::shell
