// The rules of the schedule: copies of a change, the interval, answers to others, and the limits on all of them.
#include "discovery/membership/schedule.hpp"

#include <algorithm>

#include "base/assert.hpp"

namespace geminga::membership {

using base::Duration;
using base::Instant;
using base::never;

Schedule::Schedule(ScheduleOptions options, std::uint64_t seed)
    : options_(options),
      random_(seed),
      newcomers_(answer_capacity, answer_refill_intervals * options.interval),
      contradictions_(contradiction_capacity, options.interval / contradictions_per_interval) {
  GEMINGA_ASSERT(options_.interval >= std::chrono::milliseconds(1));
}

Duration Schedule::spread(Duration time, double share) {
  const auto reach = Duration(static_cast<Duration::rep>(static_cast<double>(time.count()) * share));
  return random_.between(time - reach, time + reach);
}

void Schedule::changed(Instant now) {
  if (is_stopping_) return;
  is_running_ = true;
  copies_[0] = now;
  for (std::size_t i = 0; i < repeat_delays.size(); ++i) copies_[i + 1] = now + spread(repeat_delays[i], repeat_jitter);
  next_copy_ = 0;
}

void Schedule::set_size(std::size_t datagrams) { size_ = std::max<std::int64_t>(1, std::int64_t(datagrams)); }

void Schedule::newcomer(Instant now) {
  if (!is_running_ || newcomer_due_ != never) return;
  // Two copies that are still to come reach the newcomer as well as copies of its own would.
  const auto remaining = (change_copies - next_copy_) + (answer_copies - next_answer_);
  if (remaining >= 2) return;
  newcomer_due_ = now + random_.between(Duration::zero(), max_newcomer_delay);
  if (had_newcomer_) newcomer_due_ = std::max(newcomer_due_, newcomer_last_ + newcomer_spacing);
}

void Schedule::contested(Instant now) {
  if (is_running_) contested_ = std::min(contested_, now);
}

void Schedule::contradict(Instant now) {
  if (is_running_ && contradictions_.has(now)) contradiction_ = std::min(contradiction_, now);
}

void Schedule::pause() {
  is_running_ = false;
  next_copy_ = change_copies;
  next_answer_ = answer_copies;
  periodic_ = never;
  contested_ = never;
  contradiction_ = never;
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
  const auto copy = next_copy_ < change_copies ? copies_[next_copy_] : never;
  const auto answer = next_answer_ < answer_copies ? answers_[next_answer_] : never;
  return std::min({copy, answer, periodic_, contradiction_, newcomer_due_});
}

Instant Schedule::spaced() const { return has_sent_ ? last_sent_ + min_spacing : Instant::min(); }

Instant Schedule::allowed() const { return std::max(spaced(), announcements_.due()); }

Instant Schedule::due() const {
  if (is_stopping_) return goodbye_due_;
  const auto state = wanted();
  const auto presence = contested_ == never ? never : std::max({contested_, spaced(), contests_.due()});
  return std::min(state == never ? never : std::max(state, allowed()), presence);
}

bool Schedule::take_state(Instant now) {
  if (std::max(wanted(), allowed()) > now) return false;
  const auto own = std::min(periodic_, next_copy_ < change_copies ? copies_[next_copy_] : never);
  if (newcomer_due_ <= now) {
    newcomer_due_ = never;
    newcomer_last_ = now;
    had_newcomer_ = true;
    answers_[0] = now;
    for (std::size_t i = 0; i < answer_delays.size(); ++i)
      answers_[i + 1] = now + spread(answer_delays[i], repeat_jitter);
    next_answer_ = 0;
  }
  const bool is_answer = next_answer_ < answer_copies && answers_[next_answer_] <= now && newcomers_.has(now);
  const bool is_contradiction = contradiction_ <= now;
  // Whatever was due until now is told by this one announcement, or cannot be afforded.
  while (next_copy_ < change_copies && copies_[next_copy_] <= now) ++next_copy_;
  while (next_answer_ < answer_copies && answers_[next_answer_] <= now) ++next_answer_;
  if (is_contradiction) contradiction_ = never;
  if (own > now) {
    if (!is_answer && !is_contradiction) return false;
    // What is said for others' sake alone is paid from their budget.
    if (is_contradiction) {
      contradictions_.take(now, size_);
    } else {
      newcomers_.take(now, size_);
    }
  }
  announcements_.take(now);
  periodic_ = now + spread(options_.interval, interval_jitter);
  return true;
}

Schedule::Say Schedule::take(Instant now) {
  if (due() > now) return Say::nothing;
  if (is_stopping_) {
    --goodbyes_left_;
    goodbye_due_ = goodbyes_left_ == 0 ? never : now + goodbye_spacing;
    return Say::goodbye;
  }
  const bool is_state = take_state(now);
  const bool is_presence = !is_state && contested_ <= now && spaced() <= now && contests_.has(now);
  if (!is_state && !is_presence) return Say::nothing;
  if (is_presence) contests_.take(now);
  contested_ = never;
  last_sent_ = now;
  has_sent_ = true;
  return is_state ? Say::state : Say::presence;
}

bool Schedule::is_finished() const { return is_stopping_ && goodbyes_left_ == 0; }

}  // namespace geminga::membership
