// What the modules of a simulated team do: they offer and ask for things, and now and then something changes.
#ifndef GEMINGA_TESTS_SCENARIOS_WORKLOAD_HPP
#define GEMINGA_TESTS_SCENARIOS_WORKLOAD_HPP

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "scenarios/setup.hpp"
#include "sim/team.hpp"
#include "sim/world.hpp"

namespace geminga::scenarios {

class Workload {
 public:
  Workload(sim::World& world, sim::Team& team, const Setup& setup);

  /// Makes hosts and modules, and switches them on within the first second.
  void start();
  /// Nothing changes any more.
  void stop() { is_over_ = true; }
  /// Services that began since the start.
  [[nodiscard]] std::size_t changes() const { return changes_; }

 private:
  void furnish(sim::Host& host);
  void plan_change();
  void change();

  sim::World& world_;
  sim::Team& team_;
  const Setup& setup_;
  base::Random random_;
  std::vector<sim::Module*> reporters_;  ///< one a host: it offers what is new
  bool is_over_ = false;
  std::size_t changes_ = 0;
};

}  // namespace geminga::scenarios

#endif
