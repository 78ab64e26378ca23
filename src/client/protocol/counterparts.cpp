#include "client/protocol/counterparts.hpp"

#include <algorithm>

#include "client/protocol/limits.hpp"

namespace geminga::client {

Counterparts::Added Counterparts::add(Life life, const ServiceKey& key) {
  auto number = life == no_life ? find(key) : find(life);
  // Another life is another counterpart; the caller has removed the first one.
  if (number && counterparts_.at(*number).life != life) number = std::nullopt;
  const bool is_new = !number;
  if (!number) {
    number = ++last_;
    counterparts_.emplace(*number, Counterpart{life, key});
    if (life != no_life) by_life_[life] = *number;
  }
  Counterpart& counterpart = counterparts_.at(*number);
  if (const auto old = by_key_.find(counterpart.key); old != by_key_.end() && old->second == *number)
    by_key_.erase(old);
  by_key_[key] = *number;
  counterpart.key = key;
  counterpart.state = State::matched;
  counterpart.until = base::never;
  counterpart.reason.clear();
  return {*number, is_new};
}

std::optional<Counterparts::Number> Counterparts::find(const ServiceKey& key) const {
  const auto found = by_key_.find(key);
  return found == by_key_.end() ? std::nullopt : std::optional(found->second);
}

std::optional<Counterparts::Number> Counterparts::find(Life life) const {
  const auto found = by_life_.find(life);
  return found == by_life_.end() ? std::nullopt : std::optional(found->second);
}

bool Counterparts::orphan(Counterpart& counterpart, std::string_view reason, Carrier carrier, base::Instant now) {
  counterpart.state = State::orphaned;
  counterpart.reason = reason;
  counterpart.until = carrier == Carrier::datagrams ? now + orphan_patience : base::never;
  return carrier != Carrier::no_connection;
}

Counterparts::Parted Counterparts::del(const ServiceKey& key, std::string_view reason, Carrier carrier,
                                       base::Instant now) {
  const auto number = find(key);
  if (!number) return {};
  Counterpart& counterpart = counterparts_.at(*number);
  by_key_.erase(key);
  counterpart.reason = reason;
  if (reason == "withdrawn" && carrier != Carrier::no_connection) {
    counterpart.state = State::finishing;
    counterpart.until = now + drain_patience;
    return {*number, Parting::finish};
  }
  if (reason == "withdrawn" || reason == "outranked" || reason == "changed") return {*number, Parting::close};
  return {*number, orphan(counterpart, reason, carrier, now) ? Parting::go_on : Parting::close};
}

bool Counterparts::lose_sight(Number number, std::string_view reason, Carrier carrier, base::Instant now) {
  Counterpart& counterpart = counterparts_.at(number);
  if (const auto key = by_key_.find(counterpart.key); key != by_key_.end() && key->second == number) by_key_.erase(key);
  return orphan(counterpart, reason, carrier, now);
}

void Counterparts::doubt() {
  by_key_.clear();
  for (auto& [number, counterpart] : counterparts_) {
    // Nobody could confirm an orphan in time while the own daemon is away, either.
    if (counterpart.state != State::matched && counterpart.state != State::orphaned) continue;
    counterpart.state = State::doubted;
    counterpart.until = base::never;
  }
}

std::vector<Counterparts::Number> Counterparts::superfluous(std::uint32_t limit) const {
  const auto is_matched = [](const auto& one) { return one.second.state == State::matched; };
  std::vector<Number> orphans;
  if (limit == 0 || static_cast<std::size_t>(std::ranges::count_if(counterparts_, is_matched)) < limit) return orphans;
  for (const auto& [number, counterpart] : counterparts_) {
    if (counterpart.state == State::orphaned) orphans.push_back(number);
  }
  return orphans;
}

std::vector<Counterparts::Number> Counterparts::expired(base::Instant now) const {
  std::vector<Number> over;
  for (const auto& [number, counterpart] : counterparts_) {
    if (counterpart.until <= now) over.push_back(number);
  }
  return over;
}

base::Instant Counterparts::next_end() const {
  base::Instant next = base::never;
  for (const auto& [number, counterpart] : counterparts_) next = std::min(next, counterpart.until);
  return next;
}

void Counterparts::go_on_finishing(Number number, base::Instant now) {
  Counterpart& counterpart = counterparts_.at(number);
  if (counterpart.state == State::finishing) counterpart.until = now + drain_patience;
}

void Counterparts::erase(Number number) {
  const auto found = counterparts_.find(number);
  if (found == counterparts_.end()) return;
  const Counterpart& counterpart = found->second;
  if (const auto life = by_life_.find(counterpart.life); life != by_life_.end() && life->second == number)
    by_life_.erase(life);
  if (const auto key = by_key_.find(counterpart.key); key != by_key_.end() && key->second == number) by_key_.erase(key);
  counterparts_.erase(found);
}

}  // namespace geminga::client
