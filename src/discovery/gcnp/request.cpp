// From a statement to a request. request_statement.cpp has the way back, request_service.cpp what the request states.
#include "discovery/gcnp/request.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "base/text.hpp"
#include "discovery/gcnp/attribute.hpp"
#include "discovery/gcnp/key_reader.hpp"
#include "discovery/gcnp/limits.hpp"
#include "discovery/gcnp/stated_change.hpp"

namespace geminga::gcnp {
namespace {

constexpr std::string_view identity_hint = "say id=N, text=NAME, or concept=C with or without representation=R";
constexpr std::string_view mode_hint = "say mode=oto, mode=otm/stream or mode=otm/pubsub";

Request read_hello(KeyReader& keys) {
  auto name = keys.text("name", max_line_bytes);
  const auto room = keys.number("room");
  return Hello{std::move(name), room, keys.answer("keys")};
}
Request read_ping(KeyReader&) { return Ping{}; }
Request read_bye(KeyReader&) { return Bye{}; }

Request read_describe(KeyReader& keys) {
  auto name = keys.text("concept", max_concept_bytes);
  Attributes attributes = keys.attributes();
  keys.require(name || !attributes.empty(), "concept", "say concept=EXPRESSION, what this participant is");
  return Describe{std::move(name), std::move(attributes)};
}

/// A service has a channel.
void refuse_participant(KeyReader& keys, std::optional<ChannelMode> mode) {
  if (mode != ChannelMode::participant) return;
  keys.fail(ErrorCode::malformed,
            "mode=participant: a participant is described by sys describe, no service has this mode");
}

Request read_pub_create(KeyReader& keys) {
  NamedPublication publication;
  const auto mode = keys.mode();
  keys.require(mode.has_value(), "mode", mode_hint);
  refuse_participant(keys, mode);
  auto identity = keys.identity();
  keys.require(identity.has_value(), "an identity", identity_hint);
  const auto port = keys.port();
  keys.require(port.has_value(), "port", "say port=P, where the service can be reached");
  publication.mode = mode.value_or(publication.mode);
  publication.identity = std::move(identity).value_or(NamedIdentity{});
  publication.port = port.value_or(0);
  publication.address = keys.address().value_or("");
  publication.protocol = keys.text("protocol", max_protocol_bytes).value_or("udp");
  publication.priority = keys.priority().value_or(0);
  publication.scope = keys.text("scope", max_scope_bytes).value_or("");
  publication.for_whom = keys.text("for", max_where_bytes).value_or("");
  publication.attributes = keys.offered_attributes();
  drop_empty_conversion(publication.attributes);
  return PubCreate{std::move(publication)};
}

Request read_pub_modify(KeyReader& keys) {
  PubModify change;
  change.identity = keys.identity_change();
  change.mode = keys.mode();
  refuse_participant(keys, change.mode);
  change.address = keys.address();
  change.port = keys.port();
  change.protocol = keys.text("protocol", max_protocol_bytes);
  change.priority = keys.priority();
  change.scope = keys.text("scope", max_scope_bytes);
  change.for_whom = keys.text("for", max_where_bytes);
  change.attributes = keys.offered_attributes();
  return change;
}

Request read_pub_remove(KeyReader&) { return PubRemove{}; }

/// The keys of a subscription beside its mode and identity.
void read_wishes(KeyReader& keys, NamedSubscription& subscription) {
  subscription.weakest = keys.degree("match").value_or(Degree::narrower);
  subscription.providers = keys.providers("provider").value_or(std::vector<ProviderFilter>{});
  subscription.where = keys.text("where", max_where_bytes).value_or("");
  subscription.limit = keys.number("limit");
  subscription.protocols = keys.protocols().value_or(std::vector<std::string>{});
  subscription.favoured = keys.providers("favour").value_or(std::vector<ProviderFilter>{});
  subscription.prefer = keys.text("prefer", max_prefer_bytes).value_or("");
  subscription.rank = keys.text("rank", max_rank_bytes).value_or("");
  subscription.scope = keys.text("scope", max_scope_bytes).value_or("");
  subscription.convert = keys.conversion().value_or(0);
  subscription.on = keys.text("on", max_concept_bytes).value_or("");
  subscription.reach = keys.reach().value_or(RequiredReach::routed);
}

Request read_sub_create(KeyReader& keys) {
  NamedSubscription subscription;
  const auto mode = keys.mode();
  keys.require(mode.has_value(), "mode", mode_hint);
  auto identity = keys.identity();
  keys.require(identity.has_value(), "an identity", identity_hint);
  subscription.mode = mode.value_or(subscription.mode);
  subscription.identity = std::move(identity).value_or(NamedIdentity{});
  read_wishes(keys, subscription);
  subscription.priority = keys.priority().value_or(0);
  subscription.port = keys.port().value_or(0);
  subscription.address = keys.address().value_or("");
  subscription.attributes = keys.attributes();
  return SubCreate{std::move(subscription)};
}

Request read_sub_modify(KeyReader& keys) {
  SubModify change;
  change.identity = keys.identity_change();
  change.mode = keys.mode();
  change.weakest = keys.degree("match");
  change.providers = keys.providers("provider");
  change.where = keys.text("where", max_where_bytes);
  change.limit = keys.number("limit");
  change.priority = keys.priority();
  change.port = keys.port();
  change.address = keys.address();
  change.protocols = keys.protocols();
  change.favoured = keys.providers("favour");
  change.prefer = keys.text("prefer", max_prefer_bytes);
  change.rank = keys.text("rank", max_rank_bytes);
  change.scope = keys.text("scope", max_scope_bytes);
  change.convert = keys.conversion();
  change.on = keys.text("on", max_concept_bytes);
  change.reach = keys.reach();
  change.attributes = keys.attributes();
  return change;
}

Request read_sub_remove(KeyReader&) { return SubRemove{}; }

ListFilter read_list_filter(KeyReader& keys) {
  ListFilter filter;
  filter.identity = keys.identity();
  filter.mode = keys.mode();
  filter.providers = keys.providers("provider").value_or(std::vector<ProviderFilter>{});
  filter.text = keys.text("filter", max_filter_bytes).value_or("");
  filter.with_iris = keys.flag("iris");
  return filter;
}

Request read_query_participants(KeyReader& keys) {
  QueryParticipants query;
  query.concept_name = keys.text("concept", max_concept_bytes).value_or("");
  query.weakest = keys.degree("degree").value_or(Degree::narrower);
  query.providers = keys.providers("provider").value_or(std::vector<ProviderFilter>{});
  query.where = keys.text("where", max_where_bytes).value_or("");
  query.limit = keys.number("limit").value_or(0);
  query.missing = keys.flag("missing");
  const bool has_conditions = query.weakest != Degree::narrower || !query.providers.empty() || !query.where.empty() ||
                              query.limit != 0 || query.missing;
  keys.require(!has_conditions || !query.concept_name.empty(), "concept", "say concept=EXPRESSION, what they shall be");
  return query;
}

Request read_query_services(KeyReader& keys) { return QueryServices{read_list_filter(keys), keys.flag("unused")}; }

Request read_query_requests(KeyReader& keys) {
  QueryRequests query{read_list_filter(keys), keys.flag("unmatched"), keys.flag("unused")};
  if (query.unmatched && query.unused) {
    keys.fail(ErrorCode::malformed, "unmatched and unused together: ask for one of them");
  }
  return query;
}

Request read_query_match(KeyReader& keys) {
  QueryMatch query;
  query.identity = keys.identity();
  query.weakest = keys.degree("degree").value_or(Degree::narrower);
  query.mode = keys.mode();
  query.providers = keys.providers("provider").value_or(std::vector<ProviderFilter>{});
  query.where = keys.text("where", max_where_bytes).value_or("");
  query.on = keys.text("on", max_concept_bytes).value_or("");
  query.limit = keys.number("limit").value_or(0);
  query.convert = keys.conversion().value_or(0);
  query.missing = keys.flag("missing");
  if (query.missing && !(query.identity && std::holds_alternative<ConceptNames>(*query.identity))) {
    keys.fail(ErrorCode::malformed, "missing=1: numbers and texts lack nothing, say concept=C");
  }
  return query;
}

Request read_query_explain(KeyReader& keys) {
  auto sub = keys.text("sub", max_concept_bytes);
  auto super = keys.text("super", max_concept_bytes);
  keys.require(sub.has_value(), "sub", "say sub=NAME super=NAME");
  keys.require(super.has_value(), "super", "say sub=NAME super=NAME");
  return QueryExplain{std::move(sub).value_or(""), std::move(super).value_or("")};
}

HypotheticalOffer read_offer(KeyReader& keys, const Statement& stated) {
  HypotheticalOffer offer;
  KeyReader inner(stated);
  auto identity = inner.identity();
  inner.require(identity.has_value(), "an identity", "say offer.id=N, offer.text=NAME or offer.concept=C");
  const auto mode = inner.mode();
  offer.is_any_mode = !mode;
  offer.publication.mode = mode.value_or(ChannelMode::one_to_one);
  offer.publication.identity = std::move(identity).value_or(NamedIdentity{});
  offer.publication.port = inner.port().value_or(0);
  offer.publication.address = inner.address().value_or("");
  offer.publication.protocol = inner.text("protocol", max_protocol_bytes).value_or("udp");
  offer.publication.priority = inner.priority().value_or(0);
  offer.publication.scope = inner.text("scope", max_scope_bytes).value_or("");
  offer.publication.for_whom = inner.text("for", max_where_bytes).value_or("");
  if (auto providers = inner.providers("provider"); providers && !providers->empty()) {
    if (providers->size() > 1) inner.fail(ErrorCode::malformed, "provider: one service has one provider");
    offer.provider = std::move(providers->front());
  }
  offer.publication.attributes = inner.offered_attributes();
  if (stated.has("")) inner.fail(ErrorCode::malformed, "a key is missing behind offer.");
  if (inner.error()) keys.fail(inner.error()->code, "offer: " + inner.error()->text);
  return offer;
}

Request read_query_why(KeyReader& keys) {
  QueryWhy query;
  const auto subscription = keys.service_key("subscription");
  const auto service = keys.service_key("service");
  const Statement offered = keys.behind(offer_prefix);
  const bool is_offer_alone = (service || !offered.parameters.empty()) && keys.is_empty();
  if (subscription) {
    query.request = *subscription;
  } else if (!is_offer_alone) {
    HypotheticalRequest asked;
    auto identity = keys.identity();
    keys.require(identity.has_value(), "subscription",
                 "say subscription=PARTICIPANT/PEER/NUMBER, or what might be asked for as in sub create");
    asked.subscription.identity = std::move(identity).value_or(NamedIdentity{});
    const auto mode = keys.mode();
    asked.is_any_mode = !mode;
    asked.subscription.mode = mode.value_or(ChannelMode::one_to_one);
    read_wishes(keys, asked.subscription);
    // With their prefix only, so that a key without it is told.
    for (const auto& [name, value] : keys.behind(attribute_prefix).parameters) {
      asked.subscription.attributes.emplace(name, value.value_or(""));
    }
    query.request = std::move(asked);
  }
  if (service && !offered.parameters.empty()) {
    keys.fail(ErrorCode::malformed, "service and offer. together: one service at a time");
  }
  if (service) {
    query.offer = *service;
  } else if (!offered.parameters.empty()) {
    query.offer = read_offer(keys, offered);
  }
  return query;
}

Request read_query_concepts(KeyReader& keys) {
  QueryConcepts query;
  query.begin = keys.text("begin", max_concept_bytes).value_or("");
  const std::uint32_t limit = keys.number("limit").value_or(0);
  if (limit != 0) query.limit = std::min(limit, max_told_concepts);
  return query;
}

Request read_query_taxonomy(KeyReader& keys) {
  QueryTaxonomy query;
  query.class_name = keys.text("class", max_concept_bytes).value_or("");
  query.contains = keys.text("contains", max_concept_bytes).value_or("");
  query.skip = keys.number("skip").value_or(0);
  const std::uint32_t limit = keys.number("limit").value_or(0);
  if (limit != 0) query.limit = std::min(limit, max_told_classes);
  if (!query.class_name.empty() && !query.contains.empty()) {
    keys.fail(ErrorCode::malformed, "class and contains together: one of them at a time");
  }
  return query;
}

Request read_query_ontology(KeyReader&) { return QueryOntology{}; }
Request read_query_status(KeyReader&) { return QueryStatus{}; }
Request read_query_interfaces(KeyReader&) { return QueryInterfaces{}; }
Request read_query_peers(KeyReader&) { return QueryPeers{}; }
Request read_query_hearing(KeyReader&) { return QueryHearing{}; }
Request read_query_security(KeyReader&) { return QuerySecurity{}; }
Request read_query_diagnosis(KeyReader& keys) {
  auto participant = keys.text("participant", max_name_bytes);
  keys.require(participant.has_value(), "participant", "say participant=ID or participant=NAME");
  return QueryDiagnosis{std::move(participant).value_or("")};
}

/// One row for each statement that a client may send.
struct Row {
  std::string_view command;
  std::string_view subcommand;
  Request (*read)(KeyReader&);
};

constexpr std::array<Row, 25> rows{{
    {"sys", "hello", read_hello},
    {"sys", "ping", read_ping},
    {"sys", "bye", read_bye},
    {"sys", "describe", read_describe},
    {"pub", "create", read_pub_create},
    {"pub", "modify", read_pub_modify},
    {"pub", "remove", read_pub_remove},
    {"sub", "create", read_sub_create},
    {"sub", "modify", read_sub_modify},
    {"sub", "remove", read_sub_remove},
    {"query", "participants", read_query_participants},
    {"query", "services", read_query_services},
    {"query", "requests", read_query_requests},
    {"query", "match", read_query_match},
    {"query", "explain", read_query_explain},
    {"query", "why", read_query_why},
    {"query", "ontology", read_query_ontology},
    {"query", "status", read_query_status},
    {"query", "interfaces", read_query_interfaces},
    {"query", "peers", read_query_peers},
    {"query", "security", read_query_security},
    {"query", "concepts", read_query_concepts},
    {"query", "diagnosis", read_query_diagnosis},
    {"query", "taxonomy", read_query_taxonomy},
    {"query", "hearing", read_query_hearing},
}};

/// The reason why no row has this command and subcommand, with the known words.
Error unknown_statement(const Statement& statement) {
  std::string words;
  for (const auto& row : rows) {
    if (row.command == statement.command) words += (words.empty() ? "" : ", ") + std::string(row.subcommand);
  }
  if (words.empty()) {
    return {ErrorCode::malformed,
            "no command " + base::printable(statement.command, 40) + ": there are sys, pub, sub and query"};
  }
  return {ErrorCode::malformed,
          "no " + statement.command + ' ' + base::printable(statement.subcommand, 40) + ": there are " + words};
}

}  // namespace

std::expected<Request, Error> read_request(const Statement& statement) {
  const auto row = std::ranges::find_if(rows, [&](const Row& candidate) {
    return candidate.command == statement.command && candidate.subcommand == statement.subcommand;
  });
  if (row == rows.end()) return std::unexpected(unknown_statement(statement));
  const bool is_system = row->command == "sys";
  if (is_system && statement.id != 0) {
    return std::unexpected(Error{ErrorCode::malformed, "sys statements have the id 0: 0 sys " + statement.subcommand});
  }
  if (!is_system && statement.id == 0) {
    return std::unexpected(Error{ErrorCode::malformed, "the id 0 belongs to sys: choose another number"});
  }
  KeyReader keys(statement);
  Request request = row->read(keys);
  keys.finish();
  if (keys.error()) return std::unexpected(*keys.error());
  return request;
}

bool matches_text(const Statement& line, std::string_view text) {
  return text.empty() || std::ranges::any_of(line.parameters, [&](const Parameter& parameter) {
           return parameter.value && parameter.value->contains(text);
         });
}

}  // namespace geminga::gcnp
