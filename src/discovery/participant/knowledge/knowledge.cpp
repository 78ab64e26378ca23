#include "discovery/participant/knowledge/knowledge.hpp"

#include <optional>
#include <utility>
#include <variant>

namespace geminga::participant {
namespace {

matching::Reason reason_of(membership::Departure departure) {
  switch (departure) {
    case membership::Departure::withdrawn:
      return matching::Reason::withdrawn;
    case membership::Departure::expired:
      return matching::Reason::expired;
    case membership::Departure::left:
      return matching::Reason::left;
  }
  return matching::Reason::withdrawn;
}

/// Makes one change in the registry. Entries have no deadline of their own there: the neighbour table, which hears
/// every sign of life, alone decides when a participant is gone.
struct Feed {
  matching::Matcher& matcher;

  void operator()(membership::PutPublication& put) const {
    matcher.put(registry::PublicationEntry{.key = put.key,
                                           .publication = std::move(put.publication),
                                           .peer_name = std::move(put.peer_name),
                                           .participant_name = std::move(put.participant_name),
                                           .updated = put.heard,
                                           .is_reachable = put.is_reachable});
  }
  void operator()(membership::PutSubscription& put) const {
    matcher.put(registry::SubscriptionEntry{.key = put.key,
                                            .subscription = std::move(put.subscription),
                                            .peer_name = std::move(put.peer_name),
                                            .participant_name = std::move(put.participant_name),
                                            .updated = put.heard,
                                            .is_reachable = put.is_reachable});
  }
  void operator()(const membership::RemovePublication& gone) const {
    matcher.begin_removal_of_publication(gone.key, reason_of(gone.reason));
  }
  void operator()(const membership::RemoveSubscription& gone) const {
    matcher.begin_removal_of_subscription(gone.key, reason_of(gone.reason));
  }
  void operator()(const membership::RemoveParticipant& gone) const {
    matcher.begin_departure(gone.participant, reason_of(gone.reason));
  }
};

}  // namespace

Knowledge::Knowledge(env::Env& env, std::string stated_name, const vocabulary::Vocabulary& vocabulary)
    : self{.id = {}, .stated_name = std::move(stated_name)},
      matcher(
          vocabulary,
          [this](const vocabulary::Vocabulary& by, const std::string& expression, ParticipantId from) {
            return expressions.place(by, expression, other_participant(from), env_.now());
          },
          [this](const vocabulary::Vocabulary& by, const matching::Meaning& offered, const matching::Meaning& requested,
                 ParticipantId from) {
            return overlaps.answer(by, offered, requested, other_participant(from), env_.now());
          },
          [this](const vocabulary::Vocabulary& by, const matching::Meaning& offered, const matching::Meaning& requested,
                 ParticipantId from) {
            return overlaps.compare(by, offered, requested, other_participant(from), env_.now());
          }),
      ontology_change(matcher.editions(), matcher.vocabulary_change(), reading, env.log()),
      resolver(env, matcher.editions(), expressions, reading),
      work(matcher, expressions, overlaps),
      env_(env) {}

void Knowledge::queue(std::vector<membership::Change> changes) {
  for (membership::Change& change : changes) neighbours_.push(std::move(change));
}

void Knowledge::take_next_change() {
  if (auto change = neighbours_.pop(env_.now())) std::visit(Feed{matcher}, *change);
}

void Knowledge::resume_postponed_expressions() {
  if (expressions.take_waiting(vocabulary(), env_.now())) ontology_change.place_again();
}

void Knowledge::resume_postponed_overlaps() {
  if (overlaps.take_waiting(env_.now())) ontology_change.place_again();
}

}  // namespace geminga::participant
