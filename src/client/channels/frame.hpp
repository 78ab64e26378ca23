// Frames: what publishers and subscribers write to each other, in datagrams and in streams (src/client/CHANNELS.md).
#ifndef GEMINGA_CLIENT_CHANNELS_FRAME_HPP
#define GEMINGA_CLIENT_CHANNELS_FRAME_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "client/channels/limits.hpp"
#include "geminga/channel.hpp"

namespace geminga::client {

enum class FrameKind : std::uint8_t { message = 1, hello = 2, end = 3 };

/// A frame, whose payload is borrowed from where it was read.
struct Frame {
  FrameKind kind = FrameKind::message;
  Life life = no_life;
  std::uint64_t sequence = 0;
  std::span<const std::byte> payload;
};

inline constexpr std::size_t frame_header_bytes = 24;
using FrameHeader = std::array<std::byte, frame_header_bytes>;

/// The octets before a payload of this size. Requires that it is within max_stream_payload.
[[nodiscard]] FrameHeader frame_header(FrameKind kind, Life life, std::uint64_t sequence, std::size_t payload_bytes);
/// The whole frame.
[[nodiscard]] std::vector<std::byte> frame_bytes(const Frame& frame);

/// The frame that a datagram is, or nothing where it is none.
[[nodiscard]] std::optional<Frame> read_frame(std::span<const std::byte> datagram);

/// The payload of a hello or an end that a listener sends: the life of whom it means; and back.
[[nodiscard]] std::array<std::byte, 8> life_payload(Life life);
[[nodiscard]] std::optional<Life> payload_life(std::span<const std::byte> payload);

/// Cuts the octets of a stream into frames. Keeps at most one frame and what was fed last.
class FrameReader {
 public:
  explicit FrameReader(std::size_t max_payload = max_stream_payload) : max_payload_(max_payload) {}

  /// Where the next octets of the stream are to be written, at least one of them; and how many were. Frames that were
  /// given before are over.
  [[nodiscard]] std::span<std::byte> room();
  void fed(std::size_t bytes) { end_ += bytes; }

  /// The next frame, borrowed until room() is called; nothing until more is fed, or where the stream is broken.
  [[nodiscard]] std::optional<Frame> next();
  /// Something was no frame: nothing behind it can be read.
  [[nodiscard]] bool is_broken() const { return is_broken_; }

 private:
  std::size_t max_payload_;
  std::vector<std::byte> buffer_;
  std::size_t begin_ = 0;
  std::size_t end_ = 0;
  std::size_t wanted_ = frame_header_bytes;  ///< of the frame at begin_, as far as it is known
  bool is_broken_ = false;
};

}  // namespace geminga::client

#endif
