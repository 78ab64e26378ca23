// Why a service that a peer was told of is gone.
#ifndef GEMINGA_DISCOVERY_MATCHING_ARBITRATION_REASON_HPP
#define GEMINGA_DISCOVERY_MATCHING_ARBITRATION_REASON_HPP

#include <cstdint>
#include <string_view>

namespace geminga::matching {

/// The `reason=` of GCNP. Words are only ever appended.
enum class Reason : std::uint8_t {
  withdrawn,  ///< its peer removed it or disconnected
  expired,    ///< its participant was not heard of before the deadline
  left,       ///< its participant said goodbye
  outranked,  ///< a better one took its place under the subscription's limit
  changed,    ///< it was modified, or the ontology was, and it does not match any longer
  renamed,    ///< its participant took a new identifier after a clash
  /// Its address cannot be reached from here any longer, and the consumer asks for services that can.
  unreachable,
};
[[nodiscard]] std::string_view to_string(Reason reason);

}  // namespace geminga::matching

#endif
