// Frames put together from the octets of a stream.
#ifndef GEMINGA_CLIENT_PROTOCOL_FRAME_READER_HPP
#define GEMINGA_CLIENT_PROTOCOL_FRAME_READER_HPP

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "client/protocol/frame.hpp"
#include "client/protocol/limits.hpp"

namespace geminga::client {

/// Cuts the octets of a stream into frames. Keeps at most one frame and what was fed last.
class FrameReader {
 public:
  explicit FrameReader(std::size_t max_payload = max_stream_payload) : max_payload_(max_payload) {}

  /// Room for the next octets of the stream, at least for one; fed() says how many were written there. Frames of next()
  /// are void then.
  [[nodiscard]] std::span<std::byte> room();
  void fed(std::size_t bytes) { end_ += bytes; }

  /// The next frame, borrowed until room() is called. Nothing until more is fed, or if the stream is broken.
  [[nodiscard]] std::optional<ReadFrame> next();
  /// Whether something was no frame, so that nothing behind it can be read.
  [[nodiscard]] bool is_broken() const { return is_broken_; }

 private:
  std::size_t max_payload_;
  std::vector<std::byte> buffer_;
  std::size_t begin_ = 0;
  std::size_t end_ = 0;
  std::size_t wanted_ = frame_header_bytes;  ///< octets of the frame at begin_, as far as its size is known
  bool is_broken_ = false;
};

}  // namespace geminga::client

#endif
