// Experiments that show without any right what the firewall and the routes of this host do. Nothing leaves the host.
#ifndef GEMINGA_DOCTOR_EXPERIMENTS_HPP
#define GEMINGA_DOCTOR_EXPERIMENTS_HPP

#include <string>

#include "doctor/firewall.hpp"

namespace geminga::doctor {

/// Sends a datagram to a group, and tells what the kernel does with it. The datagram has a time to live of 0 and no
/// copy for this host: it passes routes and rules for what goes out, and nobody gets it. `leaves` where that cannot be
/// tried.
[[nodiscard]] Sending try_to_send(const Crossing& out);

/// Whether the kernel has a route to a numeric address. True for what is no address.
[[nodiscard]] bool has_route(const std::string& address);

}  // namespace geminga::doctor

#endif
