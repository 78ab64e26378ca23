#include "discovery/membership/schedule/repairs.hpp"

#include <utility>

#include "discovery/announcement/limits.hpp"

namespace geminga::membership {

using base::Instant;
using base::never;

void Repairs::lacked(Instant earliest, Pace& pace, Instant now) {
  if (!lacked_last_ || now - *lacked_last_ >= announcement::hold_intervals * pace.said_interval()) lacked_since_ = now;
  lacked_last_ = now;
  // A participant that goes on asking may hold us for contested.
  if (now - *lacked_since_ >= pace.said_interval() / 2) insist(pace, now);
  if (repair_.due != never || !repair_.budget.has(now)) return;
  repair_.due = std::max(now + pace.within(max_repair_delay), earliest);
}

void Repairs::insist(const Pace& pace, Instant now) {
  insistent_until_ = std::max(insistent_until_, now + announcement::contest_intervals * pace.said_interval());
}

void Repairs::contradict(Instant now) {
  if (contradiction_.budget.has(now)) contradiction_.due = std::min(contradiction_.due, now);
}

TokenBucket* Repairs::take_due(Instant now) {
  const bool is_repair = repair_.due <= now && repair_.budget.has(now);
  if (repair_.due <= now) repair_.due = never;
  if (contradiction_.due <= now) {
    contradiction_.due = never;
    return &contradiction_.budget;
  }
  return is_repair ? &repair_.budget : nullptr;
}

}  // namespace geminga::membership
