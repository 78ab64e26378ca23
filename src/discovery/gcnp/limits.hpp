// How long the parts of a request may be; a longer one is refused with 413 (src/discovery/gcnp/GCNP.md, Limits). What
// describes a service is bounded by what an announcement carries: src/discovery/announcement/limits.hpp has the same
// numbers.
#ifndef GEMINGA_DISCOVERY_GCNP_LIMITS_HPP
#define GEMINGA_DISCOVERY_GCNP_LIMITS_HPP

#include <cstddef>

namespace geminga::gcnp {

/// Octets of `concept=`, `representation=`, `sub=` and `super=`: a name, an IRI or an expression over names.
inline constexpr std::size_t max_concept_bytes = 1024;
/// Octets of `text=`.
inline constexpr std::size_t max_text_bytes = 255;
/// Octets of `where=`.
inline constexpr std::size_t max_where_bytes = 400;
/// Octets of `protocol=`.
inline constexpr std::size_t max_protocol_bytes = 32;
/// Protocols in a subscription's `protocol=` list.
inline constexpr std::size_t max_accepted_protocols = 8;
/// Octets of `filter=`.
inline constexpr std::size_t max_filter_bytes = 256;
/// Attributes of one service, and octets of a key and of a value.
inline constexpr std::size_t max_attributes = 32;
inline constexpr std::size_t max_attribute_key_bytes = 64;
inline constexpr std::size_t max_attribute_value_bytes = 255;
/// Entries of a `provider=` list, and octets of a participant's or peer's name in it.
inline constexpr std::size_t max_providers = 16;
inline constexpr std::size_t max_provider_name_bytes = 64;

}  // namespace geminga::gcnp

#endif
