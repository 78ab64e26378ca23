// What each sign of life, and each word about one, does to a deadline.
#include "discovery/membership/life_signs.hpp"

#include "discovery/announcement/limits.hpp"

namespace geminga::membership {

using base::Duration;
using base::Instant;

Instant LifeSigns::deadline_of(Instant seen, Duration interval, double loss) const {
  return seen + patience(interval, {.loss = loss, .witnesses = std::max(witnesses_, witnesses_before_)});
}

void LifeSigns::renew(Duration interval, double loss) {
  is_doubted_ = false;
  is_unasked_ = false;
  deadline_ = deadline_of(seen(), interval, loss);
}

bool LifeSigns::witness(std::optional<Instant> seen, Instant now, Duration interval, double loss, bool counts) {
  if (now - counted_from_ >= interval) {
    witnesses_before_ = now - counted_from_ >= 2 * interval ? 0 : witnesses_;
    witnesses_ = 0;
    counted_from_ = now;
  }
  ++witnesses_;
  if (!counts || !seen || *seen <= this->seen() || now - heard_ >= witnessed_intervals * interval) return false;
  if (succeeded_ && heard_ <= *succeeded_ && *seen <= *succeeded_) return false;  // a sign of the life that seems over
  witnessed_ = *seen;
  is_doubted_ = is_doubted_ && doubt_due(interval) <= now;
  deadline_ = std::max(deadline_, deadline_of(*seen, interval, loss));
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

announcement::HeardWithin LifeSigns::heard_within(Instant now, Duration interval) const {
  const auto age = now - heard_;
  if (age > interval) return announcement::HeardWithin::longer;
  if (age > interval / 2) return announcement::HeardWithin::interval;
  return age > interval / 4 ? announcement::HeardWithin::half : announcement::HeardWithin::quarter;
}

Instant LifeSigns::doubt_due(Duration interval) const { return after_intervals(seen(), interval, doubt_after); }

}  // namespace geminga::membership
