// The sayings of a relay about participants beyond a link: a word that it passes on, and testimony about those behind
// it.
#ifndef GEMINGA_DISCOVERY_ANNOUNCEMENT_RELAYED_HPP
#define GEMINGA_DISCOVERY_ANNOUNCEMENT_RELAYED_HPP

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "base/time.hpp"
#include "geminga/service.hpp"

namespace geminga::announcement {

/// A word that a relay passes on: one datagram, as its sender said it, with what the relay vouches for.
struct Relayed {
  std::vector<std::byte> word;  ///< the datagram, sealed where the team seals; 1 to max_word_bytes octets
  base::Duration age{};         ///< the time since the first relay heard it; whole milliseconds, rounded up
  /// The relays that it has passed, the one that heard its sender first; the last one is the sender of this datagram.
  /// 1 to max_hops, each once.
  std::vector<ParticipantId> through;
  std::string source;  ///< the numeric address from which the first relay heard it; empty: unknown
  friend bool operator==(const Relayed&, const Relayed&) = default;
};

/// The testimony of a relay about one participant that the receivers on this link do not hear themselves.
struct Behind {
  ParticipantId participant{};  ///< never 0
  std::uint64_t revision = 0;   ///< the last one whose state the relay has in whole; 0: none
  base::Duration age{};         ///< the time since the participant last spoke; whole milliseconds, rounded up
  std::uint8_t hops = 1;        ///< relays between it and the receiver, the sender included; 1 to max_hops
  std::uint8_t lost = 0;        ///< sixteenths of its datagrams that do not reach the relay; 0 to 15
  friend bool operator==(const Behind&, const Behind&) = default;
};

}  // namespace geminga::announcement

#endif
