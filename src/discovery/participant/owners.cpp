// The queries of clients and of other participants: each is handed the parts that it reads.
#include "discovery/participant/owners.hpp"

#include <array>
#include <optional>
#include <string_view>
#include <type_traits>
#include <variant>

#include "base/assert.hpp"
#include "base/text.hpp"
#include "discovery/participant/queries/queries.hpp"
#include "discovery/participant/queries/ways.hpp"
#include "discovery/participant/status.hpp"
#include "discovery/sealing/channel_keys.hpp"

namespace geminga::participant {
namespace {

/// Their words in `query status`.
constexpr std::array<std::string_view, 6> phase_words{"created", "claiming", "ready", "stopping", "stopped", "failed"};

}  // namespace

gcnp::ChannelKeyring Participant::Owners::keys_of(Life life) const {
  const sealing::Policy& policy = air.seal().policy();
  gcnp::ChannelKeyring keyring{.life = life, .mode = std::string(sealing::to_string(policy.mode)), .ring = {}};
  for (const sealing::Key& key : policy.keys.keys()) {
    const sealing::ChannelKeys keys = sealing::channel_keys(key, std::to_underlying(life));
    keyring.ring.push_back({.id = std::to_underlying(keys.id), .forward = keys.forward, .back = keys.back});
  }
  return keyring;
}

gcnp::Way Participant::Owners::way_of(ParticipantId participant) const {
  return participant::way_of(participant, air.table().neighbours());
}

Answer Participant::Owners::status_answer() {
  Course course{.phase = phase_words.at(std::to_underlying(phase)), .uptime = env.now() - started, .of_owner = {}};
  if (status_source) course.of_owner = status_source();
  return answer_status(settings, std::move(course), knowledge, air, clients.sessions(), env.now());
}

Answer Participant::Owners::participants_answer() {
  return answer_participants(listed(), knowledge.self, settings.interval, clients.sessions(),
                             clients.own().description().problem());
}

std::vector<std::string> Participant::Owners::own_diagnosis(ParticipantId asker) {
  return diagnosis_lines(status_answer(), answer_interfaces(env, air), participants_answer(), asker);
}

std::expected<Answering, Error> Participant::Owners::ask_other(const std::string& participant) {
  std::optional<ParticipantId> found;
  air.table().neighbours().for_each([&](const membership::Neighbour& one) {
    if (to_string(one.id) == participant || (one.name == participant && (!found || one.id < *found))) found = one.id;
  });
  if (!found) {
    return std::unexpected(Error{ErrorCode::unknown_request, "no participant " + base::printable(participant, 40) +
                                                                 " is known: see query participants"});
  }
  return telling(answer_diagnosis(air.diagnosis_of(*found), env.now()));
}

Listed Participant::Owners::listed() {
  return {
      .env = env, .matcher = knowledge.matcher, .neighbours = air.table().neighbours(), .resolver = knowledge.resolver};
}

std::expected<Answering, Error> Participant::Owners::ask(const gcnp::Request& query) {
  return std::visit(
      [&](const auto& one) -> std::expected<Answering, Error> {
        using Query = std::decay_t<decltype(one)>;
        const Sessions& sessions = clients.sessions();
        if constexpr (std::is_same_v<Query, gcnp::QueryServices> || std::is_same_v<Query, gcnp::QueryRequests>) {
          return begin_list(listed(), one);
        } else if constexpr (std::is_same_v<Query, gcnp::QueryHearing>) {
          return begin_hearing(env, air.table());
        } else if constexpr (std::is_same_v<Query, gcnp::QueryTaxonomy>) {
          return begin_taxonomy(listed(), one);
        } else if constexpr (std::is_same_v<Query, gcnp::QueryMatch>) {
          return begin_match(listed(), knowledge.overlaps, knowledge.self, one);
        } else if constexpr (std::is_same_v<Query, gcnp::QueryWhy>) {
          return begin_why(
              knowledge.matcher, knowledge.overlaps, air.table().neighbours(),
              {.matcher = knowledge.matcher, .resolver = knowledge.resolver, .self = knowledge.self, .now = env.now()},
              one);
        } else if constexpr (std::is_same_v<Query, gcnp::QueryExplain>) {
          auto answer = answer_explain(knowledge.vocabulary(), knowledge.resolver, one);
          if (!answer) return std::unexpected(std::move(answer.error()));
          return telling(std::move(*answer));
        } else if constexpr (std::is_same_v<Query, gcnp::QueryParticipants>) {
          if (one.concept_name.empty()) return telling(participants_answer());
          return begin_participants(listed(), knowledge.overlaps, knowledge.self, one, [this](ParticipantId id) {
            return participant_line(listed(), knowledge.self, settings.interval, clients.sessions(), id);
          });
        } else if constexpr (std::is_same_v<Query, gcnp::QueryOntology>) {
          return telling(
              answer_ontology(knowledge.vocabulary(), knowledge.reading, air.table().neighbours(), env.now()));
        } else if constexpr (std::is_same_v<Query, gcnp::QueryInterfaces>) {
          return telling(answer_interfaces(env, air));
        } else if constexpr (std::is_same_v<Query, gcnp::QueryPeers>) {
          return telling(answer_peers(sessions));
        } else if constexpr (std::is_same_v<Query, gcnp::QuerySecurity>) {
          return telling(answer_security(air.seal(), air.table().neighbours(), env.now()));
        } else if constexpr (std::is_same_v<Query, gcnp::QueryStatus>) {
          return telling(status_answer());
        } else if constexpr (std::is_same_v<Query, gcnp::QueryConcepts>) {
          return telling(answer_concepts(knowledge.vocabulary(), one));
        } else if constexpr (std::is_same_v<Query, gcnp::QueryDiagnosis>) {
          return ask_other(one.participant);
        } else {
          GEMINGA_ASSERT(false);  // not a query: handled where clients are
          return {};
        }
      },
      query);
}

}  // namespace geminga::participant
