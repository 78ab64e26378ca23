// The keys that GCNP gives a meaning to; every other key is an attribute of a service.
#ifndef GEMINGA_DISCOVERY_GCNP_RESERVED_HPP
#define GEMINGA_DISCOVERY_GCNP_RESERVED_HPP

#include <algorithm>
#include <array>
#include <string_view>

namespace geminga::gcnp {

/// The one table of reserved keys. A statement in which a word has no meaning is refused with 400, so that a misplaced
/// key is told. An attribute of that name is written with its prefix (gcnp/attribute.hpp). Words are only ever
/// appended.
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
                                                                       "peer",
                                                                       "favour",
                                                                       "prefer",
                                                                       "convert",
                                                                       "scope",
                                                                       "rank",
                                                                       "for"});

/// Keys of the daemon's own lines that a client may still state as attributes. Such attributes are written `attr.NAME`
/// in every line of the daemon, so that none can be taken for a key. Words are only ever appended.
inline constexpr auto keys_of_lines =
    std::to_array<std::string_view>({"why", "because", "unplaced", "placed", "on", "hops", "reachable", "reach"});

/// Keys of a `sub` that a `pub` may state as attributes. Both may state such an attribute as `attr.NAME`. Words are
/// only ever appended.
inline constexpr auto keys_of_requests = std::to_array<std::string_view>({"on", "reach"});

[[nodiscard]] constexpr bool is_key_of_requests(std::string_view key) {
  return std::ranges::find(keys_of_requests, key) != keys_of_requests.end();
}

[[nodiscard]] constexpr bool is_key_of_lines(std::string_view key) {
  return std::ranges::find(keys_of_lines, key) != keys_of_lines.end();
}

[[nodiscard]] constexpr bool is_reserved(std::string_view key) {
  return std::ranges::find(reserved_keys, key) != reserved_keys.end();
}

}  // namespace geminga::gcnp

#endif
