// Frames, which publishers and subscribers write to each other in datagrams and in streams (src/client/CHANNELS.md).
#ifndef GEMINGA_CLIENT_PROTOCOL_FRAME_HPP
#define GEMINGA_CLIENT_PROTOCOL_FRAME_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "client/protocol/limits.hpp"
#include "geminga/channel.hpp"

namespace geminga::client {

enum class FrameKind : std::uint8_t { message = 1, hello = 2, end = 3 };

/// A frame. Its payload is borrowed from the octets that were read.
struct Frame {
  FrameKind kind = FrameKind::message;
  Life life = no_life;
  std::uint64_t sequence = 0;
  std::span<const std::byte> payload;
};

inline constexpr std::size_t frame_header_bytes = 24;
using FrameHeader = std::array<std::byte, frame_header_bytes>;

/// The header of a payload of this size. Requires that the size is within max_stream_payload.
[[nodiscard]] FrameHeader frame_header(FrameKind kind, Life life, std::uint64_t sequence, std::size_t payload_bytes);
/// The octets of a whole frame.
[[nodiscard]] std::vector<std::byte> frame_bytes(const Frame& frame);

/// The size of the payload behind the 24 octets of a header. Nothing where they are no header, or over `max_payload`.
[[nodiscard]] std::optional<std::size_t> payload_bytes(const std::byte* header, std::size_t max_payload);
/// The frame at a header that payload_bytes() accepts. Requires that the whole payload is there.
[[nodiscard]] Frame frame_at(const std::byte* header);

/// The frame that a datagram is; nothing if it is none.
[[nodiscard]] std::optional<Frame> read_frame(std::span<const std::byte> datagram);

/// The payload of a hello or an end of a listener, which is the life of the publisher; and the life of such a payload.
[[nodiscard]] std::array<std::byte, 8> life_payload(Life life);
[[nodiscard]] std::optional<Life> payload_life(std::span<const std::byte> payload);

}  // namespace geminga::client

#endif
