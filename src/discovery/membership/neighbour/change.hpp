// The changes of a registry when a remote participant is heard, or is not heard.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_NEIGHBOUR_CHANGE_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_NEIGHBOUR_CHANGE_HPP

#include <cstdint>
#include <string>
#include <variant>

#include "base/time.hpp"
#include "geminga/service.hpp"

namespace geminga::membership {

/// The reason why something remote is gone. Its words are those of matching::Reason.
enum class Departure : std::uint8_t {
  withdrawn,  ///< its participant announced that it is gone
  expired,    ///< not heard of before the deadline
  left,       ///< its participant said goodbye
};

/// A remote publication is there, has changed, or was said again (then only `heard` differs). That a presence affirms
/// it is told by Neighbours::affirmed(). The address is empty only if nothing is known of the sender; an IPv6
/// link-local one has our interface as its zone. `is_reachable`: false where it is the address of a participant that
/// cannot be reached from here; an address that a service states for itself is not judged.
struct PutPublication {
  ServiceKey key;
  Publication publication;
  std::string peer_name;
  std::string participant_name;
  base::Instant heard;  ///< registry::PublicationEntry::updated
  bool is_reachable = true;
  friend bool operator==(const PutPublication&, const PutPublication&) = default;
};
struct PutSubscription {
  ServiceKey key;
  Subscription subscription;
  std::string peer_name;
  std::string participant_name;
  base::Instant heard;
  bool is_reachable = true;
  friend bool operator==(const PutSubscription&, const PutSubscription&) = default;
};
struct RemovePublication {
  ServiceKey key;
  Departure reason = Departure::withdrawn;
  friend bool operator==(const RemovePublication&, const RemovePublication&) = default;
};
struct RemoveSubscription {
  ServiceKey key;
  Departure reason = Departure::withdrawn;
  friend bool operator==(const RemoveSubscription&, const RemoveSubscription&) = default;
};
/// A participant is gone with everything of it; its services are not removed one by one.
struct RemoveParticipant {
  ParticipantId participant{};
  Departure reason = Departure::expired;
  friend bool operator==(const RemoveParticipant&, const RemoveParticipant&) = default;
};
/// A change that the caller makes to its registry, in the order of the list.
using Change = std::variant<PutPublication, PutSubscription, RemovePublication, RemoveSubscription, RemoveParticipant>;

}  // namespace geminga::membership

#endif
