// From a request to its statement, as a client sends it. Defaults are left out.
#include <utility>

#include "base/text.hpp"
#include "discovery/gcnp/attribute.hpp"
#include "discovery/gcnp/event.hpp"
#include "discovery/gcnp/parameters.hpp"
#include "discovery/gcnp/request.hpp"

namespace geminga::gcnp {
namespace {

using Parameters = std::vector<Parameter>;

void append_change(Parameters& parameters, const IdentityChange& change) {
  if (const auto* number = std::get_if<NumericIdentity>(&change)) {
    append(parameters, "id", number->number);
  } else if (const auto* name = std::get_if<TextIdentity>(&change)) {
    append(parameters, "text", name->text);
  } else {
    const auto& names = std::get<ConceptChange>(change);
    if (names.concept_name) append(parameters, "concept", *names.concept_name);
    if (names.representation_name) append(parameters, "representation", *names.representation_name);
  }
}

/// Attributes as a client states them, which must not be taken for mistyped keys.
void append_own_attributes(Parameters& parameters, const Attributes& attributes) {
  for (const auto& [name, value] : attributes) append(parameters, stated_key(name), value);
}

void append_filter(Parameters& parameters, const ListFilter& filter) {
  if (filter.identity) append_identity(parameters, *filter.identity);
  if (filter.mode) append(parameters, "mode", std::string(to_string(*filter.mode)));
  append_stated(parameters, "provider", provider_list(filter.providers));
  append_stated(parameters, "filter", filter.text);
  if (filter.with_iris) append(parameters, "iris", "1");
}

template <typename Change>
void append_common_change(Parameters& parameters, const Change& change) {
  if (change.identity) append_change(parameters, *change.identity);
  if (change.mode) append(parameters, "mode", std::string(to_string(*change.mode)));
  if (change.address) append(parameters, "address", *change.address);
  if (change.port) append(parameters, "port", *change.port);
  if (change.priority) append(parameters, "priority", *change.priority);
}

void append_wishes(Parameters& parameters, const NamedSubscription& subscription) {
  if (subscription.weakest != Degree::narrower) {
    append(parameters, "match", std::string(to_string(subscription.weakest)));
  }
  append_stated(parameters, "provider", provider_list(subscription.providers));
  append_stated(parameters, "where", subscription.where);
  append_stated(parameters, "protocol", protocol_list(subscription.protocols));
  append_stated(parameters, "favour", provider_list(subscription.favoured));
  append_stated(parameters, "prefer", subscription.prefer);
  append_stated(parameters, "rank", subscription.rank);
  append_stated(parameters, "scope", subscription.scope);
  if (subscription.convert != 0) append(parameters, "convert", conversion_word(subscription.convert));
  append_stated(parameters, "on", subscription.on);
  if (subscription.reach == RequiredReach::any) append(parameters, "reach", std::string(to_string(subscription.reach)));
  if (subscription.limit) append(parameters, "limit", *subscription.limit);
}

void append_request(Parameters& parameters, const HypotheticalRequest& request) {
  append_identity(parameters, request.subscription.identity);
  if (!request.is_any_mode) append(parameters, "mode", std::string(to_string(request.subscription.mode)));
  append_wishes(parameters, request.subscription);
  for (const auto& [name, value] : request.subscription.attributes) {
    append(parameters, std::string(attribute_prefix) + name, value);
  }
}

void append_offer(Parameters& parameters, const HypotheticalOffer& offer) {
  Parameters own;
  const NamedPublication& publication = offer.publication;
  append_identity(own, publication.identity);
  if (!offer.is_any_mode) append(own, "mode", std::string(to_string(publication.mode)));
  if (publication.port != 0) append(own, "port", publication.port);
  append_stated(own, "address", publication.address);
  if (publication.protocol != "udp") append(own, "protocol", publication.protocol);
  if (publication.priority != 0) append(own, "priority", publication.priority);
  if (!offer.provider.participant.empty()) append(own, "provider", provider_list({offer.provider}));
  append_stated(own, "scope", publication.scope);
  append_stated(own, "for", publication.for_whom);
  append_own_attributes(own, publication.attributes);
  for (Parameter& one : own) parameters.push_back({std::string(offer_prefix) + one.key, std::move(one.value)});
}

struct Writer {
  Statement& statement;

  Parameters& begin(std::string_view command, std::string_view subcommand) const {
    statement.command = command;
    statement.subcommand = subcommand;
    return statement.parameters;
  }

  void operator()(const Hello& hello) const {
    auto& parameters = begin("sys", "hello");
    if (hello.name) append(parameters, "name", *hello.name);
    if (hello.room) append(parameters, "room", *hello.room);
    if (hello.keys) append(parameters, "keys", *hello.keys ? "yes" : "no");
  }
  void operator()(const Ping&) const { begin("sys", "ping"); }
  void operator()(const Bye&) const { begin("sys", "bye"); }

  void operator()(const Describe& describe) const {
    auto& parameters = begin("sys", "describe");
    if (describe.concept_name) append(parameters, "concept", *describe.concept_name);
    append_own_attributes(parameters, describe.attributes);
  }

  void operator()(const PubCreate& create) const {
    auto& parameters = begin("pub", "create");
    const NamedPublication& publication = create.publication;
    append(parameters, "mode", std::string(to_string(publication.mode)));
    append_identity(parameters, publication.identity);
    append(parameters, "port", publication.port);
    append_stated(parameters, "address", publication.address);
    if (publication.protocol != "udp") append(parameters, "protocol", publication.protocol);
    if (publication.priority != 0) append(parameters, "priority", publication.priority);
    append_stated(parameters, "scope", publication.scope);
    append_stated(parameters, "for", publication.for_whom);
    append_own_attributes(parameters, publication.attributes);
  }
  void operator()(const PubModify& change) const {
    auto& parameters = begin("pub", "modify");
    append_common_change(parameters, change);
    if (change.protocol) append(parameters, "protocol", *change.protocol);
    if (change.scope) append(parameters, "scope", *change.scope);
    if (change.for_whom) append(parameters, "for", *change.for_whom);
    append_own_attributes(parameters, change.attributes);
  }
  void operator()(const PubRemove&) const { begin("pub", "remove"); }

  void operator()(const SubCreate& create) const {
    auto& parameters = begin("sub", "create");
    const NamedSubscription& subscription = create.subscription;
    append(parameters, "mode", std::string(to_string(subscription.mode)));
    append_identity(parameters, subscription.identity);
    append_wishes(parameters, subscription);
    if (subscription.priority != 0) append(parameters, "priority", subscription.priority);
    if (subscription.port != 0) append(parameters, "port", subscription.port);
    append_stated(parameters, "address", subscription.address);
    append_own_attributes(parameters, subscription.attributes);
  }
  void operator()(const SubModify& change) const {
    auto& parameters = begin("sub", "modify");
    append_common_change(parameters, change);
    if (change.weakest) append(parameters, "match", std::string(to_string(*change.weakest)));
    if (change.providers) append(parameters, "provider", provider_list(*change.providers));
    if (change.where) append(parameters, "where", *change.where);
    if (change.protocols) append(parameters, "protocol", protocol_list(*change.protocols));
    if (change.favoured) append(parameters, "favour", provider_list(*change.favoured));
    if (change.prefer) append(parameters, "prefer", *change.prefer);
    if (change.rank) append(parameters, "rank", *change.rank);
    if (change.scope) append(parameters, "scope", *change.scope);
    if (change.convert) append(parameters, "convert", conversion_word(*change.convert));
    if (change.on) append(parameters, "on", *change.on);
    if (change.reach) append(parameters, "reach", std::string(to_string(*change.reach)));
    if (change.limit) append(parameters, "limit", *change.limit);
    append_own_attributes(parameters, change.attributes);
  }
  void operator()(const SubRemove&) const { begin("sub", "remove"); }

  void operator()(const QueryParticipants& query) const {
    auto& parameters = begin("query", "participants");
    append_stated(parameters, "concept", query.concept_name);
    if (query.weakest != Degree::narrower) append(parameters, "degree", std::string(to_string(query.weakest)));
    append_stated(parameters, "provider", provider_list(query.providers));
    append_stated(parameters, "where", query.where);
    if (query.limit != 0) append(parameters, "limit", query.limit);
    if (query.missing) append(parameters, "missing", "1");
  }
  void operator()(const QueryServices& query) const {
    auto& parameters = begin("query", "services");
    append_filter(parameters, query.filter);
    if (query.unused) append(parameters, "unused", "1");
  }
  void operator()(const QueryRequests& query) const {
    auto& parameters = begin("query", "requests");
    append_filter(parameters, query.filter);
    if (query.unmatched) append(parameters, "unmatched", "1");
    if (query.unused) append(parameters, "unused", "1");
  }
  void operator()(const QueryMatch& query) const {
    auto& parameters = begin("query", "match");
    if (query.identity) append_identity(parameters, *query.identity);
    if (query.weakest != Degree::narrower) append(parameters, "degree", std::string(to_string(query.weakest)));
    if (query.mode) append(parameters, "mode", std::string(to_string(*query.mode)));
    append_stated(parameters, "provider", provider_list(query.providers));
    append_stated(parameters, "where", query.where);
    append_stated(parameters, "on", query.on);
    if (query.limit != 0) append(parameters, "limit", query.limit);
    if (query.convert != 0) append(parameters, "convert", conversion_word(query.convert));
    if (query.missing) append(parameters, "missing", "1");
  }
  void operator()(const QueryExplain& query) const {
    auto& parameters = begin("query", "explain");
    append(parameters, "sub", query.sub);
    append(parameters, "super", query.super);
  }
  void operator()(const QueryWhy& query) const {
    auto& parameters = begin("query", "why");
    if (const auto* key = std::get_if<ServiceKey>(&query.request)) append(parameters, "subscription", to_string(*key));
    if (const auto* asked = std::get_if<HypotheticalRequest>(&query.request)) append_request(parameters, *asked);
    if (const auto* key = std::get_if<ServiceKey>(&query.offer)) append(parameters, "service", to_string(*key));
    if (const auto* offer = std::get_if<HypotheticalOffer>(&query.offer)) append_offer(parameters, *offer);
  }
  void operator()(const QueryConcepts& query) const {
    auto& parameters = begin("query", "concepts");
    append_stated(parameters, "begin", query.begin);
    if (query.limit != max_told_concepts) append(parameters, "limit", query.limit);
  }
  void operator()(const QueryTaxonomy& query) const {
    auto& parameters = begin("query", "taxonomy");
    append_stated(parameters, "class", query.class_name);
    append_stated(parameters, "contains", query.contains);
    if (query.skip != 0) append(parameters, "skip", query.skip);
    if (query.limit != max_told_classes) append(parameters, "limit", query.limit);
  }
  void operator()(const QueryOntology&) const { begin("query", "ontology"); }
  void operator()(const QueryStatus&) const { begin("query", "status"); }
  void operator()(const QueryInterfaces&) const { begin("query", "interfaces"); }
  void operator()(const QueryPeers&) const { begin("query", "peers"); }
  void operator()(const QueryHearing&) const { begin("query", "hearing"); }
  void operator()(const QuerySecurity&) const { begin("query", "security"); }
  void operator()(const QueryDiagnosis& query) const {
    append(begin("query", "diagnosis"), "participant", query.participant);
  }
};

}  // namespace

Statement to_statement(std::uint32_t id, const Request& request) {
  Statement statement;
  statement.id = id;
  std::visit(Writer{statement}, request);
  return statement;
}

std::string conversion_word(std::uint32_t cost) {
  if (cost == 0) return "no";
  return cost == any_cost ? "yes" : std::to_string(cost);
}

std::string protocol_list(const std::vector<std::string>& protocols) { return base::joined(protocols, ","); }

std::string provider_list(const std::vector<ProviderFilter>& providers) {
  std::string list;
  for (const auto& provider : providers) {
    if (!list.empty()) list += ',';
    list += provider.participant;
    if (!provider.peer.empty()) list += '/' + provider.peer;
  }
  return list;
}

}  // namespace geminga::gcnp
