// One sealed datagram, octet by octet; src/discovery/sealing/SEALING.md is the specification.
#ifndef GEMINGA_DISCOVERY_SEALING_ENVELOPE_HPP
#define GEMINGA_DISCOVERY_SEALING_ENVELOPE_HPP

#include <cstddef>
#include <cstdint>
#include <expected>
#include <span>
#include <string_view>

#include "discovery/sealing/key.hpp"
#include "discovery/sealing/rejection.hpp"

namespace geminga::sealing {

/// The protection of a datagram on the air.
enum class Protection : std::uint8_t {
  plain,          ///< not at all
  authenticated,  ///< everybody can read it; only the team can make or change it
  encrypted,      ///< only the team can read it, too
};
/// "plain", "authenticated", "encrypted". Static storage.
[[nodiscard]] std::string_view to_string(Protection protection);

/// Drawn at random by each sender when it starts, and never used by another one.
enum class Session : std::uint64_t {};

/// The octets before the text, readable for everybody and as well protected as the text.
struct Header {
  Protection protection = Protection::encrypted;
  bool has_greeting = false;   ///< the text begins with a Greeting
  bool is_compressed = false;  ///< the rest of the text is compressed
  KeyId key{};
  Session session{};
  std::uint32_t counter = 0;  ///< rises with each datagram of the session
  friend bool operator==(const Header&, const Header&) = default;
};

/// Whether a datagram claims to be sealed. No announcement begins with this octet.
[[nodiscard]] bool is_sealed(std::span<const std::byte> datagram);

/// Reads the header of a datagram that is_sealed(). Nothing in it is true until open() has confirmed it.
[[nodiscard]] std::expected<Header, Rejection> read_header(std::span<const std::byte> datagram);

/// Writes header, text and tag into `datagram`, and returns its size. Requires room for env::max_envelope_bytes more
/// than the text, a protection other than plain, and that no two texts are ever sealed with the same key, session and
/// counter. `text` must not overlap `datagram`.
std::size_t seal(const Key& key, const Header& header, std::span<const std::byte> text, std::span<std::byte> datagram);

/// Writes the text of a datagram with this header into `text`, which has room for it, and returns its size. An error:
/// it was not sealed with this key, or it was changed. Cost: linear in the datagram, below 1 us (tests/bench).
[[nodiscard]] std::expected<std::size_t, Rejection> open(const Key& key, const Header& header,
                                                         std::span<const std::byte> datagram,
                                                         std::span<std::byte> text);

}  // namespace geminga::sealing

#endif
