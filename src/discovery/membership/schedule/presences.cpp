#include "discovery/membership/schedule/presences.hpp"

#include <utility>

#include "discovery/announcement/limits.hpp"
#include "discovery/membership/schedule/deadline.hpp"

namespace geminga::membership {

using base::Duration;
using base::Instant;
using base::never;

Presences::Presences(Duration interval)
    : lacks_{{{ask_capacity, interval / asks_per_interval}}},
      doubts_{lacks_},
      challenges_{lacks_},
      differs_{{differing_capacity, interval}},
      searches_{{search_capacity, search_refill_intervals * interval}},
      proof_{{proof_capacity, interval / proofs_per_interval}},
      contested_{{contest_capacity, contest_refill}} {}

void Presences::plan(Question& question, bool is_open, Duration spacing, Pace& pace, Instant now) {
  if (!is_open) {
    question.due = never;
  } else if (question.due == never) {
    question.due = now + pace.within(pace.slowed(max_ask_delay));
    if (question.asked) question.due = std::max(question.due, *question.asked + pace.slowed(spacing));
  }
}

void Presences::ask(Questions open, Pace& pace, Instant now) {
  plan(lacks_, open.lacks, lack_spacing, pace, now);
  plan(doubts_, open.doubts, ask_spacing, pace, now);
}

void Presences::challenge(bool is_open, Pace& pace, Instant now) { plan(challenges_, is_open, ask_spacing, pace, now); }

void Presences::asked_by_another(Pace& pace, Instant now) {
  if (doubts_.due == never) return;
  doubts_.due = std::max(doubts_.due, now + pace.slowed(ask_spacing) + pace.within(pace.slowed(max_ask_delay)));
}

void Presences::differ(std::optional<Instant> last_sent, Pace& pace, Instant now) {
  if (differs_.due != never || !differs_.budget.has(now)) return;
  const auto earliest = last_sent ? std::max(now, *last_sent + pace.slowed(differing_spacing)) : now;
  differs_.due = earliest + pace.within(pace.slowed(max_ask_delay));
}

void Presences::search(std::optional<Duration> spacing, Pace& pace, Instant now) {
  search_spacing_ = spacing;
  if (!spacing) {
    searches_.due = never;
  } else if (searches_.due == never) {
    searches_.due = now + pace.within(*spacing);
  }
}

void Presences::doubted(std::optional<Instant> last_sent, Instant now) {
  proof_.due = std::min(proof_.due, last_sent ? std::max(now, *last_sent + proof_spacing) : now);
}

void Presences::deny(const Pace& pace, Instant now) {
  if (denied_ && now - *denied_ < announcement::contest_intervals * pace.said_interval()) return;
  denied_ = denial_ = now;
  denials_left_ = denials;
}

bool Presences::bear_witness(Pace& pace, Instant now) {
  const bool is_first = testimony_ == never;
  testimony_ = std::min(testimony_, now + pace.slowed(pace.between(witness_delay, 2 * witness_delay)));
  return is_first;
}

std::array<Occasion*, 6> Presences::budgeted() {
  return {&lacks_, &doubts_, &challenges_, &differs_, &searches_, &contested_};
}

Instant Presences::due() const {
  const Occasion sign{proof_.budget, sign_due()};
  return std::min({searches_.affordable(), denial_, lacks_.affordable(), doubts_.affordable(), differs_.affordable(),
                   challenges_.affordable(), sign.affordable(), contested_.affordable()});
}

void Presences::pay(Instant now) {
  for (Occasion* occasion : budgeted()) {
    if (occasion->due <= now) occasion->pay(now);
  }
  if (sign_due() <= now) proof_.pay(now);
  if (denial_ <= now) denial_ = --denials_left_ > 0 ? now + denial_spacing : never;
}

void Presences::said(Instant now) {
  for (Question* question : {&lacks_, &doubts_, &challenges_}) {
    if (std::exchange(question->due, never) != never) question->asked = now;
  }
  testimony_ = never;
}

void Presences::announced(Pace& pace, Instant now) {
  if (search_spacing_) searches_.due = now + pace.spread(*search_spacing_, interval_jitter);
  proof_.due = differs_.due = contested_.due = never;
}

void Presences::clear() {
  for (Occasion* occasion : budgeted()) occasion->due = never;
  proof_.due = testimony_ = denial_ = never;
}

}  // namespace geminga::membership
