#include "client/channels/parties.hpp"

#include <algorithm>

#include "client/channels/limits.hpp"

namespace geminga::client {

Parties::Added Parties::add(Life life, const ServiceKey& key) {
  auto number = life == no_life ? find(key) : find(life);
  // One whose life is another than it was is another one; the caller was told of the end of the first by del().
  if (number && parties_.at(*number).life != life) number = std::nullopt;
  const bool is_new = !number;
  if (!number) {
    number = ++last_;
    parties_.emplace(*number, Party{life, key});
    if (life != no_life) by_life_[life] = *number;
  }
  Party& party = parties_.at(*number);
  if (const auto old = by_key_.find(party.key); old != by_key_.end() && old->second == *number) by_key_.erase(old);
  by_key_[key] = *number;
  party.key = key;
  party.state = State::matched;
  party.until = base::never;
  party.reason.clear();
  return {*number, is_new};
}

std::optional<Parties::Number> Parties::find(const ServiceKey& key) const {
  const auto found = by_key_.find(key);
  return found == by_key_.end() ? std::nullopt : std::optional(found->second);
}

std::optional<Parties::Number> Parties::find(Life life) const {
  const auto found = by_life_.find(life);
  return found == by_life_.end() ? std::nullopt : std::optional(found->second);
}

bool Parties::orphan(Party& party, std::string_view reason, Carrier carrier, base::Instant now) {
  party.state = State::orphaned;
  party.reason = reason;
  party.until = carrier == Carrier::datagrams ? now + orphan_patience : base::never;
  return carrier != Carrier::no_connection;
}

Parties::Parted Parties::del(const ServiceKey& key, std::string_view reason, Carrier carrier, base::Instant now) {
  const auto number = find(key);
  if (!number) return {};
  Party& party = parties_.at(*number);
  by_key_.erase(key);
  party.reason = reason;
  if (reason == "withdrawn" && carrier != Carrier::no_connection) {
    party.state = State::finishing;
    party.until = now + drain_patience;
    return {*number, Parting::finish};
  }
  if (reason == "withdrawn" || reason == "outranked" || reason == "changed") return {*number, Parting::close};
  return {*number, orphan(party, reason, carrier, now) ? Parting::go_on : Parting::close};
}

void Parties::doubt() {
  by_key_.clear();
  for (auto& [number, party] : parties_) {
    if (party.state == State::matched) party.state = State::doubted;
  }
}

std::vector<Parties::Number> Parties::superfluous(std::uint32_t limit) const {
  const auto is_matched = [](const auto& one) { return one.second.state == State::matched; };
  std::vector<Number> orphans;
  if (limit == 0 || static_cast<std::size_t>(std::ranges::count_if(parties_, is_matched)) < limit) return orphans;
  for (const auto& [number, party] : parties_) {
    if (party.state == State::orphaned) orphans.push_back(number);
  }
  return orphans;
}

std::vector<Parties::Number> Parties::expired(base::Instant now) const {
  std::vector<Number> over;
  for (const auto& [number, party] : parties_) {
    if (party.until <= now) over.push_back(number);
  }
  return over;
}

base::Instant Parties::next_end() const {
  base::Instant next = base::never;
  for (const auto& [number, party] : parties_) next = std::min(next, party.until);
  return next;
}

void Parties::go_on_finishing(Number number, base::Instant now) {
  Party& party = parties_.at(number);
  if (party.state == State::finishing) party.until = now + drain_patience;
}

void Parties::erase(Number number) {
  const auto found = parties_.find(number);
  if (found == parties_.end()) return;
  const Party& party = found->second;
  if (const auto life = by_life_.find(party.life); life != by_life_.end() && life->second == number)
    by_life_.erase(life);
  if (const auto key = by_key_.find(party.key); key != by_key_.end() && key->second == number) by_key_.erase(key);
  parties_.erase(found);
}

}  // namespace geminga::client
