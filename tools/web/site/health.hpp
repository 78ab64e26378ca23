// Whether the daemon answers and is up to date.
#ifndef GEMINGA_WEB_SITE_HEALTH_HPP
#define GEMINGA_WEB_SITE_HEALTH_HPP

#include <string>

#include "geminga/client.hpp"
#include "geminga/result.hpp"

namespace geminga::web {

/// Why a daemon with this answer to `query status` is not ready, in one line; empty: it is. It is not while it starts
/// or stops, while it reads ontologies, and while what it was last told to read (ontologies, configuration) is not in
/// force.
[[nodiscard]] std::string unreadiness(const Result<Answer, ClientError>& status);

}  // namespace geminga::web

#endif
