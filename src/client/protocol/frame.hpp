// Frames: what publishers and subscribers write to each other, in datagrams and in streams (src/client/CHANNELS.md).
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

/// The size of the payload behind the 24 octets of a header. Nothing where they are no header, or over `max_payload`.
[[nodiscard]] std::optional<std::size_t> payload_bytes(const std::byte* header, std::size_t max_payload);
/// The frame at a header that payload_bytes() accepts. Requires that the whole payload is there.
[[nodiscard]] Frame frame_at(const std::byte* header);

/// The frame that a datagram is, or nothing where it is none.
[[nodiscard]] std::optional<Frame> read_frame(std::span<const std::byte> datagram);

/// The payload of a hello or an end that a listener sends: the life of whom it means; and back.
[[nodiscard]] std::array<std::byte, 8> life_payload(Life life);
[[nodiscard]] std::optional<Life> payload_life(std::span<const std::byte> payload);

}  // namespace geminga::client

#endif
