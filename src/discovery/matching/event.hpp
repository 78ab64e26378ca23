// What a local peer is to be told, and why something is gone.
#ifndef GEMINGA_DISCOVERY_MATCHING_EVENT_HPP
#define GEMINGA_DISCOVERY_MATCHING_EVENT_HPP

#include <cstdint>
#include <memory>
#include <string_view>
#include <variant>

#include "discovery/matching/degree.hpp"
#include "discovery/registry/entry.hpp"
#include "geminga/event.hpp"
#include "geminga/service.hpp"

namespace geminga::matching {

/// Why a service that was told of is gone; the `reason=` of GCNP. Words are only ever appended.
enum class Reason : std::uint8_t {
  withdrawn,  ///< its peer removed it or disconnected
  expired,    ///< its participant was not heard of before the deadline
  left,       ///< its participant said goodbye
  outranked,  ///< a better one took its place under the subscription's limit
  changed,    ///< it was modified and matches no more, or the ontology was
  renamed,    ///< its participant took a new identifier after a clash
};
[[nodiscard]] std::string_view to_string(Reason reason);

/// What a local peer is to be told. `to` is its own subscription (for a PublicationEntry) or publication (for a
/// SubscriptionEntry).
struct Event {
  Change change = Change::add;
  ServiceKey to;
  /// As it is now; for del as it was last told. Never null; the events of one cause share it.
  std::variant<std::shared_ptr<const registry::PublicationEntry>, std::shared_ptr<const registry::SubscriptionEntry>>
      about;
  Match match;                        ///< for del as it was last told
  Reason reason = Reason::withdrawn;  ///< for del only
  /// Of a service, how its representation is turned into what is asked for; null: it need not be, or for del.
  std::shared_ptr<const vocabulary::Chain> chain{};
};

/// Whether an event about the one says the same as an event about the other. What its own host judges by is not told:
/// of a publication for whom it is, of a subscription what it wants to have of those that meet it.
[[nodiscard]] bool is_told_alike(const registry::PublicationEntry& one, const registry::PublicationEntry& other);
[[nodiscard]] bool is_told_alike(const registry::SubscriptionEntry& one, const registry::SubscriptionEntry& other);

}  // namespace geminga::matching

#endif
