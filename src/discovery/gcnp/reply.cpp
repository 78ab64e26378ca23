#include <algorithm>
#include <utility>

#include "base/text.hpp"
#include "discovery/gcnp/attribute.hpp"
#include "discovery/gcnp/event.hpp"
#include "discovery/gcnp/way.hpp"

namespace geminga::gcnp {
namespace {

/// Reads `N EEE text`, whose text is no parameters; nothing if the line is no error.
std::optional<Event> read_error(std::string_view line) {
  const auto id_end = line.find(' ');
  if (id_end == std::string_view::npos) return std::nullopt;
  const auto id = base::parse_number<std::uint32_t>(line.substr(0, id_end));
  const std::string_view rest = line.substr(id_end + 1);
  const std::string_view word = rest.substr(0, rest.find(' '));
  const auto code = base::parse_number<std::uint16_t>(word);
  if (!id || !code || word.size() != 3) return std::nullopt;
  const std::string_view text = rest.size() > 4 ? rest.substr(4) : "";
  return Event{*id, Error{static_cast<ErrorCode>(*code), base::printable(text, max_error_text_bytes)}};
}

Error no_event(std::string_view key) {
  return {ErrorCode::malformed, "the daemon sent an event whose " + std::string(key) + " cannot be read"};
}

NamedIdentity identity_of(const Statement& statement) {
  if (const auto id = statement.value("id")) return NumericIdentity{base::parse_id32(*id).value_or(0)};
  if (const auto name = statement.value("text")) return TextIdentity{std::string(*name)};
  return ConceptNames{std::string(statement.value("concept").value_or("")),
                      std::string(statement.value("representation").value_or(""))};
}

Attributes attributes_of(const Statement& statement) {
  Attributes attributes;
  const bool is_converted = statement.value("convert").has_value();
  const bool is_relayed = statement.value("hops").has_value();
  for (const auto& parameter : statement.parameters) {
    if (is_converted && (parameter.key == cost_key || parameter.key == via_key)) continue;
    if (is_relayed && parameter.key == path_key) continue;
    if (const auto name = shown_attribute(parameter.key)) attributes.emplace(*name, parameter.value.value_or(""));
  }
  return attributes;
}

template <typename Number>
Number number_of(const Statement& statement, std::string_view key) {
  return base::parse_number<Number>(statement.value(key).value_or("")).value_or(Number{});
}

/// Reads what pub and sub events have in common. `service` is the publication or subscription that the event tells of.
template <typename Event, typename Service>
std::optional<Error> fill(const Statement& statement, Event& event, Service& service) {
  if (event.change == Change::del) {
    event.reason = statement.value("reason").value_or("");
    return std::nullopt;
  }
  event.peer_name = statement.value("name").value_or("");
  event.participant_name = statement.value("participant_name").value_or("");
  event.distance = number_of<std::uint32_t>(statement, "distance");
  const auto degree = geminga::degree(statement.value("degree").value_or(""));
  if (!degree) return no_event("degree");
  event.degree = *degree;
  const auto mode = channel_mode(statement.value("mode").value_or(""));
  if (!mode) return no_event("mode");
  service.mode = *mode;
  service.identity = identity_of(statement);
  service.address = statement.value("address").value_or("");
  service.port = number_of<std::uint16_t>(statement, "port");
  service.priority = number_of<std::int32_t>(statement, "priority");
  service.attributes = attributes_of(statement);
  event.hops = number_of<std::uint32_t>(statement, "hops");
  if (event.hops != 0) event.path = statement.value(path_key).value_or("");
  event.reachable = statement.value("reachable").value_or("") != "no";
  return std::nullopt;
}

std::expected<Reply, Error> read_service_event(const Statement& statement, Change change) {
  ServiceEvent event;
  event.change = change;
  const auto service = service_key(statement.value("service").value_or(""));
  if (!service) return std::unexpected(no_event("service"));
  event.service = *service;
  if (auto error = fill(statement, event, event.publication)) return std::unexpected(std::move(*error));
  if (change != Change::del) {
    event.publication.protocol = statement.value("protocol").value_or("udp");
    event.convert = statement.value("convert").value_or("");
    if (!event.convert.empty()) {
      event.cost = number_of<std::uint32_t>(statement, cost_key);
      event.via = statement.value(via_key).value_or("");
    }
  }
  return Event{statement.id, std::move(event)};
}

std::expected<Reply, Error> read_consumer_event(const Statement& statement, Change change) {
  ConsumerEvent event;
  event.change = change;
  const auto subscription = service_key(statement.value("subscription").value_or(""));
  if (!subscription) return std::unexpected(no_event("subscription"));
  event.subscription = *subscription;
  if (auto error = fill(statement, event, event.subscribed)) return std::unexpected(std::move(*error));
  return Event{statement.id, std::move(event)};
}

}  // namespace

std::expected<Reply, Error> read_reply(std::string_view line) {
  if (auto error = read_error(line)) return std::move(*error);
  auto statement = parse(line);
  if (!statement) return std::unexpected(std::move(statement.error().error));
  const auto change = geminga::change(statement->subcommand);
  if (statement->command == "pub" && change) return read_service_event(*statement, *change);
  if (statement->command == "sub" && change) return read_consumer_event(*statement, *change);
  return std::move(*statement);
}

}  // namespace geminga::gcnp
