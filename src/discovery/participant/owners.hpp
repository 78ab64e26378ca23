// The three owners of a participant, and what routing between them needs. Only participant.cpp and owners.cpp include
// this.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_OWNERS_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_OWNERS_HPP

#include <cstdint>
#include <expected>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "discovery/participant/air/air.hpp"
#include "discovery/participant/clients/clients.hpp"
#include "discovery/participant/knowledge/knowledge.hpp"
#include "discovery/participant/ontology_watch.hpp"
#include "discovery/participant/participant.hpp"
#include "discovery/participant/queries/queries.hpp"

namespace geminga::participant {

/// How far a participant has come.
enum class Phase : std::uint8_t {
  created,   ///< start() has not been called
  claiming,  ///< no identifier has been held: statements wait
  ready,     ///< peers are served; after a clash under the old identifier, until another is claimed
  stopping,  ///< goodbyes are being said
  stopped,   ///< may be destroyed
  failed,    ///< no identifier could be claimed: may be destroyed
};

struct Participant::Owners {
  Owners(env::Env& the_env, Settings the_settings, Vocabulary vocabulary)
      : env(the_env),
        settings(std::move(the_settings)),
        knowledge(env, settings.name, std::move(vocabulary)),
        clients(
            env, settings.limits,
            {.self = knowledge.self,
             .matcher = knowledge.matcher,
             .resolver = knowledge.resolver,
             .expressions = knowledge.expressions,
             .overlaps = knowledge.overlaps,
             .work = knowledge.work},
            [this](const gcnp::Request& query) { return ask(query); }, [this](Life life) { return keys_of(life); },
            [this](ParticipantId participant) { return way_of(participant); }),
        air(env, settings,
            {.ontology_digest = [this] { return knowledge.vocabulary().digest(); },
             .peers = [this] { return clients.own().announced(); },
             .diagnosis = [this](ParticipantId asker) { return own_diagnosis(asker); }}) {
    if (settings.shared_entries) knowledge.matcher.share(settings.shared_entries);
  }

  env::Env& env;
  const Settings settings;
  Knowledge knowledge;
  Clients clients;
  Air air;
  OntologyWatch ontology_watch;
  Phase phase = Phase::created;
  base::Instant started{};
  std::set<env::InterfaceIndex> interfaces;
  Work before_event = 0;  ///< all work done when the event under way began
  StatusSource status_source;
  std::string description_problem;  ///< that was logged last

  /// Hands each query the parts that it reads.
  std::expected<Answering, Error> ask(const gcnp::Request& query);
  [[nodiscard]] Answer status_answer();
  [[nodiscard]] Answer participants_answer();
  /// The parts that lists read.
  [[nodiscard]] Listed listed();
  /// The answer to an inquiry of another participant.
  [[nodiscard]] std::vector<std::string> own_diagnosis(ParticipantId asker);
  [[nodiscard]] std::expected<Answering, Error> ask_other(const std::string& participant);
  /// The way to another participant.
  [[nodiscard]] gcnp::Way way_of(ParticipantId participant) const;
  /// The keys of the channel with this life, derived from those that seal the air.
  [[nodiscard]] gcnp::ChannelKeyring keys_of(Life life) const;
};

}  // namespace geminga::participant

#endif
