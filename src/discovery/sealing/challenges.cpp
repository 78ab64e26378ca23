#include "discovery/sealing/challenges.hpp"

#include <algorithm>
#include <ranges>

namespace geminga::sealing {

void Challenges::begin(Session own, Challenge challenge, base::Instant now) {
  own_ = own;
  own_challenge_ = challenge;
  calls_until_ = now + calling_time;
}

void Challenges::hear(const Greeting& greeting, Session from, env::InterfaceIndex interface, base::Instant now) {
  if (!greeting.challenge) return;
  const bool is_named = std::ranges::find(greeting.asked, tag_of(own_)) != greeting.asked.end();
  if (is_named || greeting.calls_everybody) owe(from, interface, *greeting.challenge, is_named, now);
}

void Challenges::owe(Session to, env::InterfaceIndex interface, Challenge challenge, bool is_named, base::Instant now) {
  Owed owed{.to = to, .interface = interface, .challenge = challenge, .since = now, .copies = echo_copies};
  const auto known =
      std::ranges::find_if(owed_, [&](const Owed& one) { return one.to == to && one.interface == interface; });
  if (known != owed_.end()) {
    const bool is_same = known->challenge == challenge;
    if (is_same && !is_named && now - known->since < call_spacing) return;
    if (is_same && !known->is_carried) owed.since = known->since;
    owed_.erase(known);
  }
  if (owed_.size() == max_waiting_echoes) owed_.erase(owed_.begin());
  owed_.push_back(owed);
}

bool Challenges::is_proof(const Greeting& greeting) const {
  return std::ranges::find(greeting.echoes, own_challenge_) != greeting.echoes.end();
}

void Challenges::ask(Session session, env::InterfaceIndex interface, base::Instant now) {
  forget_silent(now);
  std::erase_if(asked_, [&](const Asked& one) { return one.session == session && one.interface == interface; });
  if (asked_.size() == max_asked) {
    asked_.erase(asked_.begin());
    are_too_many_ = true;
  }
  asked_.push_back({session, interface, now});
}

void Challenges::settle(Session session) {
  std::erase_if(asked_, [&](const Asked& one) { return one.session == session; });
}

void Challenges::forget_silent(base::Instant now) {
  std::erase_if(asked_, [&](const Asked& one) { return now - one.heard >= asking_time; });
  if (asked_.empty()) are_too_many_ = false;
}

bool Challenges::asks(base::Instant now) {
  forget_silent(now);
  return !asked_.empty();
}

bool Challenges::asks_only_on(env::InterfaceIndex interface, env::InterfaceIndex other, base::Instant now) {
  forget_silent(now);
  const auto is_asked_on = [&](Session session, env::InterfaceIndex on) {
    return std::ranges::any_of(asked_, [&](const Asked& one) { return one.session == session && one.interface == on; });
  };
  return std::ranges::any_of(
      asked_, [&](const Asked& one) { return one.interface == interface && !is_asked_on(one.session, other); });
}

void Challenges::forget_owed(env::InterfaceIndex interface) {
  std::erase_if(owed_, [&](const Owed& one) { return one.interface == interface; });
}

bool Challenges::is_asked(base::Instant now) const {
  return std::ranges::any_of(owed_, [&](const Owed& one) { return !one.is_carried && now - one.since < asking_time; });
}

Greeting Challenges::greeting(env::InterfaceIndex interface, const Keyring& keys, std::size_t room, base::Instant now) {
  Greeting greeting;
  forget_silent(now);
  const auto fits = [&](std::size_t more) {
    const auto size = greeting_bytes(greeting.keys.size(), greeting.challenge.has_value(), greeting.asked.size(),
                                     greeting.echoes.size());
    return size + more <= room;
  };
  if (keys.keys().size() > 1 && fits(listed_bytes * keys.keys().size())) {
    for (const Key& key : keys.keys()) greeting.keys.push_back(key.id());
  }
  greeting.calls_everybody = now < calls_until_ || are_too_many_;
  const auto is_here = [&](const auto& one) { return one.interface == interface; };
  const bool asks = greeting.calls_everybody || std::ranges::any_of(asked_, is_here);
  if (asks && fits(challenge_bytes + listed_bytes)) {
    greeting.challenge = own_challenge_;
  } else {
    greeting.calls_everybody = false;
  }
  // Sessions that are named answer each time, so they are named beside a call, too: an answer may have been lost.
  if (greeting.challenge) {
    for (const Asked& one : asked_ | std::views::reverse | std::views::filter(is_here)) {
      if (fits(listed_bytes)) greeting.asked.push_back(tag_of(one.session));
    }
  }
  for (Owed& one : owed_ | std::views::reverse | std::views::filter(is_here)) {
    if (one.copies == 0) continue;
    if (greeting.echoes.size() == max_echoes || !fits(challenge_bytes)) break;
    greeting.echoes.push_back(one.challenge);
    one.is_carried = true;
    --one.copies;
  }
  return greeting;
}

}  // namespace geminga::sealing
