// Experiments that show without any right what the firewall and the routes of this host do. Nothing leaves the host.
#ifndef GEMINGA_DOCTOR_EXPERIMENTS_HPP
#define GEMINGA_DOCTOR_EXPERIMENTS_HPP

#include <string>

#include "doctor/firewall.hpp"

namespace geminga::doctor {

/// Whether the host's firewall refuses a datagram to a group. The datagram has a time to live of 0 and no copy for this
/// host: it passes the rules for what goes out, and nobody gets it.
[[nodiscard]] bool is_refused(const Crossing& out);

/// Whether the kernel has a route to a numeric address. True for what is no address.
[[nodiscard]] bool has_route(const std::string& address);

}  // namespace geminga::doctor

#endif
