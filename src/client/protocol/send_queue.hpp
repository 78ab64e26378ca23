// What one TCP consumer is sent: frames that wait until its connection takes them.
#ifndef GEMINGA_CLIENT_PROTOCOL_SEND_QUEUE_HPP
#define GEMINGA_CLIENT_PROTOCOL_SEND_QUEUE_HPP

#include <cstddef>
#include <deque>
#include <memory>
#include <span>
#include <vector>

#include "client/protocol/frame.hpp"
#include "client/protocol/limits.hpp"

namespace geminga::client {

/// Frames in their order, of which the first may be written in part. Frames are shared between the consumers of one
/// message. Pure: the caller writes.
class SendQueue {
 public:
  using Shared = std::shared_ptr<const std::vector<std::byte>>;

  /// Whether a message of this size may wait: within the limit, or alone.
  [[nodiscard]] bool has_room(std::size_t payload_bytes) const {
    return frames_.empty() || waiting_ + frame_header_bytes + payload_bytes <= max_waiting_for_consumer;
  }
  [[nodiscard]] bool is_empty() const { return frames_.empty(); }
  /// Behind what waits, of which so many octets have been written already.
  void put(Shared frame, std::size_t written = 0) {
    waiting_ += frame->size() - written;
    if (frames_.empty()) written_ = written;
    frames_.push_back(std::move(frame));
  }
  /// What is to be written next. Requires that something waits.
  [[nodiscard]] std::span<const std::byte> front() const { return std::span(*frames_.front()).subspan(written_); }
  /// So much of front() was written.
  void wrote(std::size_t bytes) {
    waiting_ -= bytes;
    written_ += bytes;
    if (written_ < frames_.front()->size()) return;
    frames_.pop_front();
    written_ = 0;
  }

 private:
  std::deque<Shared> frames_;
  std::size_t written_ = 0;
  std::size_t waiting_ = 0;
};

}  // namespace geminga::client

#endif
