// The workload of a simulated team: its modules offer and ask for things, and now and then something changes.
#ifndef GEMINGA_TESTS_SCENARIOS_WORKLOAD_HPP
#define GEMINGA_TESTS_SCENARIOS_WORKLOAD_HPP

#include <cstddef>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "scenarios/conditions.hpp"
#include "sim/team.hpp"
#include "sim/world.hpp"

namespace geminga::scenarios {

class Workload {
 public:
  Workload(sim::World& world, sim::Team& team, const Conditions& conditions);

  /// Makes hosts and modules, and switches them on within the first second.
  void start();
  /// Ends the workload: new services are withdrawn, and nothing changes after that.
  void stop();
  /// Services that began since the start.
  [[nodiscard]] std::size_t changes() const { return changes_; }

 private:
  /// A service that is new: its place in reporters_, and its number there.
  using News = std::pair<std::size_t, std::uint32_t>;

  void furnish(sim::Host& host);
  void plan_change();
  void change();
  void withdraw_after(base::Duration delay, const News& news);
  [[nodiscard]] bool withdraw(const News& news);

  sim::World& world_;
  sim::Team& team_;
  const Conditions& conditions_;
  base::Random random_;
  std::vector<sim::Module*> reporters_;  ///< one a host: it offers what is new
  std::set<News> standing_;              ///< and not withdrawn
  bool is_over_ = false;
  std::size_t changes_ = 0;
};

}  // namespace geminga::scenarios

#endif
