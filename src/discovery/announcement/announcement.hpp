// What a participant says on the air: its state, a claim to an identifier, or a goodbye (paper section 3.5.2).
#ifndef GEMINGA_DISCOVERY_ANNOUNCEMENT_ANNOUNCEMENT_HPP
#define GEMINGA_DISCOVERY_ANNOUNCEMENT_ANNOUNCEMENT_HPP

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "base/time.hpp"
#include "discovery/announcement/heard_list.hpp"
#include "discovery/announcement/limits.hpp"
#include "geminga/service.hpp"

namespace geminga::announcement {

/// 64 random bits that a process draws once. Tells its datagrams from those of another participant with the same
/// identifier (a clash) and from those of its own earlier life (a restart).
enum class BootNonce : std::uint64_t {};

enum class Kind : std::uint8_t {
  state,    ///< all that the participant offers and asks for, or one part of it
  claim,    ///< the sender wants this identifier and does not own it yet (paper section 3.5.1)
  goodbye,  ///< the sender gives this identifier up: it ends, or has lost it to a clash
  /// The sender is there and its state is that of `revision`, which is not said again. Name, ontology digest, interval
  /// and addresses are left out, too: they are as the state of that revision says.
  presence,
  /// What has changed since an earlier revision; all else is as that one says, as with a presence.
  change,
};

/// A publication with the GCNP number that its peer gave it. The address is numeric without zone, or empty: the
/// interface's own.
struct NumberedPublication {
  std::uint32_t number = 0;
  Publication publication;
  friend bool operator==(const NumberedPublication&, const NumberedPublication&) = default;
};

struct NumberedSubscription {
  std::uint32_t number = 0;
  Subscription subscription;
  friend bool operator==(const NumberedSubscription&, const NumberedSubscription&) = default;
};

/// One peer and what it offers and asks for. Numbers are unique over all of its lists.
struct PeerState {
  PeerId id{};
  std::string name;
  std::vector<NumberedPublication> publications;
  std::vector<NumberedSubscription> subscriptions;
  /// Services that exist, but whose address is not valid on this interface (on_interface.hpp). Told so that their
  /// absence here is not taken for their end.
  std::vector<std::uint32_t> withheld;
  /// In a change: services that exist no more.
  std::vector<std::uint32_t> removed;
  friend bool operator==(const PeerState&, const PeerState&) = default;
};

/// How lately a participant has heard each of those that it knows. It names none of them: who knows the same ones knows
/// their order.
struct Witness {
  /// Fold of the identifiers and boot nonces of all that the sender knows and of its own.
  std::uint16_t members = 0;
  /// By ascending identifier of all of them, its own included (as `longer`). decode() fills it up to a multiple of four
  /// with `longer`. Empty: nothing is witnessed.
  HeardList heard;
  friend bool operator==(const Witness&, const Witness&) = default;
};

/// The time between two announcements on average: the configured one, doubled so often, but not beyond max_interval.
[[nodiscard]] constexpr base::Duration stretched(base::Duration interval, unsigned doublings) {
  return std::max(interval, std::min<base::Duration>(max_interval, interval * (1 << doublings)));
}

/// Set in `link` where the sender says the same over IPv4 on that interface, under the number without it.
inline constexpr std::uint32_t twin_link = std::uint32_t{1} << 31U;

/// One announcement. encode() splits it into datagrams, decode() makes one of each datagram; for `claim` and `goodbye`
/// revision, addresses and peers stay empty, for `presence` and `change` what their docstrings say.
struct Announcement {
  Kind kind = Kind::state;
  std::string group;            ///< the negotiation group; participants of another one ignore it
  ParticipantId participant{};  ///< never 0
  BootNonce boot{};
  std::uint32_t link = 0;      ///< the sender's number of the interface that it went out on; see twin_link
  std::uint64_t sequence = 0;  ///< counts the sender's datagrams on that interface, so that others can measure loss
  base::Duration interval = std::chrono::seconds(2);  ///< between two of them, on average; whole milliseconds
  /// How often that is doubled because many share the air (stretched()). A presence says this anew.
  std::uint8_t doublings = 0;
  std::string name;                    ///< the participant's; empty: its identifier
  std::uint64_t ontology_digest = 0;   ///< 0: none is loaded
  std::uint32_t lasting = 0;           ///< the sender's identity in all its lives; 0: it has none that lasts
  std::vector<std::string> addresses;  ///< numeric, valid on this interface, best first, without zone

  std::uint64_t revision = 0;    ///< grows with every change of the state; the same on all interfaces
  std::uint64_t since = 0;       ///< of a change: the revision that it begins from, below its own
  std::uint32_t part = 0;        ///< of `part_count` parts of this revision, counted from 0; set by encode()
  std::uint32_t part_count = 1;  ///< set by encode()
  std::vector<PeerState> peers;  ///< by ascending id; a peer without any service is not announced

  // What a presence, and nothing else, says of others.
  Witness witness;
  std::vector<ParticipantId> lacks;   ///< those whose newest state it does not have
  std::vector<ParticipantId> doubts;  ///< those that it will take for gone unless it hears of them soon

  friend bool operator==(const Announcement&, const Announcement&) = default;
};

}  // namespace geminga::announcement

#endif
