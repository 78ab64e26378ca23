// The subscriptions that must be judged anew because a converter has come or gone.
#ifndef GEMINGA_DISCOVERY_MATCHING_STALE_REQUESTS_HPP
#define GEMINGA_DISCOVERY_MATCHING_STALE_REQUESTS_HPP

#include <cstddef>

#include "discovery/matching/directory.hpp"
#include "discovery/matching/editions.hpp"
#include "discovery/matching/pairs.hpp"

namespace geminga::matching {

/// Requests that are judged at once where a converter has come or gone; the others in steps.
inline constexpr std::size_t max_rejudged_at_once = 64;

/// Until it is judged, a stale subscription keeps what it was given.
class StaleRequests {
 public:
  StaleRequests(const Editions& editions, const Directory& directory, Pairs& pairs)
      : editions_(editions), directory_(directory), pairs_(pairs) {}

  [[nodiscard]] bool is_empty() const;
  /// Judges a subscription if it is stale.
  void judge(const registry::StoredSubscription& subscription);
  /// Judges the next one. False: there is none.
  bool judge_next();
  /// Judges as many as may be judged at once.
  void judge_some();

 private:
  const Editions& editions_;
  const Directory& directory_;
  Pairs& pairs_;
};

}  // namespace geminga::matching

#endif
