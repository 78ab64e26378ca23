// The frames between a relay and a bridge that keeps words on a server: SEALING.md, "Kept words", is the specification.
#ifndef GEMINGA_DISCOVERY_KEEPING_FRAME_HPP
#define GEMINGA_DISCOVERY_KEEPING_FRAME_HPP

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "geminga/service.hpp"

namespace geminga::keeping {

/// The largest frame: a datagram of the daemon (env::max_datagram_bytes).
inline constexpr std::size_t max_frame_bytes = 1232;
/// The largest envelope that is kept: what Keep leaves of a frame.
inline constexpr std::size_t max_kept_bytes = max_frame_bytes - 8;
/// Words that are kept of one participant.
inline constexpr std::size_t max_kept_words = 12;

/// A bridge keeps words. Another life: it has nothing yet of what it was given before.
struct Hello {
  std::uint64_t life = 0;
  friend bool operator==(const Hello&, const Hello&) = default;
};
/// A bridge is to keep this word, which is one of `count` of a participant and takes the place of the last one of that
/// index. Words of a higher index are taken away with the last of them.
struct Keep {
  ParticipantId participant{};  ///< not 0
  std::uint8_t index = 0;       ///< below count
  std::uint8_t count = 1;       ///< 1 to max_kept_words
  std::span<const std::byte> envelope;
};
/// A bridge is to keep nothing of this participant any more.
struct Drop {
  ParticipantId participant{};  ///< not 0
  friend bool operator==(const Drop&, const Drop&) = default;
};
/// The server has kept this word. Nothing proves yet that it holds.
struct Kept {
  std::span<const std::byte> envelope;
};
/// Borrows its octets.
using Frame = std::variant<Hello, Keep, Drop, Kept>;

/// Whether a datagram claims to be a frame. No announcement and no envelope begins with this octet.
[[nodiscard]] bool is_frame(std::span<const std::byte> datagram);
/// The frame, or nothing: it is of another version, or not whole. Takes octets from anywhere.
[[nodiscard]] std::optional<Frame> read(std::span<const std::byte> datagram);
/// The octets of a frame. Requires that it keeps the limits above.
[[nodiscard]] std::vector<std::byte> write(const Frame& frame);

}  // namespace geminga::keeping

#endif
