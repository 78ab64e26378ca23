#include "discovery/membership/schedule/schedule.hpp"

#include <algorithm>

#include "base/assert.hpp"

namespace geminga::membership {

using base::Duration;
using base::Instant;
using base::never;

Schedule::Schedule(ScheduleOptions options, std::uint64_t seed)
    : pace_(options.interval, seed),
      answers_(options.interval),
      repairs_(options.interval),
      presences_(options.interval) {
  GEMINGA_ASSERT(options.interval >= std::chrono::milliseconds(1));
}

void Schedule::changed(Say what, Instant now) {
  if (is_stopping_) return;
  is_running_ = true;
  if (copies_.next(Say::state) != never) what = Say::state;
  // A change that waited for the identifier is told when that comes.
  copies_.plan(what, last_sent_ ? copies_.gather(now) : now, loss_, pace_);
}

void Schedule::set_size(std::size_t datagrams) { size_ = std::max<std::int64_t>(1, std::int64_t(datagrams)); }

void Schedule::set_doublings(std::uint8_t doublings, Instant now) {
  if (!pace_.set_doublings(doublings) || periodic_ == never) return;
  periodic_ = std::min(periodic_, now + pace_.next_interval());
}

void Schedule::newcomer(Instant now) {
  if (is_running_) answers_.newcomer(copies_, pace_, now);
}

void Schedule::lacked(Instant now) {
  if (is_running_) repairs_.lacked(after_state(), pace_, now);
}

void Schedule::seems_lacked(Instant now) {
  if (copies_.next(Say::state) == never && copies_.next(Say::change) == never) lacked(now);
}

void Schedule::lacked_by_stranger(Instant now) {
  if (is_running_) answers_.lacked_by_stranger(after_state(), pace_, now);
}

void Schedule::ask(Questions open, Instant now) {
  if (is_running_) presences_.ask(open, pace_, now);
}

void Schedule::challenge(bool is_open, Instant now) {
  if (is_running_) presences_.challenge(is_open, pace_, now);
}

void Schedule::asked_by_another(Instant now) { presences_.asked_by_another(pace_, now); }

void Schedule::differ(Instant now) {
  if (is_running_) presences_.differ(last_sent_, pace_, now);
}

void Schedule::search(std::optional<Duration> spacing, Instant now) {
  presences_.search(is_running_ ? spacing : std::nullopt, pace_, now);
}

void Schedule::doubted(Instant now) {
  if (is_running_) presences_.doubted(last_sent_, now);
}

void Schedule::deny(Instant now) {
  if (is_running_) presences_.deny(pace_, now);
}

bool Schedule::bear_witness(Instant now) { return is_running_ && presences_.bear_witness(pace_, now); }

void Schedule::contested(Instant now) {
  if (is_running_) presences_.contested(now);
}

void Schedule::contradict(Instant now) {
  repairs_.insist(pace_, now);
  if (is_running_) repairs_.contradict(now);
}

void Schedule::pause() {
  is_running_ = false;
  periodic_ = never;
  copies_.clear();
  answers_.clear();
  repairs_.clear();
  presences_.clear();
}

void Schedule::stop(Instant now) {
  if (is_stopping_) return;
  pause();
  is_stopping_ = true;
  goodbyes_left_ = goodbye_copies;
  goodbye_due_ = now;
}

Instant Schedule::state_wanted() const {
  return std::min({copies_.next(Say::state), copies_.next(Say::change), answers_.due(), repairs_.due(),
                   is_insistent() ? periodic_ : never});
}

Instant Schedule::presence_wanted() const {
  return std::min({copies_.next(Say::presence), presences_.due(), is_insistent() ? never : periodic_});
}

Instant Schedule::spaced() const { return last_sent_ ? *last_sent_ + min_spacing : Instant::min(); }

Instant Schedule::allowed() const { return std::max(spaced(), announcements_.due()); }

Instant Schedule::after_state() const { return state_sent_ ? *state_sent_ + repair_spacing : Instant::min(); }

Instant Schedule::due() const {
  if (is_stopping_) return goodbye_due_;
  const auto state = state_wanted();
  const auto presence = presence_wanted();
  return std::min(state == never ? never : std::max(state, allowed()),
                  presence == never ? never : std::max(presence, spaced()));
}

Schedule::Say Schedule::take_state(Instant now) {
  if (std::max(state_wanted(), allowed()) > now) return Say::nothing;
  const auto own_state = std::min(is_insistent() ? periodic_ : never, copies_.next(Say::state));
  const bool is_change = copies_.next(Say::change) <= now;
  answers_.begin_due(copies_, loss_, pace_, now);
  // Everything that is due is said by this one announcement, or cannot be afforded.
  copies_.drop_told(now);
  TokenBucket* const of_answers = answers_.take_due(now);
  TokenBucket* const of_repairs = repairs_.take_due(now);
  if (own_state > now) {
    // An announcement for others' sake alone is paid from their budget.
    TokenBucket* const payer = of_repairs ? of_repairs : of_answers;
    if (!payer) {
      if (is_change) announcements_.take(now);
      return is_change ? Say::change : Say::nothing;
    }
    payer->take(now, size_);
  }
  announcements_.take(now);
  return Say::state;
}

bool Schedule::take_presence(Instant now) {
  if (std::max(presence_wanted(), spaced()) > now) return false;
  presences_.pay(now);
  copies_.drop_presences(now);
  return true;
}

Schedule::Say Schedule::take(Instant now) {
  if (due() > now) return Say::nothing;
  if (is_stopping_) {
    --goodbyes_left_;
    goodbye_due_ = goodbyes_left_ == 0 ? never : now + goodbye_spacing;
    return Say::goodbye;
  }
  auto told = take_state(now);
  if (told == Say::nothing) {
    if (!take_presence(now)) return Say::nothing;
    told = Say::presence;
    // State and change also show that we live and own the identifier. Only a presence carries what we ask.
    presences_.said(now);
  }
  presences_.announced(pace_, now);
  pace_.count_announcement();
  // A presence does not replace the state that is said each time.
  if (told == Say::state || !is_insistent()) periodic_ = now + pace_.next_interval();
  last_sent_ = now;
  if (told == Say::state) state_sent_ = now;
  return told;
}

bool Schedule::is_finished() const { return is_stopping_ && goodbyes_left_ == 0; }

}  // namespace geminga::membership
