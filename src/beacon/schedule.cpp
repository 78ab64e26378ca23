// The rules of the schedule: copies of a change, the interval, newcomers, and the limits on all of them.
#include "beacon/schedule.hpp"

#include <algorithm>

#include "base/assert.hpp"

namespace geminga::beacon {

using base::Duration;
using base::Instant;
using base::never;

Schedule::Schedule(ScheduleOptions options, std::uint64_t seed) : options_(options), random_(seed) {
  GEMINGA_ASSERT(options_.interval > Duration::zero());
}

Duration Schedule::spread(Duration time, double share) {
  const auto reach = Duration(static_cast<Duration::rep>(static_cast<double>(time.count()) * share));
  return random_.between(time - reach, time + reach);
}

void Schedule::begin_copies(Instant first) {
  copies_[0] = first;
  for (std::size_t i = 0; i < repeat_delays.size(); ++i)
    copies_[i + 1] = first + spread(repeat_delays[i], repeat_jitter);
  next_copy_ = 0;
}

void Schedule::changed(Instant now) {
  if (is_stopping_) return;
  is_running_ = true;
  begin_copies(now);
}

void Schedule::newcomer(Instant now) {
  if (!is_running_ || newcomer_due_ != never) return;
  // Two copies that are still to come reach the newcomer as well as copies of its own would.
  const auto remaining = copies_.size() - std::min(next_copy_, copies_.size());
  if (remaining >= 2) return;
  newcomer_due_ = now + random_.between(Duration::zero(), max_newcomer_delay);
  if (had_newcomer_) newcomer_due_ = std::max(newcomer_due_, newcomer_last_ + newcomer_spacing);
}

void Schedule::contested(Instant now) {
  if (is_running_) contested_ = std::min(contested_, now);
}

void Schedule::pause() {
  is_running_ = false;
  next_copy_ = copies_.size();
  periodic_ = never;
  contested_ = never;
  newcomer_due_ = never;
}

void Schedule::stop(Instant now) {
  if (is_stopping_) return;
  pause();
  is_stopping_ = true;
  goodbyes_left_ = goodbye_copies;
  goodbye_due_ = now;
}

Instant Schedule::wanted() const {
  const auto copy = next_copy_ < copies_.size() ? copies_[next_copy_] : never;
  return std::min({copy, periodic_, contested_, newcomer_due_});
}

Instant Schedule::allowed() const {
  if (!has_sent_) return Instant::min();
  const auto spaced = last_sent_ + min_spacing;
  return tokens_ > 0 ? spaced : std::max(spaced, refilled_ + refill_time);
}

void Schedule::refill(Instant now) {
  while (tokens_ < burst_capacity && refilled_ + refill_time <= now) {
    ++tokens_;
    refilled_ += refill_time;
  }
  if (tokens_ == burst_capacity) refilled_ = now;
}

Instant Schedule::due() const {
  if (is_stopping_) return goodbye_due_;
  const auto next = wanted();
  return next == never ? never : std::max(next, allowed());
}

bool Schedule::take(Instant now) {
  if (due() > now) return false;
  if (is_stopping_) {
    --goodbyes_left_;
    goodbye_due_ = goodbyes_left_ == 0 ? never : now + goodbye_spacing;
    return true;
  }
  refill(now);
  --tokens_;
  if (newcomer_due_ <= now) {
    newcomer_due_ = never;
    newcomer_last_ = now;
    had_newcomer_ = true;
    begin_copies(now);
  }
  // Whatever was due until now is told by this one announcement.
  while (next_copy_ < copies_.size() && copies_[next_copy_] <= now) ++next_copy_;
  contested_ = never;
  last_sent_ = now;
  has_sent_ = true;
  periodic_ = now + spread(options_.interval, interval_jitter);
  return true;
}

bool Schedule::is_finished() const { return is_stopping_ && goodbyes_left_ == 0; }

}  // namespace geminga::beacon
