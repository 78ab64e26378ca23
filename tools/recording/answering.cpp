#include "recording/answering.hpp"

#include <algorithm>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <type_traits>
#include <utility>

#include "base/text.hpp"
#include "discovery/gcnp/parameters.hpp"
#include "geminga/match.hpp"
#include "recording/record_json.hpp"
#include "shell/timestamp.hpp"

namespace geminga::recording {
namespace {

using gcnp::Statement;
using Lines = std::vector<Statement>;
using Told = std::expected<Lines, Error>;

std::unexpected<Error> refused(ErrorCode code, std::string text) {
  return std::unexpected(Error{code, std::move(text)});
}

void append_end(Lines& lines, std::uint32_t id, std::vector<gcnp::Parameter> more = {}) {
  Statement end{id, "msg", "end", {}};
  gcnp::append(end.parameters, "count", lines.size());
  for (auto& one : more) end.parameters.push_back(std::move(one));
  lines.push_back(std::move(end));
}

/// Ends the lines of services or requests. A concept is found by its name alone, which the end says; where nothing
/// states it, nothing can be said.
Told ended(Lines lines, std::uint32_t id, const std::optional<NamedIdentity>& identity) {
  const auto* names = identity ? std::get_if<ConceptNames>(&*identity) : nullptr;
  if (names != nullptr && lines.empty()) {
    return refused(ErrorCode::impossible, "a recording has no ontology, and nothing here states exactly " +
                                              base::printable(names->concept_name) +
                                              ": whether something below it is there cannot be said");
  }
  std::vector<gcnp::Parameter> more;
  if (names != nullptr) {
    more.push_back({"gaps", "a recording has no ontology: only what states exactly this concept is found"});
  }
  append_end(lines, id, std::move(more));
  return lines;
}

/// The lines of records, and an end with the keys of the recorded one.
Lines told(std::uint32_t id, const Answer& answer) {
  Lines lines;
  for (const Record& record : answer.records) lines.push_back(statement_of(id, record));
  std::vector<gcnp::Parameter> more;
  for (const auto& [key, value] : answer.end.fields) {
    if (key != "count") more.push_back({key, value});
  }
  append_end(lines, id, std::move(more));
  return lines;
}

bool is_of(const ProviderFilter& provider, const Record& record, std::string_view party_key) {
  const std::string_view party = record[party_key];
  const auto slash = std::min(party.find('/'), party.size());
  const std::string_view participant = party.substr(0, slash);
  const std::string_view peer = party.substr(std::min(slash + 1, party.size()));
  const bool is_participant = provider.participant.empty() || provider.participant == participant ||
                              provider.participant == record["participant_name"];
  return is_participant && (provider.peer.empty() || provider.peer == peer || provider.peer == record["name"]);
}

bool is_of_any(const std::vector<ProviderFilter>& providers, const Record& record, std::string_view party_key) {
  return providers.empty() ||
         std::ranges::any_of(providers, [&](const auto& one) { return is_of(one, record, party_key); });
}

/// Whether the record states this identity, concepts by the letters of their names.
bool has_identity(const Record& record, const NamedIdentity& identity) {
  if (const auto* number = std::get_if<NumericIdentity>(&identity)) {
    return record["id"] == std::to_string(number->number);
  }
  if (const auto* text = std::get_if<TextIdentity>(&identity)) return record["text"] == text->text;
  const auto& names = std::get<ConceptNames>(identity);
  return record["concept"] == names.concept_name &&
         (names.representation_name.empty() || record["representation"] == names.representation_name);
}

bool passes(const gcnp::ListFilter& filter, const Record& record, std::string_view party_key) {
  return (!filter.identity || has_identity(record, *filter.identity)) &&
         (!filter.mode || record["mode"] == to_string(*filter.mode)) && is_of_any(filter.providers, record, party_key);
}

/// The record without the fields of this name.
Record without(Record record, std::initializer_list<std::string_view> keys) {
  std::erase_if(record.fields, [&](const auto& field) {
    return std::ranges::find(keys, std::string_view(field.first)) != keys.end();
  });
  return record;
}

/// The services or requests that the filter lets through. `answered` is the flag that says whether somebody answers.
Told listed(const State& state, std::uint32_t id, std::string_view kind, const gcnp::ListFilter& filter,
            bool is_unanswered_only) {
  const bool is_service = kind == "services";
  Lines lines;
  for (const auto& [key, record] : state.of(kind)) {
    if (!passes(filter, record, is_service ? "provider" : "consumer")) continue;
    if (is_unanswered_only && record[is_service ? "used" : "served"] != "0") continue;
    const Record aged = state.aged(record);
    Statement line = statement_of(id, is_unanswered_only ? aged : without(aged, {"why", "because"}));
    if (gcnp::matches_text(line, filter.text)) lines.push_back(std::move(line));
  }
  return ended(std::move(lines), id, filter.identity);
}

/// A service as a line of `match`: an exact one, since an ontology is needed for all other degrees.
Record matched(const Record& service) {
  Record line{"match", {}, service.attributes};
  const auto take = [&](std::initializer_list<std::string_view> keys) {
    for (const std::string_view key : keys) {
      if (!service[key].empty()) line.fields.emplace_back(key, service[key]);
    }
  };
  take({"service", "provider", "name", "id", "text", "concept", "representation"});
  line.fields.emplace_back("degree", "exact");
  line.fields.emplace_back("distance", "0");
  take({"mode", "address", "port", "protocol", "priority", "age", "participant_name"});
  return line;
}

/// The answer to `match` that was recorded for a request for this concept; null where there is none.
const Answer* recorded_matches(const State& state, const gcnp::QueryMatch& query) {
  if (!query.identity || !std::holds_alternative<ConceptNames>(*query.identity)) return nullptr;
  for (const auto& [key, request] : state.of("requests")) {
    if (!has_identity(request, *query.identity)) continue;
    const bool has_same_form = request["representation"] == std::get<ConceptNames>(*query.identity).representation_name;
    if (const Answer* answer = state.matches(key); answer != nullptr && has_same_form) return answer;
  }
  return nullptr;
}

/// The recorded lines of services that are there at this moment, with their ages.
Told told_matches(const State& state, std::uint32_t id, const gcnp::QueryMatch& query, const Answer& answer) {
  Lines lines;
  for (const Record& one : answer.records) {
    const auto service = state.of("services").find(one["service"]);
    if (service == state.of("services").end() || (query.limit != 0 && lines.size() == query.limit)) continue;
    const gcnp::ListFilter filter{std::nullopt, query.mode, query.providers, ""};
    if (!passes(filter, one, "provider")) continue;
    Record line = one;
    line.fields.emplace_back("age", state.aged(service->second)["age"]);
    lines.push_back(statement_of(id, line));
  }
  append_end(lines, id);
  return lines;
}

Told on(const State& state, std::uint32_t id, const gcnp::QueryMatch& query) {
  if (!query.where.empty() || !query.on.empty() || query.convert != 0) {
    return refused(
        ErrorCode::impossible,
        "a recording judges no conditions, descriptions and conversions: leave out where, on and convert, or "
        "ask for services and read their attributes");
  }
  if (const Answer* answer = recorded_matches(state, query)) return told_matches(state, id, query, *answer);
  std::vector<const Record*> found;
  for (const auto& [key, record] : state.of("services")) {
    const gcnp::ListFilter filter{query.identity, query.mode, query.providers, ""};
    if (passes(filter, record, "provider")) found.push_back(&record);
  }
  const auto priority = [](const Record* record) {
    return base::parse_number<std::int64_t>((*record)["priority"]).value_or(0);
  };
  std::ranges::stable_sort(found, std::greater(), priority);
  if (query.limit != 0 && found.size() > query.limit) found.resize(query.limit);
  Lines lines;
  for (const Record* record : found) lines.push_back(statement_of(id, matched(state.aged(*record))));
  return ended(std::move(lines), id, query.identity);
}

Told on(const State& state, std::uint32_t id, const gcnp::QueryParticipants&) {
  Lines lines;
  for (const auto& [key, record] : state.of("participants")) lines.push_back(statement_of(id, state.aged(record)));
  append_end(lines, id);
  return lines;
}

Told on(const State& state, std::uint32_t id, const gcnp::QueryServices& query) {
  return listed(state, id, "services", query.filter, query.unused);
}

Told on(const State& state, std::uint32_t id, const gcnp::QueryRequests& query) {
  return query.unused ? listed(state, id, "services", query.filter, true)
                      : listed(state, id, "requests", query.filter, query.unmatched);
}

Told on(const State&, std::uint32_t, const gcnp::QueryExplain&) {
  return refused(ErrorCode::impossible,
                 "a recording has no ontology: ask geminga-ontology explain with the team's files");
}

Told on(const State&, std::uint32_t, const gcnp::QueryHearing&) {
  return refused(ErrorCode::impossible,
                 "a recording does not say who heard whom: query participants has what was lost");
}

Told on(const State&, std::uint32_t, const gcnp::QueryTaxonomy&) {
  return refused(ErrorCode::impossible, "a recording has no ontology: ask geminga-ontology draw with the team's files");
}

Told on(const State& state, std::uint32_t id, const gcnp::QueryWhy& query) {
  const auto* request = std::get_if<ServiceKey>(&query.request);
  if (request == nullptr || !std::holds_alternative<std::monostate>(query.offer)) {
    return refused(ErrorCode::impossible,
                   "a recording keeps why a request has the services that it has, and nothing about other pairs: give "
                   "one subscription and no service; services unused=1 has why nobody takes a service");
  }
  const std::string key = to_string(*request);
  if (!state.of("requests").contains(key)) {
    return refused(ErrorCode::unknown_request, key + " is no request that is there at this moment of the recording");
  }
  const Answer* why = state.why(key);
  if (why == nullptr) {
    return refused(ErrorCode::not_ready, "the recording has not yet an answer about " + key + " at this moment");
  }
  return told(id, *why);
}

/// The recorded answer to a query about the daemon itself.
Told recorded(const State& state, std::uint32_t id, std::string_view kind) {
  const Answer* answer = state.answer(kind);
  if (answer != nullptr) return told(id, *answer);
  return refused(ErrorCode::not_ready,
                 "the recording has no answer to " + std::string(kind) + " until this moment: ask again, or play on");
}

Told on(const State& state, std::uint32_t id, const gcnp::QueryStatus&) {
  auto lines = recorded(state, id, "status");
  if (lines && lines->size() > 1) {
    gcnp::append(lines->front().parameters, "recorded", shell::timestamp(state.time()));
  }
  return lines;
}
Told on(const State& state, std::uint32_t id, const gcnp::QueryOntology&) { return recorded(state, id, "ontology"); }
Told on(const State& state, std::uint32_t id, const gcnp::QuerySecurity&) { return recorded(state, id, "security"); }
Told on(const State& state, std::uint32_t id, const gcnp::QueryInterfaces&) {
  return recorded(state, id, "interfaces");
}
Told on(const State& state, std::uint32_t id, const gcnp::QueryPeers&) { return recorded(state, id, "peers"); }

/// The names that are offered or asked for at this moment.
Told on(const State& state, std::uint32_t id, const gcnp::QueryConcepts& query) {
  std::set<std::string> names;
  for (const char* kind : {"services", "requests"}) {
    for (const auto& [key, record] : state.of(kind)) {
      if (!record["concept"].empty() && record["concept"].starts_with(query.begin)) names.emplace(record["concept"]);
    }
  }
  const std::size_t most =
      query.limit == 0 ? gcnp::max_told_concepts : std::min<std::size_t>(query.limit, gcnp::max_told_concepts);
  Lines lines;
  for (const std::string& name : names) {
    if (lines.size() == most) break;
    lines.push_back(statement_of(id, {"concepts", {{"concept", name}}, {}}));
  }
  append_end(lines, id);
  return lines;
}

/// The requests that no recording can fulfil.
template <typename Request>
constexpr bool is_statement =
    std::is_same_v<Request, gcnp::PubCreate> || std::is_same_v<Request, gcnp::PubModify> ||
    std::is_same_v<Request, gcnp::PubRemove> || std::is_same_v<Request, gcnp::SubCreate> ||
    std::is_same_v<Request, gcnp::SubModify> || std::is_same_v<Request, gcnp::SubRemove> ||
    std::is_same_v<Request, gcnp::Hello> || std::is_same_v<Request, gcnp::Ping> || std::is_same_v<Request, gcnp::Bye>;

}  // namespace

Told answer(const State& state, std::uint32_t id, const gcnp::Request& request) {
  return std::visit(
      [&](const auto& one) -> Told {
        if constexpr (requires { on(state, id, one); }) {
          if (state.lost().empty()) return on(state, id, one);
          return refused(ErrorCode::not_ready,
                         "at this moment of the recording the daemon could not be asked: " + state.lost());
        } else {
          return refused(
              ErrorCode::impossible,
              "this is a recording: nothing can be offered, asked for or changed; query shows what was there");
        }
      },
      request);
}

Statement welcome(const State& state, std::uint32_t peer, const std::string& name) {
  const Snapshot& source = state.source();
  return {0,
          "msg",
          "hello",
          {{"version", "1"},
           {"participant", source.participant},
           {"peer", std::to_string(peer)},
           {"name", name},
           {"ontology", source.ontology},
           {"participant_name", source.name}}};
}

}  // namespace geminga::recording
