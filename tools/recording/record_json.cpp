#include "recording/record_json.hpp"

#include <array>
#include <boost/json/array.hpp>
#include <boost/json/value.hpp>
#include <charconv>
#include <cmath>
#include <optional>

#include "base/text.hpp"
#include "discovery/gcnp/attribute.hpp"

namespace geminga::recording {
namespace {

namespace json = boost::json;

std::optional<std::string> text_of(double number) {
  if (!std::isfinite(number) || std::abs(number) >= 1e15) return std::nullopt;
  std::array<char, 64> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), number, std::chars_format::fixed, 3);
  if (end.ec != std::errc()) return std::nullopt;
  return std::string(text.data(), end.ptr);
}

std::optional<std::string> text_of(const json::value& value);

std::optional<std::string> text_of(const json::array& list) {
  std::string text;
  for (const json::value& word : list) {
    if (!word.is_string()) return std::nullopt;
    if (&word != list.data()) text += ',';
    text += std::string_view(word.get_string());
  }
  return text;
}

/// The value as the daemon says it; nothing for one that it never says.
std::optional<std::string> text_of(const json::value& value) {
  if (const auto* text = value.if_string()) return std::string(std::string_view(*text));
  if (const auto* number = value.if_int64()) return std::to_string(*number);
  if (const auto* number = value.if_uint64()) return std::to_string(*number);
  if (const auto* number = value.if_double()) return text_of(*number);
  if (const auto* flag = value.if_bool()) return *flag ? "1" : "0";
  if (const auto* list = value.if_array()) return text_of(*list);
  return std::nullopt;
}

/// The most octets of a parameter in a line, where each octet of the value may need an escape.
std::size_t most_octets(std::string_view key, std::string_view value) { return key.size() + 2 * value.size() + 16; }

}  // namespace

std::expected<Record, std::string> record_of(std::string_view kind, const json::object& object) {
  Record record{std::string(kind), {}, {}};
  std::size_t octets = 64;  // id, command and kind
  const auto take = [&](std::string_view key, const json::value& value) -> std::expected<std::string, std::string> {
    if (!base::is_key(key)) return std::unexpected("'" + base::printable(key) + "' is no key");
    auto text = text_of(value);
    if (!text) return std::unexpected("the value of '" + base::printable(key) + "' is no text, number, flag or list");
    octets += most_octets(key, *text);
    return std::move(*text);
  };
  for (const auto& [key, value] : object) {
    if (const auto* attributes = value.if_object(); attributes != nullptr && key == "attributes") {
      for (const auto& [name, attribute] : *attributes) {
        auto text = take(name, attribute);
        if (!text) return std::unexpected(std::move(text.error()));
        record.attributes.emplace(std::string_view(name), std::move(*text));
      }
      continue;
    }
    auto text = take(key, value);
    if (!text) return std::unexpected(std::move(text.error()));
    record.fields.emplace_back(std::string_view(key), std::move(*text));
  }
  if (octets > gcnp::max_line_bytes || record.fields.size() + record.attributes.size() > gcnp::max_parameters) {
    return std::unexpected("a record is longer than a line of GCNP");
  }
  return record;
}

gcnp::Statement statement_of(std::uint32_t id, const Record& record) {
  gcnp::Statement statement{id, "msg", record.kind, {}};
  for (const auto& [key, value] : record.fields) statement.parameters.push_back({key, value});
  for (const auto& [name, value] : record.attributes) statement.parameters.push_back({gcnp::shown_key(name), value});
  return statement;
}

}  // namespace geminga::recording
