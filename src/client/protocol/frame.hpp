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
#include "client/protocol/octets.hpp"
#include "client/protocol/primitives.hpp"
#include "geminga/channel.hpp"

namespace geminga::client {

enum class FrameForm : std::uint8_t { plain = 1, encrypted = 2, authenticated = 3 };
enum class FrameKind : std::uint8_t { message = 1, hello = 2, end = 3, floor = 4, full = 5 };

/// A frame. Its payload is borrowed from the octets that were read.
struct Frame {
  FrameKind kind = FrameKind::message;
  Life life = no_life;
  std::uint64_t sequence = 0;
  std::span<const std::byte> payload;
};

/// A frame as it was read. The payload of a form other than plain is still sealed, with its tag.
struct ReadFrame : Frame {
  FrameForm form = FrameForm::plain;
  std::span<const std::byte> octets;  ///< the whole frame
};

inline constexpr std::size_t frame_header_bytes = 24;
inline constexpr std::size_t sealed_header_bytes = 36;
/// The largest number of octets of a frame beside its payload.
inline constexpr std::size_t max_frame_overhead = sealed_header_bytes + tag_bytes;
using FrameHeader = std::array<std::byte, frame_header_bytes>;

/// The header of a plain frame with a payload of this size. Requires that the size is within max_stream_payload.
[[nodiscard]] FrameHeader frame_header(FrameKind kind, Life life, std::uint64_t sequence, std::size_t payload_bytes);
/// The octets of a whole plain frame.
[[nodiscard]] std::vector<std::byte> frame_bytes(const Frame& frame);

/// The size of the frame that begins with these frame_header_bytes, header and tag included. Nothing where they are no
/// header, or the payload is over `max_payload`.
[[nodiscard]] std::optional<std::size_t> frame_size(const std::byte* header, std::size_t max_payload);
/// The frame of exactly these octets, at which frame_size() has looked.
[[nodiscard]] ReadFrame frame_of(std::span<const std::byte> octets);

/// The frame that a datagram is; nothing if it is none.
[[nodiscard]] std::optional<ReadFrame> read_frame(std::span<const std::byte> datagram);

/// The payload of a hello, a floor, a full, and the end of a listener.
struct Greeting {
  Life life = no_life;          ///< of the other side
  std::uint64_t challenge = 0;  ///< of the consumer, for this channel
  std::uint64_t cookie = 0;     ///< of the publisher; 0: none yet, or the hello has been accepted
  friend bool operator==(const Greeting&, const Greeting&) = default;
};
inline constexpr std::size_t greeting_bytes = 24;
[[nodiscard]] std::array<std::byte, greeting_bytes> greeting_payload(const Greeting& greeting);
/// Nothing for a payload of another size.
[[nodiscard]] std::optional<Greeting> read_greeting(std::span<const std::byte> payload);

}  // namespace geminga::client

#endif
