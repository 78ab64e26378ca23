#include "query/mcp/tools.hpp"

#include <algorithm>
#include <cstddef>
#include <sstream>
#include <utility>

#include "query/mcp/limits.hpp"
#include "shell/json.hpp"

namespace geminga::query::mcp {
namespace {

namespace json = boost::json;

json::object schema_of(const answers::Key& key) {
  switch (key.type) {
    case answers::Key::Type::number:
      return {{"type", json::array{"integer", "string"}}, {"description", key.meaning}};
    case answers::Key::Type::flag:
      return {{"type", "boolean"}, {"description", key.meaning}};
    case answers::Key::Type::text:
      break;
  }
  return {{"type", "string"}, {"description", key.meaning}};
}

json::object schema_of(const answers::Kind& kind) {
  json::object properties;
  for (const answers::Key& key : kind.keys) properties[key.name] = schema_of(key);
  json::object schema{{"type", "object"}, {"properties", std::move(properties)}, {"additionalProperties", false}};
  if (kind.takes_attributes) {
    schema["patternProperties"] = {
        {"^(offer\\.)?attr\\.[A-Za-z0-9_.-]+$",
         {{"type", "string"},
          {"description", "The value of an attribute of the request, or of what might be offered"}}}};
  }
  return schema;
}

json::object result_of(std::string text, bool is_error) {
  return {{"content", json::array{json::object{{"type", "text"}, {"text", std::move(text)}}}}, {"isError", is_error}};
}

std::string document_text(const json::value& document) {
  std::ostringstream out;
  shell::print(out, document);
  std::string text = std::move(out).str();
  if (text.ends_with('\n')) text.pop_back();
  return text;
}

bool has_control_character(std::string_view text) {
  return std::ranges::any_of(text, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; });
}

/// The value as GCNP writes it; empty for a flag that is not set. An error for a list, an object, null and a fraction.
std::expected<std::string, std::string> value_of(std::string_view key, const json::value& value) {
  if (const auto* text = value.if_string()) {
    if (!has_control_character(*text)) return std::string(*text);
    return std::unexpected(std::string(key) + " has a control character: leave it out");
  }
  if (const auto* flag = value.if_bool()) return *flag ? "1" : "";
  if (const auto* whole = value.if_int64()) return std::to_string(*whole);
  if (const auto* whole = value.if_uint64()) return std::to_string(*whole);
  return std::unexpected(std::string(key) + " is no text, whole number or flag: write it as a text");
}

std::expected<answers::Parameters, std::string> parameters_of(const json::object& arguments) {
  if (arguments.size() > max_arguments) {
    return std::unexpected("there are over " + std::to_string(max_arguments) + " arguments: name fewer");
  }
  answers::Parameters parameters;
  std::size_t octets = 0;
  for (const auto& argument : arguments) {
    const std::string key(argument.key());
    if (has_control_character(key)) return std::unexpected("the name of an argument has a control character");
    octets += key.size();
    if (octets > max_argument_octets) break;  // no value is read beyond the limit, and no long name comes back
    auto value = value_of(key, argument.value());
    if (!value) return std::unexpected(value.error());
    octets += value->size();
    if (argument.value().is_bool() && value->empty()) continue;
    parameters.emplace_back(key, std::move(*value));
  }
  if (octets > max_argument_octets) {
    return std::unexpected("the arguments have over " + std::to_string(max_argument_octets) + " octets: ask for less");
  }
  return parameters;
}

}  // namespace

json::array tools() {
  json::array list;
  for (const answers::Kind& kind : answers::kinds()) {
    list.push_back(json::object{{"name", kind.word},
                                {"description", kind.meaning},
                                {"inputSchema", schema_of(kind)},
                                {"annotations", {{"readOnlyHint", true}, {"openWorldHint", false}}}});
  }
  return list;
}

json::object call(const answers::Kind& kind, const json::object& arguments, const Ask& ask) {
  const auto parameters = parameters_of(arguments);
  if (!parameters) return result_of(parameters.error(), true);
  if (const auto checked = answers::check(kind, *parameters); !checked) return result_of(checked.error(), true);
  const auto answer = ask(std::string(kind.word), *parameters);
  if (!answer) return result_of(answer.error().text, true);
  std::string text = document_text(answers::document_of(kind.word, *parameters, *answer));
  if (text.size() > max_document_octets) {
    return result_of("the answer has " + std::to_string(text.size()) + " octets, over the limit of " +
                         std::to_string(max_document_octets) +
                         ": ask for less, as with concept, mode, provider, filter or limit",
                     true);
  }
  return result_of(std::move(text), false);
}

}  // namespace geminga::query::mcp
