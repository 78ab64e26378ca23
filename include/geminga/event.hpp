// Events that a peer receives about its publications and subscriptions (paper section 3.3).
#ifndef GEMINGA_EVENT_HPP
#define GEMINGA_EVENT_HPP

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "geminga/error.hpp"
#include "geminga/match.hpp"
#include "geminga/named.hpp"
#include "geminga/service.hpp"

namespace geminga {

/// The change of a service or a consumer. Per request and service the order is: add, any number of modify, del.
enum class Change : std::uint8_t {
  add,     ///< it is there
  modify,  ///< it is still there and something about it is new
  del,     ///< it is gone
};

/// The word of GCNP for a change: "add", "modify", "del". Static storage.
[[nodiscard]] std::string_view to_string(Change change);
/// The change of a GCNP word, or nothing.
[[nodiscard]] std::optional<Change> change(std::string_view word);

/// A subscription has a service: `N pub add|modify|del service=...`. After `del` only service and reason are filled.
struct ServiceEvent {
  Change change = Change::add;
  ServiceKey service;            ///< the same in every event about it; names the provider, too
  std::string peer_name;         ///< the provider's name; empty: none
  std::string participant_name;  ///< of the provider's daemon
  NamedPublication publication;  ///< names are `prefix:Name` or `<IRI>`; the address is one that works here
  Degree degree = Degree::exact;
  std::uint32_t distance = 0;  ///< taxonomy edges between what was asked for and what was found
  std::string reason;          ///< after `del`: "withdrawn", "expired", "left", "outranked", "unreachable", ...
  std::string
      convert{};  ///< the conversions from its representation to the requested one: "A>B>C"; empty: none is needed
  std::uint32_t cost = 0;  ///< of the conversions
  std::string
      via{};  ///< the service of each step: "-,udp://10.0.0.7:6000/SERVICE", "-" for the consumer; empty: it does all
  std::uint32_t hops = 0;  ///< relays on the way to its host; 0: it is heard directly
  std::string path{};      ///< the names of those that are known, joined by '/', the nearest to its host first
  bool reachable = true;   ///< false: its address cannot be reached from this host, as far as that is certain
  friend bool operator==(const ServiceEvent&, const ServiceEvent&) = default;
};

/// A publication has a consumer: `N sub add|modify|del subscription=...`. After `del` only subscription and reason are
/// filled.
struct ConsumerEvent {
  Change change = Change::add;
  ServiceKey subscription;       ///< the same in every event about it; names the consumer, too
  std::string peer_name;         ///< the consumer's name; empty: none
  std::string participant_name;  ///< of the consumer's daemon
  NamedSubscription subscribed;  ///< the request: identity, mode, address, port, priority, attributes
  Degree degree = Degree::exact;
  std::uint32_t distance = 0;
  std::string reason;
  std::uint32_t hops = 0;  ///< relays on the way to its host; 0: it is heard directly
  std::string path{};      ///< the names of those that are known, joined by '/', the nearest to its host first
  bool reachable = true;   ///< false: its address cannot be reached from this host, as far as that is certain
  friend bool operator==(const ConsumerEvent&, const ConsumerEvent&) = default;
};

/// One event about the request with this number, or the error that follows the request.
struct Event {
  std::uint32_t request = 0;
  std::variant<ServiceEvent, ConsumerEvent, Error> what;
  friend bool operator==(const Event&, const Event&) = default;
};

}  // namespace geminga

#endif
