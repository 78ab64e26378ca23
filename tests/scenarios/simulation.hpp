// One simulated run: a team, what goes wrong with it, and everything that is watched and measured meanwhile.
#ifndef GEMINGA_TESTS_SCENARIOS_SIMULATION_HPP
#define GEMINGA_TESTS_SCENARIOS_SIMULATION_HPP

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "scenarios/conditions.hpp"
#include "sim/ledger.hpp"

namespace geminga::scenarios {

/// The result of a run.
struct Result {
  std::uint64_t trace_hash = 0;  ///< of every datagram, line and log line, with its time and its author
  std::vector<std::string> violations;
  sim::Delays delays;
  std::size_t never_told = 0;
  std::size_t false_departures = 0;
  std::size_t events = 0;  ///< that modules were told
  std::uint64_t datagrams = 0;
  std::uint64_t octets = 0;  ///< of all datagrams, with 42 of headers each
  base::Duration simulated{};
  base::Duration agreed_after{};  ///< from the first start until all views were right
  std::size_t participants = 0;

  /// Octets that a host sends in a second.
  [[nodiscard]] double octets_per_host_second() const;
};

/// Where the run tells what happens, a line each; may be empty.
using Tell = std::function<void(const std::string& line)>;

/// Called each few simulated milliseconds with the simulated time and the datagrams that were sent; may be empty.
using OnProgress = std::function<void(base::Duration simulated, std::uint64_t datagrams)>;

/// Runs to its end: the time of its conditions, or until the script is over and all agree, if that takes longer.
[[nodiscard]] Result simulate(const Conditions& conditions, const Tell& tell = {}, const OnProgress& progress = {});

/// How long after the last fault all views are right. See tests/scenarios/README.md for the argument.
[[nodiscard]] base::Duration agreement_bound(const Conditions& conditions);

}  // namespace geminga::scenarios

#endif
