#include "client/protocol/sequence.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace geminga::client {

Sequence::Heard& Sequence::heard_of(Life life) {
  if (!lives_.contains(life) && lives_.size() == max_remembered_lives) {
    lives_.erase(std::ranges::min_element(lives_, {}, [](const auto& one) { return one.second.heard; }));
  }
  return lives_[life];
}

std::optional<std::uint64_t> Sequence::take(Life life, std::uint64_t number) {
  if (number == 0) return std::nullopt;
  Heard& heard = heard_of(life);
  if (number <= heard.last) return std::nullopt;
  const std::uint64_t missed = heard.is_first ? 0 : number - heard.last - 1;
  heard.last = number;
  heard.is_first = false;
  heard.heard = ++heard_;
  return missed;
}

std::optional<std::uint64_t> Sequence::take_unproved(Life life, std::uint64_t number, base::Instant now) {
  if (number == 0) return std::nullopt;
  Heard& heard = heard_of(life);
  if (heard.was_delivered(number)) return std::nullopt;  // rule 1
  const bool is_later = number > heard.last;
  std::uint64_t missed = 0;
  if (heard.is_first && is_later) {                                   // rule 2
  } else if (is_later && number - heard.last <= max_sequence_step) {  // rule 3
    missed = number - heard.last - 1;
  } else {  // rule 4
    const auto before = std::exchange(heard.straggler, number);
    const bool follows = before && number > *before && number - *before <= max_sequence_step;
    if (!follows || now - heard.at < sequence_silence) return std::nullopt;
  }
  heard.last = number;
  heard.at = now;
  heard.is_first = false;
  heard.heard = ++heard_;
  heard.straggler.reset();
  heard.deliver(number);
  return missed;
}

std::uint64_t Sequence::missed_at_end(Life life, std::uint64_t last) const {
  const auto heard = lives_.find(life);
  if (heard == lives_.end() || heard->second.is_first || last <= heard->second.last) return 0;
  return last - heard->second.last;
}

bool Sequence::Heard::was_delivered(std::uint64_t number) const {
  const auto after = delivered.upper_bound(number);
  return after != delivered.begin() && std::prev(after)->second >= number;
}

void Sequence::Heard::deliver(std::uint64_t number) {
  const auto after = delivered.upper_bound(number);
  const auto before = after == delivered.begin() ? delivered.end() : std::prev(after);
  const bool joins_after = after != delivered.end() && after->first - 1 == number;
  if (before != delivered.end() && before->second == number - 1) {
    before->second = joins_after ? after->second : number;
    if (joins_after) delivered.erase(after);
  } else {
    const std::uint64_t end = joins_after ? after->second : number;
    if (joins_after) delivered.erase(after);
    delivered.emplace(number, end);
  }
  if (delivered.size() <= max_delivered_ranges) return;
  delivered.erase(
      std::ranges::min_element(delivered, {}, [](const auto& range) { return range.second - range.first; }));
}

}  // namespace geminga::client
