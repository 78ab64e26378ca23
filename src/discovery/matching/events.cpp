#include "discovery/matching/events.hpp"

namespace geminga::matching {

using registry::StoredPublication;
using registry::StoredSubscription;

void Events::tell(const StoredSubscription& subscription, const Verdict& verdict, const Cause& cause) {
  const auto tell_gone = [&](const Verdict::Gone& gone) {
    tell_consumer(Change::del, subscription, *gone.publication, gone.told, gone.reason, cause);
    tell_provider(Change::del, subscription, *gone.publication, gone.told, gone.reason, cause);
  };
  for (const auto& gone : verdict.gone) tell_gone(gone);
  for (const auto& kept : verdict.kept) {
    if (kept.told != kept.match || cause.modifies(*kept.publication)) {
      tell_consumer(Change::modify, subscription, *kept.publication, kept.match, Reason::withdrawn, cause);
    }
    // A provider is told what it gives, and not how that is converted.
    const bool is_other_gift = kept.told.degree != kept.match.degree || kept.told.distance != kept.match.distance;
    if (is_other_gift || cause.modifies(subscription)) {
      tell_provider(Change::modify, subscription, *kept.publication, kept.match, Reason::withdrawn, cause);
    }
  }
  for (const auto& come : verdict.come) {
    tell_consumer(Change::add, subscription, *come.publication, come.match, Reason::withdrawn, cause);
    tell_provider(Change::add, subscription, *come.publication, come.match, Reason::withdrawn, cause);
  }
  // Last, so that a consumer has the better one before the worse one goes, and is never without.
  for (const auto& gone : verdict.outranked) tell_gone(gone);
}

void Events::tell_end(const StoredSubscription& subscription, const std::vector<Verdict::Come>& chosen, Reason reason,
                      const Cause& cause) {
  for (const auto& one : chosen) {
    tell_provider(Change::del, subscription, *one.publication, one.match, reason, cause);
  }
}

void Events::tell_consumer(Change change, const StoredSubscription& subscription, const StoredPublication& publication,
                           Match match, Reason reason, const Cause& cause) {
  if (!subscription.entry.is_local || cause.untold == &subscription) return;
  const bool is_over = change == Change::del;
  const auto& about = is_over ? cause.as_told(publication) : publication.kept;
  auto chain = is_over || match.cost == 0 ? nullptr : directory_.chain(subscription, publication);
  events_.push_back({change, subscription.entry.key, about, match, reason, std::move(chain)});
}

void Events::tell_provider(Change change, const StoredSubscription& subscription, const StoredPublication& publication,
                           Match match, Reason reason, const Cause& cause) {
  if (!publication.entry.is_local || directory_.offers().is_going(publication)) return;
  const bool is_over = change == Change::del;
  const ChannelMode mode = is_over ? cause.as_told(publication)->publication.mode : publication.entry.publication.mode;
  if (!is_provider_told(mode)) return;
  const auto& about = is_over ? cause.as_told(subscription) : subscription.kept;
  events_.push_back({change, publication.entry.key, about, match, reason, {}});
}

}  // namespace geminga::matching
