// The daemon's words about itself: lines for its log, and its own fields of `query status`.
#ifndef GEMINGA_DAEMON_STATUS_HPP
#define GEMINGA_DAEMON_STATUS_HPP

#include <string>
#include <vector>

#include "daemon/cage_in_force.hpp"
#include "daemon/configuration/configuration_in_force.hpp"
#include "daemon/log/log.hpp"
#include "daemon/ontology/ontology_in_force.hpp"
#include "discovery/participant/participant.hpp"
#include "env/asio/asio_env.hpp"

namespace geminga::daemon {

/// Where clients connect, on which interfaces the daemon speaks, and with which ontology.
[[nodiscard]] std::string ready_line(const Configuration& configuration, const env::AsioEnv& env,
                                     const OntologyInForce& ontology);
[[nodiscard]] std::string interfaces_line(const env::AsioEnv& env);
[[nodiscard]] std::string sealing_line(const sealing::Policy& sealing);

/// Memory, processor time, the cage, port and groups, what was dropped, peers, and why the configuration could not be
/// read again. `started` is the wall clock at the start, in seconds since 1970.
[[nodiscard]] std::vector<gcnp::Parameter> status_fields(const ConfigurationInForce& configuration,
                                                         const CageInForce& cage, const env::AsioEnv& env,
                                                         const OntologyInForce& ontology, const Log& log,
                                                         double started);

}  // namespace geminga::daemon

#endif
