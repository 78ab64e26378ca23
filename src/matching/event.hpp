// What a local peer is to be told, and why something is gone.
#ifndef GEMINGA_MATCHING_EVENT_HPP
#define GEMINGA_MATCHING_EVENT_HPP

#include <cstdint>
#include <string_view>
#include <variant>

#include "geminga/service.hpp"
#include "matching/degree.hpp"
#include "registry/entry.hpp"

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

enum class Change : std::uint8_t { add, modify, del };
[[nodiscard]] std::string_view to_string(Change change);

/// What a local peer is to be told. `to` is its own subscription (for a PublicationEntry) or publication (for a
/// SubscriptionEntry).
struct Event {
  Change change = Change::add;
  ServiceKey to;
  /// As it is now; for del as it was last told.
  std::variant<registry::PublicationEntry, registry::SubscriptionEntry> about;
  Match match;                        ///< for del as it was last told
  Reason reason = Reason::withdrawn;  ///< for del only
};

}  // namespace geminga::matching

#endif
