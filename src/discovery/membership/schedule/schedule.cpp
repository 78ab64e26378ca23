#include "discovery/membership/schedule/schedule.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include "base/assert.hpp"
#include "discovery/announcement/limits.hpp"
#include "discovery/membership/schedule/deadline.hpp"

namespace geminga::membership {

using base::Duration;
using base::Instant;
using base::never;

Schedule::Schedule(ScheduleOptions options, std::uint64_t seed)
    : options_(options),
      random_(seed),
      interval_(options.interval),
      newcomers_(answer_capacity, answer_refill_intervals * options.interval),
      repairs_(repair_capacity, options.interval / repairs_per_interval),
      lacks_{base::never, {ask_capacity, options.interval / asks_per_interval}},
      doubts_{base::never, {ask_capacity, options.interval / asks_per_interval}},
      challenges_{base::never, {ask_capacity, options.interval / asks_per_interval}},
      differs_{base::never, {differing_capacity, options.interval}},
      searches_(search_capacity, search_refill_intervals * options.interval),
      proofs_(proof_capacity, options.interval / proofs_per_interval),
      contradictions_(contradiction_capacity, options.interval / contradictions_per_interval) {
  GEMINGA_ASSERT(options_.interval >= std::chrono::milliseconds(1));
}

Duration Schedule::spread(Duration time, double share) {
  const auto reach = Duration(static_cast<Duration::rep>(static_cast<double>(time.count()) * share));
  return random_.between(time - reach, time + reach);
}

std::size_t state_copies(std::optional<double> loss) {
  if (!loss) return 4;
  if (*loss < 0.005) return 1;
  if (*loss < 0.02) return 2;
  if (*loss < 0.15) return 3;
  return *loss < bad_loss ? 5 : 7;
}

void Schedule::changed(Say what, Instant now) {
  if (is_stopping_) return;
  is_running_ = true;
  if (next_copy(Say::state) != never) what = Say::state;
  const auto said = state_copies(loss_);
  const auto all = said + (loss_ ? std::min(said, presence_copies) : unknown_presence_copies);
  const auto first = first_copy(now);
  copies_ = {{first, what}};
  for (std::size_t i = 1; i < all; ++i) {
    copies_.push_back({first + spread(repeat_delays[i - 1], repeat_jitter), i < said ? what : Say::presence});
  }
  const auto show = [&](Duration delay) { copies_.push_back({first + spread(delay, repeat_jitter), Say::presence}); };
  if (loss_.value_or(0) >= bad_loss) std::ranges::for_each(bad_presence_delays, show);
  std::ranges::for_each(std::span(late_presence_delays).first(doublings_), show);
  std::ranges::sort(copies_, {}, &Copy::due);
}

Instant Schedule::first_copy(Instant now) {
  if (!has_sent_) return now;  // what waited for the identifier is said when it comes
  if (std::exchange(is_change_pending_, true)) return *change_due_;
  if (!change_due_ || now - *change_due_ >= change_wait_) {
    change_due_ = now;
    change_wait_ = change_spacing;
  } else if (now >= *change_due_) {
    *change_due_ += change_wait_;
    change_wait_ = std::min(2 * change_wait_, longest_change_spacing);
  }
  return *change_due_;
}

void Schedule::set_size(std::size_t datagrams) { size_ = std::max<std::int64_t>(1, std::int64_t(datagrams)); }

void Schedule::set_doublings(std::uint8_t doublings, Instant now) {
  if (doublings == doublings_) return;
  doublings_ = doublings;
  const bool is_slower = said_interval() > interval_;
  announced_until_slower_ = is_slower ? announced_before_slower : 0;
  if (said_interval() >= interval_) return;
  interval_ = said_interval();
  if (periodic_ != never) periodic_ = std::min(periodic_, now + spread(interval_, interval_jitter));
}

void Schedule::newcomer(Instant now) {
  if (!is_running_ || newcomer_due_ != never) return;
  // Two copies that are still to come reach the newcomer as well as its own copies would.
  const auto copies = std::ranges::count(copies_, Say::state, &Copy::what);
  const auto remaining = static_cast<std::size_t>(copies) + answers_.size();
  if (remaining >= 2) return;
  newcomer_due_ = now + random_.between(Duration::zero(), slowed(max_newcomer_delay));
  if (had_newcomer_) newcomer_due_ = std::max(newcomer_due_, newcomer_last_ + slowed(newcomer_spacing));
}

void Schedule::lacked(Instant now) {
  if (!is_running_) return;
  if (now - lacked_last_ >= announcement::hold_intervals * said_interval()) lacked_since_ = now;
  lacked_last_ = now;
  // Whoever goes on asking may hold us for contested.
  if (now - lacked_since_ >= said_interval() / 2) {
    insistent_until_ = std::max(insistent_until_, now + announcement::contest_intervals * said_interval());
  }
  if (repair_ != never || !repairs_.has(now)) return;
  repair_ = now + random_.between(Duration::zero(), max_repair_delay);
  // The state that was sent last may not have reached the one that asks yet.
  if (has_sent_) repair_ = std::max(repair_, state_sent_ + repair_spacing);
}

void Schedule::seems_lacked(Instant now) {
  if (next_copy(Say::state) == never && next_copy(Say::change) == never) lacked(now);
}

void Schedule::lacked_by_stranger(Instant now) {
  if (!is_running_ || !newcomers_.has(now)) return;
  auto due = now + random_.between(Duration::zero(), max_repair_delay);
  if (has_sent_) due = std::max(due, state_sent_ + repair_spacing);
  if (answers_.empty() || due < answers_.front()) answers_.insert(answers_.begin(), due);
}

void Schedule::plan(Question& question, bool is_open, Duration spacing, Instant now) {
  if (!is_open || !is_running_) {
    question.due = never;
  } else if (question.due == never) {
    question.due = now + random_.between(Duration::zero(), slowed(max_ask_delay));
    if (question.asked) question.due = std::max(question.due, *question.asked + slowed(spacing));
  }
}

void Schedule::ask(bool lacks, bool doubts, Instant now) {
  plan(lacks_, lacks, lack_spacing, now);
  plan(doubts_, doubts, ask_spacing, now);
}

void Schedule::challenge(bool is_open, Instant now) { plan(challenges_, is_open, ask_spacing, now); }

void Schedule::asked_by_another(Instant now) {
  if (doubts_.due == never) return;
  doubts_.due =
      std::max(doubts_.due, now + slowed(ask_spacing) + random_.between(Duration::zero(), slowed(max_ask_delay)));
}

void Schedule::differ(Instant now) {
  if (!is_running_ || differs_.due != never || !differs_.budget.has(now)) return;
  differs_.due =
      std::max(now, last_sent_ + slowed(differing_spacing)) + random_.between(Duration::zero(), slowed(max_ask_delay));
}

void Schedule::search(std::optional<Duration> spacing, Instant now) {
  search_spacing_ = is_running_ ? spacing : std::nullopt;
  if (!search_spacing_) {
    search_ = never;
  } else if (search_ == never) {
    search_ = now + random_.between(Duration::zero(), *search_spacing_);
  }
}

void Schedule::doubted(Instant now) {
  if (is_running_) proof_ = std::min(proof_, has_sent_ ? std::max(now, last_sent_ + proof_spacing) : now);
}

void Schedule::deny(Instant now) {
  if (!is_running_ || (denied_ && now - *denied_ < announcement::contest_intervals * said_interval())) return;
  denied_ = denial_ = now;
  denials_left_ = denials;
}

bool Schedule::bear_witness(Instant now) {
  if (!is_running_) return false;
  const bool is_first = testimony_ == never;
  testimony_ = std::min(testimony_, now + slowed(random_.between(witness_delay, 2 * witness_delay)));
  return is_first;
}

void Schedule::contested(Instant now) {
  if (is_running_) contested_ = std::min(contested_, now);
}

void Schedule::contradict(Instant now) {
  insistent_until_ = now + announcement::contest_intervals * said_interval();
  if (is_running_ && contradictions_.has(now)) contradiction_ = std::min(contradiction_, now);
}

void Schedule::pause() {
  is_running_ = false;
  is_change_pending_ = false;
  copies_.clear();
  answers_.clear();
  periodic_ = never;
  repair_ = never;
  lacks_.due = never;
  doubts_.due = never;
  challenges_.due = never;
  differs_.due = never;
  search_ = never;
  proof_ = never;
  testimony_ = never;
  denial_ = never;
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

Instant Schedule::next_copy(Say what) const {
  const auto copy = std::ranges::find(copies_, what, &Copy::what);
  return copy == copies_.end() ? never : copy->due;
}

Instant Schedule::state_wanted() const {
  const auto answer = answers_.empty() ? never : answers_.front();
  const auto periodic = is_insistent() ? periodic_ : never;
  return std::min(
      {next_copy(Say::state), next_copy(Say::change), answer, periodic, repair_, contradiction_, newcomer_due_});
}

Instant Schedule::presence_wanted() const {
  const auto limited = [](Instant wanted, const TokenBucket& budget) {
    return wanted == never ? never : std::max(wanted, budget.due());
  };
  const auto periodic = is_insistent() ? never : periodic_;
  return std::min({next_copy(Say::presence), periodic, limited(search_, searches_), denial_,
                   limited(lacks_.due, lacks_.budget), limited(doubts_.due, doubts_.budget),
                   limited(differs_.due, differs_.budget), limited(challenges_.due, challenges_.budget),
                   limited(std::min(proof_, testimony_), proofs_), limited(contested_, contests_)});
}

Instant Schedule::spaced() const { return has_sent_ ? last_sent_ + min_spacing : Instant::min(); }

Instant Schedule::allowed() const { return std::max(spaced(), announcements_.due()); }

Instant Schedule::due() const {
  if (is_stopping_) return goodbye_due_;
  const auto state = state_wanted();
  const auto presence = presence_wanted();
  return std::min(state == never ? never : std::max(state, allowed()),
                  presence == never ? never : std::max(presence, spaced()));
}

void Schedule::begin_answers(Instant now) {
  newcomer_due_ = never;
  newcomer_last_ = now;
  had_newcomer_ = true;
  answers_ = {now};
  const auto answer = [&](Duration delay) { answers_.push_back(now + spread(slowed(delay), repeat_jitter)); };
  if (loss_.value_or(0) < bad_loss) {
    std::ranges::for_each(answer_delays, answer);
  } else {
    std::ranges::for_each(bad_answer_delays, answer);
  }
  if (next_copy(Say::presence) > now + answer_presence_delays.back() && newcomers_.has(now)) {
    for (const Duration delay : answer_presence_delays) {
      copies_.push_back({now + spread(slowed(delay), repeat_jitter), Say::presence});
      newcomers_.take(now);
      if (loss_ && state_copies(loss_) < 5) break;
    }
    std::ranges::sort(copies_, {}, &Copy::due);
  }
}

void Schedule::drop_copies(bool is_presence, Instant now) {
  if (!is_presence && change_due_ && *change_due_ <= now) is_change_pending_ = false;
  std::erase_if(copies_,
                [&](const Copy& copy) { return (copy.what == Say::presence) == is_presence && copy.due <= now; });
}

Schedule::Say Schedule::take_state(Instant now) {
  if (std::max(state_wanted(), allowed()) > now) return Say::nothing;
  const auto own_state = std::min(is_insistent() ? periodic_ : never, next_copy(Say::state));
  const bool is_change = next_copy(Say::change) <= now;
  if (newcomer_due_ <= now) begin_answers(now);
  const bool is_answer = !answers_.empty() && answers_.front() <= now && newcomers_.has(now);
  const bool is_repair = repair_ <= now && repairs_.has(now);
  const bool is_contradiction = contradiction_ <= now;
  // Everything that is due is said by this one announcement, or cannot be afforded.
  drop_copies(false, now);
  std::erase_if(answers_, [now](Instant due) { return due <= now; });
  if (repair_ <= now) repair_ = never;
  if (is_contradiction) contradiction_ = never;
  if (own_state > now) {
    if (!is_answer && !is_repair && !is_contradiction) {
      if (is_change) announcements_.take(now);
      return is_change ? Say::change : Say::nothing;
    }
    // An announcement for others' sake alone is paid from their budget.
    if (is_contradiction) {
      contradictions_.take(now, size_);
    } else if (is_repair) {
      repairs_.take(now, size_);
    } else {
      newcomers_.take(now, size_);
    }
  }
  announcements_.take(now);
  return Say::state;
}

bool Schedule::take_presence(Instant now) {
  if (std::max(presence_wanted(), spaced()) > now) return false;
  const auto pay = [now](Instant wanted, TokenBucket& budget) {
    if (wanted <= now && budget.has(now)) budget.take(now);
  };
  pay(lacks_.due, lacks_.budget);
  pay(doubts_.due, doubts_.budget);
  pay(challenges_.due, challenges_.budget);
  pay(differs_.due, differs_.budget);
  pay(std::min(proof_, testimony_), proofs_);
  pay(contested_, contests_);
  pay(search_, searches_);
  if (denial_ <= now) denial_ = --denials_left_ > 0 ? now + denial_spacing : never;
  drop_copies(true, now);
  return true;
}

Schedule::Say Schedule::take(Instant now) {
  if (due() > now) return Say::nothing;
  if (is_stopping_) {
    --goodbyes_left_;
    goodbye_due_ = goodbyes_left_ == 0 ? never : now + goodbye_spacing;
    return Say::goodbye;
  }
  const auto told = take_state(now);
  const bool is_state = told == Say::state;
  if (told == Say::nothing && !take_presence(now)) return Say::nothing;
  // State and change also show that we live and own the identifier. Only a presence carries what we ask.
  if (told == Say::nothing) {
    for (Question* question : {&lacks_, &doubts_, &challenges_}) {
      if (std::exchange(question->due, never) != never) question->asked = now;
    }
    testimony_ = never;
  }
  if (search_spacing_) search_ = now + spread(*search_spacing_, interval_jitter);
  proof_ = differs_.due = never;
  contested_ = never;
  if (announced_until_slower_ > 0 && --announced_until_slower_ == 0) interval_ = said_interval();
  // A presence does not replace the state that is said each time.
  if (is_state || !is_insistent()) periodic_ = now + spread(interval_, interval_jitter);
  last_sent_ = now;
  if (is_state) state_sent_ = now;
  has_sent_ = true;
  return told == Say::nothing ? Say::presence : told;
}

bool Schedule::is_finished() const { return is_stopping_ && goodbyes_left_ == 0; }

}  // namespace geminga::membership
