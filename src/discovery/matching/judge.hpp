// The judge of pairs: whether a publication that is known meets a subscription, and what stands between them.
#ifndef GEMINGA_DISCOVERY_MATCHING_JUDGE_HPP
#define GEMINGA_DISCOVERY_MATCHING_JUDGE_HPP

#include <cstdint>

#include "discovery/matching/clashes.hpp"
#include "discovery/matching/directory.hpp"
#include "discovery/matching/meeting/obstacle.hpp"
#include "discovery/matching/meeting/request.hpp"

namespace geminga::matching {

/// Every pair is judged here, and counted.
class Judge {
 public:
  Judge(const Directory& directory, const Clashes& clashes) : directory_(directory), clashes_(clashes) {}

  /// A pair of entries that are known, by the edition of the subscription. What is about to be erased meets nothing.
  [[nodiscard]] Judgement judge(const registry::StoredSubscription& subscription,
                                const registry::StoredPublication& publication) const {
    if (directory_.offers().is_going(publication) || directory_.requests().is_going(subscription)) return {};
    return judge(subscription.entry, directory_.requests().request(subscription), publication,
                 directory_.requests().edition_of(subscription));
  }
  /// A publication that is known and a request made by the vocabulary of the edition.
  [[nodiscard]] Judgement judge(const registry::SubscriptionEntry& asked, const Request& request,
                                const registry::StoredPublication& publication, const Edition& edition) const;
  /// The finding about an offer and a request made by the vocabulary of the edition.
  [[nodiscard]] Finding examine(const registry::SubscriptionEntry& asked, const Request& request, const Offer& offer,
                                const Edition& edition) const;
  /// The offer with the description of its participant, where the request asks for that. Borrows both.
  [[nodiscard]] Offer described(Offer offer, const Request& request, const Edition& edition) const;
  /// Counts a pair that is judged elsewhere. Whether a clash of numbers keeps it apart.
  [[nodiscard]] bool is_kept_apart(const Identity& offered, const Identity& requested) const {
    ++judged_;
    return clashes_.is_kept_apart(offered, requested);
  }
  /// How many pairs were judged since the start.
  [[nodiscard]] std::uint64_t judged() const { return judged_; }

 private:
  const Directory& directory_;
  const Clashes& clashes_;
  mutable std::uint64_t judged_ = 0;
};

}  // namespace geminga::matching

#endif
