// Frames that wait until the connections of TCP consumers take them.
#ifndef GEMINGA_CLIENT_PROTOCOL_SEND_QUEUE_HPP
#define GEMINGA_CLIENT_PROTOCOL_SEND_QUEUE_HPP

#include <cstddef>
#include <deque>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "client/protocol/frame.hpp"
#include "client/protocol/limits.hpp"

namespace geminga::client {

/// Counts the octets of all frames that wait for the consumers of one publisher, each frame once. Outlives its frames.
class WaitingFrames {
 public:
  /// A frame that the queues of several consumers share, which is why it is a shared_ptr.
  using Shared = std::shared_ptr<const std::vector<std::byte>>;

  WaitingFrames() = default;
  WaitingFrames(const WaitingFrames&) = delete;
  WaitingFrames& operator=(const WaitingFrames&) = delete;

  [[nodiscard]] Shared share(std::vector<std::byte> octets) {
    octets_ += octets.size();
    return {new std::vector<std::byte>(std::move(octets)), [this](const std::vector<std::byte>* frame) {
              octets_ -= frame->size();
              delete frame;
            }};
  }
  [[nodiscard]] std::size_t octets() const { return octets_; }

 private:
  std::size_t octets_ = 0;
};

/// Frames for one consumer in their order; the first may be written in part. Pure: the caller writes.
class SendQueue {
 public:
  using Shared = WaitingFrames::Shared;

  /// Whether a message of this size may wait: one that fits into the limit, or one alone.
  [[nodiscard]] bool has_room(std::size_t payload_bytes) const {
    return frames_.empty() || (frames_.size() < max_frames_for_consumer &&
                               waiting_ + frame_header_bytes + payload_bytes <= max_waiting_for_consumer);
  }
  [[nodiscard]] bool is_empty() const { return frames_.empty(); }
  /// Appends a frame, of which so many octets have been written already.
  void put(Shared frame, std::size_t written = 0) {
    waiting_ += frame->size() - written;
    if (frames_.empty()) written_ = written;
    frames_.push_back(std::move(frame));
  }
  /// The octets to write next. Requires that the queue is not empty.
  [[nodiscard]] std::span<const std::byte> front() const { return std::span(*frames_.front()).subspan(written_); }
  /// Removes so many octets of front(), which were written.
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
