// The way by which the operating system would send to an address.
#ifndef GEMINGA_ENV_ROUTE_KIND_HPP
#define GEMINGA_ENV_ROUTE_KIND_HPP

#include <cstdint>

namespace geminga::env {

enum class RouteKind : std::uint8_t {
  unknown,   ///< the world does not tell
  none,      ///< there is none, or one that forbids the address
  own,       ///< the address is the host's own, or in a subnet of one of its interfaces
  specific,  ///< a router is named for a part of the address space that has the address in it
  fallback,  ///< only the default route has it in it, as it has every address
};

}  // namespace geminga::env

#endif
