// The limits of the parts of a request; a longer one is refused with 413 (src/discovery/gcnp/GCNP.md, Limits). A
// service is bounded by what an announcement carries: identity/service_limits.hpp.
#ifndef GEMINGA_DISCOVERY_GCNP_LIMITS_HPP
#define GEMINGA_DISCOVERY_GCNP_LIMITS_HPP

#include <cstddef>

#include "identity/service_limits.hpp"

namespace geminga::gcnp {

/// Octets of `concept=`, `representation=`, `sub=` and `super=`: a name, an IRI or an expression over names.
inline constexpr std::size_t max_concept_bytes = 1024;
/// Octets of `filter=`.
inline constexpr std::size_t max_filter_bytes = 256;

}  // namespace geminga::gcnp

#endif
