#include "discovery/membership/schedule/answers.hpp"

#include <algorithm>

#include "discovery/membership/schedule/repairs.hpp"

namespace geminga::membership {

using base::Duration;
using base::Instant;
using base::never;

void Answers::newcomer(const Copies& copies, Pace& pace, Instant now) {
  if (newcomer_due_ != never) return;
  // Two copies that are still to come reach the newcomer as well as its own copies would.
  if (copies.states() + copies_.size() >= 2) return;
  newcomer_due_ = now + pace.within(pace.slowed(max_newcomer_delay));
  if (newcomer_begun_) newcomer_due_ = std::max(newcomer_due_, *newcomer_begun_ + pace.slowed(newcomer_spacing));
}

void Answers::lacked_by_stranger(Instant earliest, Pace& pace, Instant now) {
  if (!budget_.has(now)) return;
  const auto due = std::max(now + pace.within(max_repair_delay), earliest);
  if (copies_.empty() || due < copies_.front()) copies_.insert(copies_.begin(), due);
}

Instant Answers::due() const { return copies_.empty() ? newcomer_due_ : std::min(copies_.front(), newcomer_due_); }

void Answers::begin_due(Copies& copies, std::optional<double> loss, Pace& pace, Instant now) {
  if (newcomer_due_ > now) return;
  newcomer_due_ = never;
  newcomer_begun_ = now;
  copies_ = {now};
  const auto answer = [&](Duration delay) { copies_.push_back(now + pace.spread(pace.slowed(delay), repeat_jitter)); };
  if (loss.value_or(0) < bad_loss) {
    std::ranges::for_each(answer_delays, answer);
  } else {
    std::ranges::for_each(bad_answer_delays, answer);
  }
  if (copies.next(Say::presence) <= now + answer_presence_delays.back() || !budget_.has(now)) return;
  for (const Duration delay : answer_presence_delays) {
    copies.add_presence(now + pace.spread(pace.slowed(delay), repeat_jitter));
    budget_.take(now);
    if (loss && state_copies(loss) < 5) break;
  }
}

TokenBucket* Answers::take_due(Instant now) {
  const bool is_due = !copies_.empty() && copies_.front() <= now;
  std::erase_if(copies_, [now](Instant due) { return due <= now; });
  return is_due && budget_.has(now) ? &budget_ : nullptr;
}

void Answers::clear() {
  copies_.clear();
  newcomer_due_ = never;
}

}  // namespace geminga::membership
