// From an event to its statement. reply.cpp has the way back.
#include "discovery/gcnp/event.hpp"

#include <array>
#include <utility>

#include "discovery/gcnp/attribute.hpp"
#include "discovery/gcnp/parameters.hpp"
#include "discovery/gcnp/way.hpp"

namespace geminga {
namespace {

constexpr std::array<std::pair<Change, std::string_view>, 3> changes{
    {{Change::add, "add"}, {Change::modify, "modify"}, {Change::del, "del"}}};

}  // namespace

std::string_view to_string(Change change) { return changes[static_cast<std::size_t>(change)].second; }

std::optional<Change> change(std::string_view word) {
  for (const auto& [value, name] : changes) {
    if (name == word) return value;
  }
  return std::nullopt;
}

}  // namespace geminga

namespace geminga::gcnp {
namespace {

template <typename Event>
void append_match(std::vector<Parameter>& parameters, const Event& event, ChannelMode mode) {
  append(parameters, "degree", std::string(to_string(event.degree)));
  append(parameters, "distance", event.distance);
  append(parameters, "mode", std::string(to_string(mode)));
}

}  // namespace

Statement to_statement(std::uint32_t request, const ServiceEvent& event) {
  Statement statement{request, "pub", std::string(to_string(event.change)), {}};
  auto& parameters = statement.parameters;
  append(parameters, "service", to_string(event.service));
  if (event.change == Change::del) {
    append(parameters, "reason", event.reason);
    return statement;
  }
  const NamedPublication& publication = event.publication;
  append(parameters, "provider", peer_word(event.service));
  append_stated(parameters, "name", event.peer_name);
  append_identity(parameters, publication.identity);
  append_match(parameters, event, publication.mode);
  append_stated(parameters, "address", publication.address);
  append(parameters, "port", publication.port);
  append(parameters, "protocol", publication.protocol);
  append(parameters, "priority", publication.priority);
  append_stated(parameters, "participant_name", event.participant_name);
  append_attributes(parameters, event.convert, event.cost, event.via, publication.attributes);
  append_way(parameters, {.hops = event.hops, .path = event.path, .is_reachable = event.reachable});
  return statement;
}

Statement to_statement(std::uint32_t request, const ConsumerEvent& event) {
  Statement statement{request, "sub", std::string(to_string(event.change)), {}};
  auto& parameters = statement.parameters;
  append(parameters, "subscription", to_string(event.subscription));
  if (event.change == Change::del) {
    append(parameters, "reason", event.reason);
    return statement;
  }
  const NamedSubscription& subscribed = event.subscribed;
  append(parameters, "consumer", peer_word(event.subscription));
  append_stated(parameters, "name", event.peer_name);
  append_identity(parameters, subscribed.identity);
  append_match(parameters, event, subscribed.mode);
  append_stated(parameters, "address", subscribed.address);
  if (subscribed.port != 0) append(parameters, "port", subscribed.port);
  append(parameters, "priority", subscribed.priority);
  append_stated(parameters, "participant_name", event.participant_name);
  append_attributes(parameters, subscribed.attributes);
  append_way(parameters, {.hops = event.hops, .path = event.path, .is_reachable = event.reachable});
  return statement;
}

void append_identity(std::vector<Parameter>& parameters, const NamedIdentity& identity) {
  if (const auto* number = std::get_if<NumericIdentity>(&identity)) {
    append(parameters, "id", number->number);
  } else if (const auto* name = std::get_if<TextIdentity>(&identity)) {
    append(parameters, "text", name->text);
  } else {
    const auto& names = std::get<ConceptNames>(identity);
    append(parameters, "concept", names.concept_name);
    append_stated(parameters, "representation", names.representation_name);
  }
}

void append_attributes(std::vector<Parameter>& parameters, const Attributes& attributes) {
  for (const auto& [name, value] : attributes) append(parameters, shown_key(name), value);
}

void append_attributes(std::vector<Parameter>& parameters, const std::string& convert, std::uint32_t cost,
                       const std::string& via, const Attributes& attributes) {
  if (convert.empty()) {
    append_attributes(parameters, attributes);
    return;
  }
  append(parameters, "convert", convert);
  append(parameters, cost_key, cost);
  append_stated(parameters, via_key, via);
  // `cost` and `via` are no reserved words, but beside a conversion a reader takes them for keys.
  for (const auto& [name, value] : attributes) {
    const bool is_key = name == cost_key || name == via_key;
    append(parameters, is_key ? std::string(attribute_prefix) + name : shown_key(name), value);
  }
}

}  // namespace geminga::gcnp
