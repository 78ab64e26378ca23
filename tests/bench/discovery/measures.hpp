// The measurements of a team of whole daemons under loss; each prints its rows.
#ifndef GEMINGA_TESTS_BENCH_DISCOVERY_MEASURES_HPP
#define GEMINGA_TESTS_BENCH_DISCOVERY_MEASURES_HPP

#include <cstddef>
#include <string>

#include "support/lab_team.hpp"

namespace geminga::bench {

/// The targets of a team at one loss; 0 means no target.
struct Targets {
  double loss = 0;
  double start_ms = 0;      ///< all started together know each other
  double start_octets = 0;  ///< that a host has sent by then
  double told_ms = 0;       ///< of a service that is new, or withdrawn
  double death_ms = 0;
  double healed_ms = 0;      ///< all is right after a partition
  double steady_octets = 0;  ///< a second and host, with headers
  double change_octets = 0;  ///< of the whole team for one change, without headers
  double processor_ms = 0;   ///< a second and daemon
};

/// The durations of the measurements.
struct Effort {
  int changes = 0;
  int settling_seconds = 0;  ///< after a start, until nobody repeats anything
  int quiet_seconds = 0;
  int partition_seconds = 0;
};

/// One team at one loss, measured by each of these in turn. Each leaves a team in which all is right.
class Measures {
 public:
  Measures(std::size_t hosts, const Targets& targets, const Effort& effort);

  void start();      ///< all at once
  void steady();     ///< nothing changes, nobody leaves
  void telling();    ///< services come and go
  void death();      ///< a daemon is killed and stays away
  void restart();    ///< a daemon is killed and started again at once
  void partition();  ///< two halves do not hear each other, and change meanwhile

 private:
  void row(const std::string& name, double figure, const std::string& unit, double target) const;
  void complain(const std::string& what) const;
  /// The size column of a row: the number of hosts and the loss.
  [[nodiscard]] std::string size() const;
  /// Waits until all is right, or says what is not.
  void expect_right();

  Targets targets_;
  Effort effort_;
  system::LabTeam team_;
  double steady_octets_ = 0;  ///< of the whole team in a millisecond, without headers
};

/// Waits.
void rest(int time_ms);

}  // namespace geminga::bench

#endif
