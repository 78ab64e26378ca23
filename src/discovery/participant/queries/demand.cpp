#include "discovery/participant/queries/demand.hpp"

#include <algorithm>
#include <iterator>
#include <span>
#include <utility>

#include "discovery/matching/interest.hpp"

namespace geminga::participant {

using registry::PublicationEntry;
using registry::SubscriptionEntry;

namespace {

/// Behind every key that there is.
constexpr ServiceKey last_key{ParticipantId{0xffffffff}, PeerId{0xffffffff}, 0xffffffff};

}  // namespace

matching::Rank rank_of(const Asked& asked, const Offered& offer, const matching::Match& match) {
  matching::Rank rank = asked.request->rank(offer.entry, match);
  if (!offer.is_living) rank.key = last_key;
  return rank;
}

PublicationEntry Demand::offer_for(const SubscriptionEntry& request) const {
  PublicationEntry offer = offer_.entry;
  if (offer_.is_any_mode) offer.publication.mode = request.subscription.mode;
  return offer;
}

bool Demand::proceed(Piece& piece) {
  if (!is_walked_) {
    std::uint64_t postponed = overlaps_.counts().postponed;
    is_walked_ = matcher_.search().examine_requests(
        last_, offer_.entry, [&](const SubscriptionEntry& request, const matching::Finding& finding) {
          piece.look_at_one();
          if (std::exchange(postponed, overlaps_.counts().postponed) != postponed) return false;
          look(request, finding);
          last_ = request.key;
          return !piece.is_full();
        });
    if (!is_walked_) return false;
  }
  for (; !undecided_.empty(); undecided_.pop_back()) {
    if (piece.is_full()) return false;
    const auto* request = matcher_.subscriptions().find_entry(undecided_.back());
    if (request == nullptr) continue;
    if (!survey_) {
      Asked asked{.entry = *request, .request = matcher_.examination().prepare(*request)};
      const auto finding = matcher_.examination().examine(asked.entry, *asked.request, offer_for(*request));
      if (!finding.match) continue;
      const matching::Rank rank = rank_of(asked, offer_, *finding.match);
      survey_.emplace(matcher_, overlaps_, std::move(asked), rank);
    }
    if (!survey_->proceed(piece)) return false;
    note(request->key, survey_->ahead() < matching::counted_limit(*request));
    survey_.reset();
  }
  return true;
}

void Demand::look(const SubscriptionEntry& request, matching::Finding finding) {
  ++seen_;
  if (offer_.is_any_mode) finding.is_mode_met = true;
  if (finding.meets()) {
    ++matching_;
    const Taking answer = taking(request, finding.match.value_or(matching::Match{}));
    if (answer != Taking::unknown) {
      note(request.key, answer == Taking::yes);
    } else if (undecided_.size() < max_ranked_requests) {
      undecided_.insert(undecided_.begin(), request.key);
    } else {
      note(request.key, false);
    }
    return;
  }
  nearest_.consider(request.key, request.subscription.identity, finding);
}

/// A newcomer must be better than the last that is chosen.
Demand::Taking Demand::taking(const SubscriptionEntry& request, const matching::Match& match) const {
  const std::size_t limit = matching::counted_limit(request);
  if (limit == 0) return Taking::yes;
  const auto chosen = matcher_.choices().known(request);
  if (!chosen) return Taking::unknown;
  if (offer_.is_living) {
    return std::ranges::find(*chosen, offer_.entry.key) != chosen->end() ? Taking::yes : Taking::no;
  }
  if (chosen->size() < limit) return Taking::yes;
  const Asked asked{.entry = request, .request = matcher_.examination().prepare(request)};
  const matching::Rank rank = rank_of(asked, offer_, match);
  // Here the best is first; what another host has announced is in no such order.
  const bool is_ranked = request.is_local || request.subscription.chosen.empty();
  const std::span<const ServiceKey> last(is_ranked ? std::prev(chosen->end()) : chosen->begin(), chosen->end());
  const bool is_pushed_out = std::ranges::any_of(last, [&](const ServiceKey& key) {
    const auto* incumbent = matcher_.publications().find_entry(key);
    if (incumbent == nullptr) return true;
    const auto other = matcher_.examination().meets(request, *asked.request, *incumbent);
    return !other ||
           matching::is_better_by(asked.request->preferences.margins(), rank, asked.request->rank(*incumbent, *other));
  });
  return is_pushed_out ? Taking::yes : Taking::no;
}

void Demand::note(const ServiceKey& request, bool is_taken) {
  if (is_taken) ++taken_;
  auto& list = is_taken ? takers_ : others_;
  if (list.size() < max_told_matches) list.push_back(request);
}

}  // namespace geminga::participant
