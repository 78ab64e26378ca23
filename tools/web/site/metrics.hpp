// The metrics of a daemon, from its answers.
#ifndef GEMINGA_WEB_SITE_METRICS_HPP
#define GEMINGA_WEB_SITE_METRICS_HPP

#include <cstdint>
#include <map>
#include <vector>

#include "web/asking/asker.hpp"
#include "web/site/exposition.hpp"

namespace geminga::web {

/// The questions whose answers metrics() needs, in its order.
[[nodiscard]] const std::vector<Query>& metric_questions();

/// The program's own counters.
struct Traffic {
  std::map<unsigned, std::uint64_t> responses{};  ///< by status
  std::uint64_t streams = 0;                      ///< of events, since the start
};

/// The metrics of the answers to metric_questions(). An answer that is an error leaves its metrics out; without an
/// answer to `status` the daemon counts as down.
[[nodiscard]] std::vector<Family> metrics(const std::vector<Outcome>& outcomes, const Traffic& traffic);

}  // namespace geminga::web

#endif
