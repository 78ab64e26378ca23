// Lives: 64 random bits of a publisher or subscriber, which stay the same while its daemon is restarted.
#ifndef GEMINGA_CLIENT_PROTOCOL_LIFE_HPP
#define GEMINGA_CLIENT_PROTOCOL_LIFE_HPP

#include "discovery/gcnp/life.hpp"
#include "geminga/life.hpp"

namespace geminga::client {

using gcnp::channel_attribute;
using gcnp::read_life;
using gcnp::stated_life;

/// A new life, by the system's random numbers.
[[nodiscard]] Life new_life();
}  // namespace geminga::client

#endif
