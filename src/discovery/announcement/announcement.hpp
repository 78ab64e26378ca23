// The announcements of a participant: its state, a claim of an identifier, or a goodbye (paper section 3.5.2).
#ifndef GEMINGA_DISCOVERY_ANNOUNCEMENT_ANNOUNCEMENT_HPP
#define GEMINGA_DISCOVERY_ANNOUNCEMENT_ANNOUNCEMENT_HPP

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "base/time.hpp"
#include "discovery/announcement/heard_list.hpp"
#include "discovery/announcement/limits.hpp"
#include "discovery/announcement/relayed.hpp"
#include "geminga/service.hpp"

namespace geminga::announcement {

/// 64 random bits that a process draws once. They tell its datagrams from those of another participant with the same
/// identifier (a clash), and from those of its own earlier incarnation (a restart).
enum class BootNonce : std::uint64_t {};

enum class Kind : std::uint8_t {
  state,    ///< everything that the participant offers and asks for, or one part of it
  claim,    ///< the sender wants this identifier and does not own it yet (paper section 3.5.1)
  goodbye,  ///< the sender gives this identifier up: it ends, or has lost it in a clash
  /// The sender is there, and its state is that of `revision`, which is not repeated. Name, ontology digest, interval
  /// and addresses are left out, too: they are as the state of that revision says.
  presence,
  /// The services that have changed since an earlier revision. All else is as that revision says, as in a presence.
  change,
  /// A question to one participant: what do you hear, and how are you? Said for a user's diagnosis only.
  inquiry,
  /// The answer to an inquiry.
  diagnosis,
  /// A datagram of another participant, passed on by a relay.
  relayed,
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

/// One peer and its services. Numbers are unique over all of its lists. The peer 0 is the participant itself: its only
/// publication, or the only number that it removes, is its description (description_key()).
struct PeerState {
  PeerId id{};
  std::string name;
  std::vector<NumberedPublication> publications;
  std::vector<NumberedSubscription> subscriptions;
  /// Services that exist, but whose address is not valid on this interface (on_interface.hpp). They are listed so that
  /// their absence is not taken for their end.
  std::vector<std::uint32_t> withheld;
  /// In a change: services that were removed.
  std::vector<std::uint32_t> removed;
  friend bool operator==(const PeerState&, const PeerState&) = default;
};

/// Testimony: how lately a participant has heard each one that it knows. It names none of them: a receiver that knows
/// the same participants knows their order.
struct Witness {
  /// Fold of the identifiers, boot nonces and revisions of all participants that the sender knows, and of its own.
  std::uint16_t members = 0;
  /// In ascending order of identifier, its own included (as `longer`). decode() fills it up to a multiple of four with
  /// `longer`. Empty: no testimony.
  HeardList heard;
  friend bool operator==(const Witness&, const Witness&) = default;
};

/// A participant that the sender of a presence hears on this link, and an address at which it can be reached there.
struct Introduction {
  ParticipantId participant{};  ///< never 0
  std::string address;          ///< numeric, without zone
  friend bool operator==(const Introduction&, const Introduction&) = default;
};

/// The average time between two announcements: the configured one, doubled so often, but at most max_interval.
[[nodiscard]] constexpr base::Duration stretched(base::Duration interval, unsigned doublings) {
  return std::max(interval, std::min<base::Duration>(max_interval, interval * (1 << doublings)));
}

/// Set in `link` on the IPv6 side of a dual-stack interface: the sender says the same over IPv4 there, under the number
/// without this bit.
inline constexpr std::uint32_t ipv6_side_bit = std::uint32_t{1} << 31U;

/// One announcement. encode() splits it into datagrams, decode() makes one of each datagram. In a claim and a goodbye
/// revision, addresses and peers are empty; in a presence, a change, an inquiry and a diagnosis those that their
/// docstrings leave out are.
struct Announcement {
  Kind kind = Kind::state;
  std::string group;            ///< the negotiation group; participants of another one ignore it
  ParticipantId participant{};  ///< never 0
  BootNonce boot{};
  std::uint32_t link = 0;      ///< the sender's number of the interface that it went out on; see ipv6_side_bit
  std::uint64_t sequence = 0;  ///< counts the sender's datagrams on that interface, so that others can measure loss
  base::Duration interval = std::chrono::seconds(2);  ///< the average time between two of them; whole milliseconds
  /// How often that is doubled because many share the air (stretched()). A presence says it anew.
  std::uint8_t doublings = 0;
  std::string name;                    ///< the participant's; empty: its identifier
  std::uint64_t ontology_digest = 0;   ///< 0: none is loaded
  std::uint32_t lasting = 0;           ///< the same in all incarnations of the sender; 0: it has none
  std::vector<std::string> addresses;  ///< numeric, valid on this interface, best first, without zone

  std::uint64_t revision = 0;    ///< grows with every change of the state; the same on all interfaces
  std::uint64_t since = 0;       ///< of a change: the revision that it begins from, below its own
  std::uint32_t part = 0;        ///< number among `part_count` parts of this revision, from 0; set by encode()
  std::uint32_t part_count = 1;  ///< set by encode()
  std::vector<PeerState> peers;  ///< by ascending id; a peer without a service is not announced

  // Testimony and questions about others, in a presence only.
  Witness witness;
  std::vector<ParticipantId> lacks;         ///< participants whose newest state it does not have
  std::vector<ParticipantId> doubts;        ///< participants that it will take for gone unless it hears of them soon
  std::vector<Introduction> introductions;  ///< for a receiver that does not hear these; max_introductions at most

  // Of an inquiry and a diagnosis only, which have no state and no testimony.
  ParticipantId partner{};         ///< the one that is asked, or has asked; never 0
  std::uint64_t token = 0;         ///< drawn by the one that asks
  std::vector<std::string> lines;  ///< of a diagnosis: `word key=value ...`

  std::vector<Behind> behind;  ///< of a relay's presence: participants that are not heard on this link
  Relayed relayed;             ///< of a relayed word, which has nothing else but its sender

  friend bool operator==(const Announcement&, const Announcement&) = default;
};

}  // namespace geminga::announcement

#endif
