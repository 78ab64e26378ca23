// The reasons why a datagram was not heard, in the order in which they are found.
#ifndef GEMINGA_DISCOVERY_SEALING_REJECTION_HPP
#define GEMINGA_DISCOVERY_SEALING_REJECTION_HPP

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace geminga::sealing {

/// Words are only ever appended.
enum class Rejection : std::uint8_t {
  plain,          ///< not sealed, and only sealed datagrams are heard
  too_large,      ///< sealed, and over env::max_datagram_bytes
  too_short,      ///< sealed, and too short for an envelope
  other_version,  ///< sealed in a way that this version does not know
  unknown_key,    ///< sealed with a key that we do not have
  replayed,       ///< this datagram was heard, or is so old that it may have been
  forged,         ///< not sealed with the key that it names, or changed on the way
  malformed,      ///< sealed with our key, and its content cannot be read
  unproved,       ///< of a session that has not proved yet that it is no recording
  downgraded,     ///< not sealed, in the name of a participant that seals
  own,            ///< our own datagram, given back by the link: no fault, and not counted as one
  unreadable,     ///< not sealed, which is allowed, but no announcement
  copied,         ///< heard by multicast, and said to us alone, too, or the other way round: no fault, and not counted
};
inline constexpr std::size_t rejection_count = 13;

/// "too-large", "plain", ... Static storage.
[[nodiscard]] std::string_view to_string(Rejection rejection);

}  // namespace geminga::sealing

#endif
