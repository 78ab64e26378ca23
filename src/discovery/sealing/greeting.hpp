// The part of a sealed datagram beside its text: the keys of its sender, the sessions that it asks for a proof, and its
// own proofs.
#ifndef GEMINGA_DISCOVERY_SEALING_GREETING_HPP
#define GEMINGA_DISCOVERY_SEALING_GREETING_HPP

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "discovery/sealing/envelope.hpp"

namespace geminga::sealing {

/// Random bits that a receiver gives out. A sender that repeats them in a datagram of its own has made it since then.
enum class Challenge : std::uint64_t {};

/// The upper 16 bits of a session, by which it is called. If two have one tag both answer, which does no harm.
enum class SessionTag : std::uint16_t {};
[[nodiscard]] constexpr SessionTag tag_of(Session session) {
  return SessionTag(static_cast<std::uint64_t>(session) >> 48);
}

struct Greeting {
  std::vector<KeyId> keys{};             ///< keys that the sender opens with; none: only the one that it seals with
  bool calls_everybody = false;          ///< every receiver is to give the challenge back
  std::optional<Challenge> challenge{};  ///< present if anybody is asked
  std::vector<SessionTag> asked{};       ///< sessions that are to give it back
  std::vector<Challenge> echoes{};       ///< challenges of others, given back

  [[nodiscard]] bool is_empty() const { return keys.empty() && !challenge && echoes.empty(); }
  friend bool operator==(const Greeting&, const Greeting&) = default;
};

/// The octets of a greeting with so many of each, and with or without a challenge.
inline constexpr std::size_t greeting_head_bytes = 3;
inline constexpr std::size_t challenge_bytes = 8;
inline constexpr std::size_t listed_bytes = 2;  // a key, or a session that is asked
[[nodiscard]] constexpr std::size_t greeting_bytes(std::size_t keys, bool has_challenge, std::size_t asked,
                                                   std::size_t echoes) {
  return greeting_head_bytes + listed_bytes * (keys + asked) + challenge_bytes * (echoes + (has_challenge ? 1 : 0));
}
inline constexpr std::size_t max_greeting_bytes = greeting_bytes(max_keys, true, max_asked, max_echoes);

/// Writes a greeting within its limits, and returns its size. Requires room for it.
std::size_t write_greeting(const Greeting& greeting, std::span<std::byte> octets);

struct ReadGreeting {
  Greeting greeting;
  std::size_t size = 0;  ///< the announcement begins behind it
};
/// Reads the greeting that an opened text begins with.
[[nodiscard]] std::expected<ReadGreeting, Rejection> read_greeting(std::span<const std::byte> text);

}  // namespace geminga::sealing

#endif
