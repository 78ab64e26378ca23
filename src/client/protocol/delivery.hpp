// A subscriber's messages, from the frame that is believed to the program: order, conversion, inbox and counts.
#ifndef GEMINGA_CLIENT_PROTOCOL_DELIVERY_HPP
#define GEMINGA_CLIENT_PROTOCOL_DELIVERY_HPP

#include <cstdint>
#include <expected>
#include <optional>
#include <string>
#include <utility>

#include "base/time.hpp"
#include "client/protocol/frame.hpp"
#include "client/protocol/inbox.hpp"
#include "client/protocol/sequence.hpp"
#include "geminga/channel.hpp"

namespace geminga::client {

/// Delivers no message twice (src/client/CHANNELS.md, Which message is new). Pure: the caller gives the time.
class Delivery {
 public:
  /// How a frame came, which decides how far its sequence is believed and what happens where the inbox is full.
  enum class Carrier : std::uint8_t {
    forgeable,  ///< a datagram that anybody could have sent
    proved,     ///< a datagram that was opened with a key
    stream,     ///< a connection
  };

  explicit Delivery(Conversions conversions) : conversions_(std::move(conversions)) {}

  /// Keeps the message of a frame for the program. False if it is old. The error says why the conversions that the
  /// provider's match names cannot be done; such a message is dropped.
  [[nodiscard]] std::expected<bool, std::string> deliver(const Frame& frame, Carrier carrier,
                                                         const ServiceEvent& provider, base::Instant now);
  /// Counts the messages that are missing before the last one of a life, which has ended. The count of a forgeable end
  /// is believed up to max_sequence_step.
  void count_missed_at_end(Life life, std::uint64_t last, Carrier carrier);
  /// The channel of this life was closed: what is sent until it is made again is not missed.
  void interrupt(Life life) { sequence_.interrupt(life); }
  /// Counts a frame that is not believed, or takes one back that was counted too early.
  void count_dropped() { ++count_.dropped; }
  void uncount_dropped() { --count_.dropped; }

  /// The next message that is here.
  [[nodiscard]] std::optional<Message> take() { return inbox_.take(); }
  [[nodiscard]] bool is_empty() const { return inbox_.is_empty(); }
  [[nodiscard]] bool is_full() const { return inbox_.is_full(); }
  [[nodiscard]] const ReceiveCount& count() const { return count_; }

 private:
  Conversions conversions_;
  ReceiveCount count_;
  Inbox inbox_;
  Sequence sequence_;
};

}  // namespace geminga::client

#endif
