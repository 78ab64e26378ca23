// The keys that GCNP gives a meaning to; every other key is an attribute of a service.
#ifndef GEMINGA_GCNP_RESERVED_HPP
#define GEMINGA_GCNP_RESERVED_HPP

#include <algorithm>
#include <array>
#include <string_view>

namespace geminga::gcnp {

/// The one table. A service cannot have an attribute with one of these names: in a statement where it has no meaning it
/// is refused with 400, so that a misplaced key is told and an event is never ambiguous. Words are only ever appended.
inline constexpr auto reserved_keys = std::to_array<std::string_view>({"mode",
                                                                       "id",
                                                                       "text",
                                                                       "concept",
                                                                       "representation",
                                                                       "port",
                                                                       "address",
                                                                       "protocol",
                                                                       "priority",
                                                                       "match",
                                                                       "provider",
                                                                       "where",
                                                                       "limit",
                                                                       "service",
                                                                       "name",
                                                                       "degree",
                                                                       "reason",
                                                                       "subscription",
                                                                       "participant_name",
                                                                       "consumer",
                                                                       "distance",
                                                                       "age",
                                                                       "local",
                                                                       "used",
                                                                       "served",
                                                                       "participant",
                                                                       "peer"});

[[nodiscard]] constexpr bool is_reserved(std::string_view key) {
  return std::ranges::find(reserved_keys, key) != reserved_keys.end();
}

}  // namespace geminga::gcnp

#endif
