// All that a participant knows of the team's services, and what their names mean.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_KNOWLEDGE_KNOWLEDGE_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_KNOWLEDGE_KNOWLEDGE_HPP

#include <optional>
#include <string>
#include <vector>

#include "discovery/matching/matcher.hpp"
#include "discovery/membership/neighbour/change.hpp"
#include "discovery/participant/knowledge/expressions.hpp"
#include "discovery/participant/knowledge/neighbour_queue.hpp"
#include "discovery/participant/knowledge/ontology_change.hpp"
#include "discovery/participant/knowledge/ontology_reading.hpp"
#include "discovery/participant/knowledge/overlaps.hpp"
#include "discovery/participant/knowledge/resolver.hpp"
#include "discovery/participant/knowledge/self.hpp"
#include "discovery/participant/knowledge/work.hpp"
#include "env/env.hpp"

namespace geminga::participant {

/// Owns the matcher, the vocabulary in force with its change, what is remembered of class expressions and overlaps, and
/// the changes of neighbours that wait. Only the participant holds it; everybody else is given the parts that he reads
/// or changes.
class Knowledge {
 public:
  /// Borrows `env` for its life.
  Knowledge(env::Env& env, std::string stated_name, const vocabulary::Vocabulary& vocabulary);
  Knowledge(const Knowledge&) = delete;
  Knowledge& operator=(const Knowledge&) = delete;

  Self self;
  Expressions expressions;
  Overlaps overlaps;
  /// Changed by three alone: by the services of our peers (clients/own_services.hpp), by what neighbours change (here),
  /// and by the change of ontology. Events are taken by clients/telling.hpp.
  matching::Matcher matcher;
  OntologyReading reading;
  OntologyChange ontology_change;
  Resolver resolver;
  WorkMeter work;

  [[nodiscard]] const vocabulary::Vocabulary& vocabulary() const { return matcher.editions().vocabulary(); }

  /// Takes in what the table of neighbours has found changed; take_next_change() brings it into the registry.
  void queue(std::vector<membership::Change> changes);
  /// Brings the eldest change of a neighbour into the registry. Only when the matcher has no steps to take.
  void take_next_change();
  /// Whether one of the two has something to do.
  [[nodiscard]] bool is_behind() const { return matcher.has_steps() || neighbours_.has_due(env_.now()); }
  /// When a change that waits for budget is due; base::never: none waits.
  [[nodiscard]] base::Instant next_due() const { return neighbours_.next_due(); }
  /// How many changes to converters of other hosts wait for budget.
  [[nodiscard]] std::size_t held_converters() const { return neighbours_.held(); }
  /// Has expressions and overlaps that were put off asked for again, where a new second has begun.
  void resume_postponed_expressions();
  void resume_postponed_overlaps();

 private:
  /// Nothing for one of ours, whose questions no quota bounds.
  [[nodiscard]] std::optional<ParticipantId> other_participant(ParticipantId from) const {
    return self.is_ours(from) ? std::nullopt : std::optional(from);
  }

  env::Env& env_;
  NeighbourQueue neighbours_;
};

}  // namespace geminga::participant

#endif
