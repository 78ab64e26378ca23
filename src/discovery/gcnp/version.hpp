// The version of GCNP; CONTRIBUTING.md says what it promises.
#ifndef GEMINGA_DISCOVERY_GCNP_VERSION_HPP
#define GEMINGA_DISCOVERY_GCNP_VERSION_HPP

#include <cstdint>

namespace geminga::gcnp {

/// Told to each client in the answer to its hello.
inline constexpr std::uint32_t gcnp_version = 1;

}  // namespace geminga::gcnp

#endif
