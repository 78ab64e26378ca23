#include "discovery/membership/neighbour/life_signs.hpp"

#include "discovery/announcement/limits.hpp"

namespace geminga::membership {

using base::Duration;
using base::Instant;

void LifeSigns::renew(Duration interval, const Reception& reception) {
  is_doubted_ = false;
  is_unasked_ = false;
  deadline_ = seen() + patience(interval, reception);
}

bool LifeSigns::witness(Instant seen, Instant now, Duration interval, const Reception& reception) {
  if (seen <= this->seen() || now - heard_ >= witnessed_intervals * interval) return false;
  if (succeeded_ && heard_ <= *succeeded_ && seen <= *succeeded_)
    return false;  // a sign of the incarnation that seems over
  witnessed_ = seen;
  is_doubted_ = is_doubted_ && doubt_due(interval) <= now;
  deadline_ = std::max(deadline_, seen + patience(interval, reception));
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

Instant LifeSigns::doubt_due(Duration interval) const { return after_intervals(seen(), interval, doubt_after); }

}  // namespace geminga::membership
