// The last message of each life, by which new messages are told from old ones and missing ones are counted.
#ifndef GEMINGA_CLIENT_PROTOCOL_SEQUENCE_HPP
#define GEMINGA_CLIENT_PROTOCOL_SEQUENCE_HPP

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>

#include "client/protocol/limits.hpp"
#include "geminga/channel.hpp"

namespace geminga::client {

/// Remembers which message of each life a subscriber delivered last. Only newer ones are new, so no message is
/// delivered twice and none out of order. Remembers max_remembered_lives lives, those that were heard last.
class Sequence {
 public:
  /// The number of messages that are missing before this one; nothing if it is old. The first message has the number 1.
  std::optional<std::uint64_t> take(Life life, std::uint64_t number) {
    if (number == 0) return std::nullopt;
    if (!lives_.contains(life) && lives_.size() == max_remembered_lives) {
      lives_.erase(std::ranges::min_element(lives_, {}, [](const auto& one) { return one.second.heard; }));
    }
    Heard& heard = lives_[life];
    if (number <= heard.last) return std::nullopt;
    const std::uint64_t missed = heard.is_first ? 0 : number - heard.last - 1;
    heard = {number, false, ++heard_};
    return missed;
  }
  /// The number of messages that are missing up to the last one of a life that has ended.
  [[nodiscard]] std::uint64_t missed_at_end(Life life, std::uint64_t last) const {
    const auto heard = lives_.find(life);
    if (heard == lives_.end() || heard->second.is_first || last <= heard->second.last) return 0;
    return last - heard->second.last;
  }
  /// The channel was closed: messages that are sent until it is made again are not missed.
  void interrupt(Life life) {
    if (const auto heard = lives_.find(life); heard != lives_.end()) heard->second.is_first = true;
  }

 private:
  struct Heard {
    std::uint64_t last = 0;
    bool is_first = true;     ///< the next message is the first one of its channel
    std::uint64_t heard = 0;  ///< a count that orders lives by time
  };
  std::map<Life, Heard> lives_;
  std::uint64_t heard_ = 0;
};

}  // namespace geminga::client

#endif
