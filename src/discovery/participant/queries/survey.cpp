#include "discovery/participant/queries/survey.hpp"

#include <iterator>
#include <utility>

namespace geminga::participant {

using registry::PublicationEntry;

Survey::Survey(const matching::Matcher& matcher, const Overlaps& overlaps, Asked asked, matching::Rank offer)
    : matcher_(matcher),
      overlaps_(overlaps),
      asked_(std::move(asked)),
      offer_(std::move(offer)),
      candidates_(asked_.entry.subscription.weakest == Degree::overlapping  // each may be a question to the reasoner
                      ? std::nullopt
                      : matcher_.search().candidates(asked_.entry.subscription, *asked_.request, max_ranked_at_once)) {}

bool Survey::proceed(Piece& piece) {
  if (candidates_) {
    for (const ServiceKey& key : *candidates_) {
      piece.look_at_one();
      if (const auto* offer = matcher_.publications().find_entry(key)) look(*offer);
    }
    return true;
  }
  return matcher_.publications().visit_after(last_, [&](const registry::StoredPublication& stored) {
    const PublicationEntry& offer = stored.entry;
    piece.look_at_one();
    const bool is_of_its_kind = is_comparable(offer);
    if (is_of_its_kind && !look(offer)) return false;
    last_ = offer.key;
    seen_ += is_of_its_kind ? 1 : 0;
    return !piece.is_full();
  });
}

/// Whether both are about services, or both about descriptions of participants.
bool Survey::is_comparable(const PublicationEntry& offer) const {
  const bool asks_for_participants = !asked_.is_any_mode && asked_.entry.subscription.mode == ChannelMode::participant;
  return (offer.publication.mode == ChannelMode::participant) == asks_for_participants;
}

bool Survey::look(const PublicationEntry& offer) {
  registry::SubscriptionEntry& asked = asked_.entry;
  if (asked_.is_any_mode) asked.subscription.mode = offer.publication.mode;
  const std::uint64_t postponed = overlaps_.counts().postponed;
  const auto finding = matcher_.examination().examine(asked, *asked_.request, offer);
  if (overlaps_.counts().postponed != postponed) return false;
  if (finding.meets()) {
    // One that is about to be gone meets nothing any more.
    const auto match = matcher_.examination().meets(asked, *asked_.request, offer);
    if (match) take(asked_.request->rank(offer, *match));
    return true;
  }
  nearest_.consider(offer.key, offer.publication.identity, finding);
  return true;
}

void Survey::take(const matching::Rank& rank) {
  ++matching_;
  if (offer_ && matching::BestFirst{}(rank, *offer_)) ++ahead_;
  best_.insert(rank);
  if (best_.size() > max_ranked_matches) best_.erase(std::prev(best_.end()));
}

}  // namespace geminga::participant
