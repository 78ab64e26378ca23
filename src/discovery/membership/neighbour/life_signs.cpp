#include "discovery/membership/neighbour/life_signs.hpp"

#include "discovery/announcement/limits.hpp"

namespace geminga::membership {

using base::Duration;
using base::Instant;

void LifeSigns::renew(Duration interval, const Reception& reception) {
  is_doubted_ = false;
  is_unasked_ = false;
  delay_ = reception.delay;
  const auto time = patience(interval, reception);
  latest_ = latest(interval, reception);
  deadline_ = std::min(seen() + time, latest_);
}

bool LifeSigns::witness(Instant seen, Instant now, Duration interval, const Reception& reception) {
  const auto time = patience(interval, reception);
  if (seen <= this->seen() || now >= latest(interval, reception)) return false;
  if (succeeded_ && heard_ <= *succeeded_ && seen <= *succeeded_)
    return false;  // a sign of the incarnation that seems over
  witnessed_ = seen;
  latest_ = latest(interval, reception);
  is_doubted_ = is_doubted_ && doubt_due(interval) <= now;
  deadline_ = std::max(deadline_, std::min(seen + time, latest_));
  return true;
}

void LifeSigns::succeed(Instant now, Duration interval) {
  if (succeeded_ && now - *succeeded_ < announcement::contest_intervals * interval) return;
  succeeded_ = now;
  is_doubted_ = true;
  is_unasked_ = true;
}

void LifeSigns::ask(Instant now, Duration patience) {
  if (is_unasked_) deadline_ = std::min(deadline_, now + patience);
  is_unasked_ = false;
}

Instant LifeSigns::doubt_due(Duration interval) const {
  const auto unseen = after_intervals(seen(), interval, doubt_after) + delay_;
  // Whoever is only heard of must be heard in the end.
  return latest_ == base::never ? unseen : std::min(unseen, after_intervals(latest_, interval, -asked_before_latest));
}

}  // namespace geminga::membership
