#include "shell/json.hpp"

#include <utf8.h>

#include <algorithm>
#include <array>
#include <boost/json/serialize.hpp>
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <iterator>
#include <optional>
#include <string>

#include "base/harmless.hpp"
#include "base/text.hpp"
#include "shell/terminal.hpp"
#include "shell/timestamp.hpp"

namespace geminga::shell {
namespace {

namespace json = boost::json;

constexpr auto number_keys = std::to_array<std::string_view>(
    {"id",         "port", "priority",   "distance", "age",           "heard",
     "interval",   "loss", "loss_least", "limit",    "publications",  "subscriptions",
     "statements", "line", "classes",    "count",    "left_out",      "sent",
     "received",   "peer", "datagrams",  "offers",   "matching",      "requests",
     "taken",      "cost", "children",   "total",    "missing_count", "contradicting_count",
     "uncompared", "hops"});
constexpr auto flag_keys = std::to_array<std::string_view>(
    {"self", "local", "used", "served", "ok", "loaded", "matches", "subsumed", "unsatisfiable"});
/// Lists whose elements are lines.
constexpr auto line_keys = std::to_array<std::string_view>({"missing", "contradicting", "ways"});
constexpr auto list_keys = std::to_array<std::string_view>(
    {"addresses", "keys", "lacks", "equivalents", "parents", "quarter", "half", "whole", "longer"});

template <typename Keys>
bool contains(const Keys& keys, std::string_view key) {
  return std::ranges::find(keys, key) != keys.end();
}

/// The keys of a status whose values are no measures.
constexpr auto words_of_status =
    std::to_array<std::string_view>({"version", "state", "participant", "name", "group", "ontology"});

/// The decimal number that the whole text is, or nothing.
std::optional<json::value> as_number(std::string_view text) {
  if (const auto integer = base::parse_number<std::int64_t>(text)) return json::value(*integer);
  if (text.find_first_not_of("0123456789.-") != std::string_view::npos) return std::nullopt;
  double real = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), real);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return json::value(real);
}

bool is_measure(std::string_view key, std::string_view kind) {
  if (kind == "status") return !contains(words_of_status, key);
  // The id of a participant is a word of hexadecimal digits, even if all of them are decimal ones.
  return contains(number_keys, key) && !(kind == "participants" && key == "id");
}

json::value typed(std::string_view key, std::string_view text, std::string_view kind) {
  if (key == "reachable") return text != "no";
  if (is_measure(key, kind)) {
    if (auto value = as_number(text)) return *value;
  }
  if (contains(flag_keys, key) && (text == "0" || text == "1")) return text == "1";
  const bool has_lines = contains(line_keys, key);
  if (!has_lines && !contains(list_keys, key)) return json::string(text);
  json::array list;
  while (!text.empty()) {
    const auto comma = std::min(text.find(has_lines ? '\n' : ','), text.size());
    list.emplace_back(text.substr(0, comma));
    text.remove_prefix(std::min(comma + 1, text.size()));
  }
  return list;
}

json::object to_object(const Attributes& attributes) {
  json::object object;
  for (const auto& [key, value] : attributes) object[key] = value;
  return object;
}

void append_identity(json::object& object, const NamedIdentity& identity) {
  if (const auto* number_identity = std::get_if<NumericIdentity>(&identity)) {
    object["id"] = number_identity->number;
  } else if (const auto* text = std::get_if<TextIdentity>(&identity)) {
    object["text"] = text->text;
  } else {
    const auto& names = std::get<ConceptNames>(identity);
    object["concept"] = names.concept_name;
    if (!names.representation_name.empty()) object["representation"] = names.representation_name;
  }
}

/// Appends the fields of both kinds of events. `role` is that of the other side: provider or consumer.
template <typename Event, typename Service>
void append_common(json::object& object, const Event& event, const ServiceKey& key, std::string_view role,
                   const Service& service) {
  if (event.change == Change::del) {
    object["reason"] = event.reason;
    return;
  }
  object[role] = peer_word(key);
  object["name"] = event.peer_name;
  object["participant_name"] = event.participant_name;
  append_identity(object, service.identity);
  object["degree"] = to_string(event.degree);
  object["distance"] = event.distance;
  object["mode"] = to_string(service.mode);
  if (!service.address.empty()) object["address"] = service.address;
  if (service.port != 0) object["port"] = service.port;
}

/// Appends the way to the other side's host, as far as there is something to say.
template <typename Event>
void append_way(json::object& object, const Event& event) {
  if (event.hops != 0) {
    object["hops"] = event.hops;
    object["path"] = event.path;
  }
  if (!event.reachable) object["reachable"] = false;
}

}  // namespace

json::object to_json(const Record& record) {
  json::object object;
  for (const auto& [key, value] : record.fields) object[key] = typed(key, value, record.kind);
  const bool is_service = object.contains("service") || object.contains("subscription");
  if (is_service && (record.kind == "services" || record.kind == "requests" || record.kind == "match")) {
    object["attributes"] = to_object(record.attributes);
  }
  // Of a description, which not every participant has.
  if (record.kind == "participants" && !record.attributes.empty()) object["attributes"] = to_object(record.attributes);
  return object;
}

json::array to_json(const std::vector<Record>& records) {
  json::array array;
  for (const auto& record : records) array.push_back(to_json(record));
  return array;
}

json::object to_json(const ServiceEvent& event) {
  json::object object;
  object["event"] = to_string(event.change);
  object["service"] = to_string(event.service);
  append_common(object, event, event.service, "provider", event.publication);
  if (event.change == Change::del) return object;
  object["protocol"] = event.publication.protocol;
  object["priority"] = event.publication.priority;
  if (!event.convert.empty()) {
    object["convert"] = event.convert;
    object["cost"] = event.cost;
    if (!event.via.empty()) object["via"] = event.via;
  }
  append_way(object, event);
  object["attributes"] = to_object(event.publication.attributes);
  return object;
}

json::object to_json(const ConsumerEvent& event) {
  json::object object;
  object["event"] = to_string(event.change);
  object["subscription"] = to_string(event.subscription);
  append_common(object, event, event.subscription, "consumer", event.subscribed);
  if (event.change == Change::del) return object;
  object["priority"] = event.subscribed.priority;
  append_way(object, event);
  object["attributes"] = to_object(event.subscribed.attributes);
  return object;
}

json::object stamped(const json::object& event) {
  json::object object;
  for (const auto& member : event) {
    object.insert(member);
    if (object.size() == 1) object["time"] = timestamp();
  }
  return object;
}

namespace {

/// A string in JSON. Boost.JSON escapes the characters that RFC 8259 names (C0); harmless_json() escapes all others
/// that a terminal could obey, too.
std::string quoted(const json::string& text) {
  std::string valid;
  utf8::replace_invalid(text.begin(), text.end(), std::back_inserter(valid));
  return base::harmless_json(json::serialize(json::string(valid)));
}

/// Writes 0.25 as such; Boost.JSON would write 2.5E-1.
std::string plain(double number) {
  std::array<char, 400> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), number, std::chars_format::fixed);
  return end.ec == std::errc() ? std::string(text.data(), end.ptr) : "null";
}

void append(std::string& out, const json::value& value) {
  if (const auto* object = value.if_object()) {
    const char* separator = "{";
    for (const auto& [key, member] : *object) {
      out += separator + quoted(json::string(key)) + ':';
      append(out, member);
      separator = ",";
    }
    out += object->empty() ? "{}" : "}";
  } else if (const auto* array = value.if_array()) {
    const char* separator = "[";
    for (const auto& element : *array) {
      out += separator;
      append(out, element);
      separator = ",";
    }
    out += array->empty() ? "[]" : "]";
  } else if (const auto* text = value.if_string()) {
    out += quoted(*text);
  } else if (const auto* real = value.if_double()) {
    out += plain(*real);
  } else {
    out += json::serialize(value);
  }
}

}  // namespace

void print(std::ostream& out, const json::value& document) {
  std::string line;
  append(line, document);
  out << line << '\n' << std::flush;
}

}  // namespace geminga::shell
