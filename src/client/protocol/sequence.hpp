// The delivered messages of each life, by which new messages are told from old ones and missing ones are counted.
#ifndef GEMINGA_CLIENT_PROTOCOL_SEQUENCE_HPP
#define GEMINGA_CLIENT_PROTOCOL_SEQUENCE_HPP

#include <cstdint>
#include <map>
#include <optional>

#include "base/time.hpp"
#include "client/protocol/limits.hpp"
#include "geminga/channel.hpp"

namespace geminga::client {

/// Remembers which messages of each life a subscriber delivered (src/client/CHANNELS.md, Which message is new). No
/// message is delivered twice. Remembers max_remembered_lives lives, those that were heard last.
class Sequence {
 public:
  /// The number of messages that are missing before this one, which came over TCP or was opened with a key; nothing if
  /// it is old. The first message has the number 1.
  std::optional<std::uint64_t> take(Life life, std::uint64_t number);
  /// The same of a message over UDP that anybody could have forged. Linear in max_delivered_ranges at most.
  std::optional<std::uint64_t> take_unproved(Life life, std::uint64_t number, base::Instant now);
  /// The number of messages that are missing up to the last one of a life that has ended.
  [[nodiscard]] std::uint64_t missed_at_end(Life life, std::uint64_t last) const;
  /// The channel was closed: messages that are sent until it is made again are not missed.
  void interrupt(Life life) {
    if (const auto heard = lives_.find(life); heard != lives_.end()) heard->second.is_first = true;
  }

 private:
  struct Heard {
    std::uint64_t last = 0;
    base::Instant at{};                                ///< the instant of the last delivery
    bool is_first = true;                              ///< the next message is the first one of its channel
    std::uint64_t heard = 0;                           ///< a count that orders lives by time
    std::optional<std::uint64_t> straggler{};          ///< the frame before, if it was dropped as one
    std::map<std::uint64_t, std::uint64_t> delivered;  ///< runs without a gap: from the first to the last

    [[nodiscard]] bool was_delivered(std::uint64_t number) const;
    void deliver(std::uint64_t number);
  };

  Heard& heard_of(Life life);

  std::map<Life, Heard> lives_;
  std::uint64_t heard_ = 0;
};

}  // namespace geminga::client

#endif
