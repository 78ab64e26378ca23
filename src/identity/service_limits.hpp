// The limits of a service and of a request. A request over a limit is refused (src/discovery/gcnp/GCNP.md, Limits), and
// an announcement over a limit is not believed (src/discovery/announcement/ANNOUNCEMENT.md).
#ifndef GEMINGA_IDENTITY_SERVICE_LIMITS_HPP
#define GEMINGA_IDENTITY_SERVICE_LIMITS_HPP

#include <cstddef>

namespace geminga {

/// Names of groups, participants and peers, in octets of UTF-8.
inline constexpr std::size_t max_name_bytes = 64;
/// A text identity, in octets.
inline constexpr std::size_t max_text_identity_bytes = 255;
/// The word for a transport protocol, in octets.
inline constexpr std::size_t max_protocol_bytes = 32;
/// Protocols that one subscription accepts.
inline constexpr std::size_t max_accepted_protocols = 8;
/// Attributes of one service, and the octets of a key and of a value.
inline constexpr std::size_t max_attributes = 32;
inline constexpr std::size_t max_attribute_key_bytes = 64;
inline constexpr std::size_t max_attribute_value_bytes = 255;
/// A scope, in octets.
inline constexpr std::size_t max_scope_bytes = 200;
/// A `where` or `for` expression, in octets.
inline constexpr std::size_t max_where_bytes = 400;
/// Provider filters of one subscription, and as many providers that it favours.
inline constexpr std::size_t max_provider_filters = 16;
/// Services of a choice that a host announces with a subscription.
inline constexpr std::size_t max_announced_choice = 64;
/// Preferences and ranks of a subscription, in octets.
inline constexpr std::size_t max_prefer_bytes = 200;
inline constexpr std::size_t max_rank_bytes = 64;

}  // namespace geminga

#endif
