// A team of robots with modules, and the checkers that watch all of them.
#ifndef GEMINGA_TESTS_SIM_TEAM_HPP
#define GEMINGA_TESTS_SIM_TEAM_HPP

#include <memory>
#include <set>
#include <string>
#include <vector>

#include "sim/client.hpp"
#include "sim/host.hpp"
#include "sim/ledger.hpp"
#include "sim/module.hpp"
#include "sim/world.hpp"

namespace geminga::sim {

/// Watches all modules of a world all the time. Every failure says the seed and the time.
class Team {
 public:
  explicit Team(World& world, Bounds bounds = {});

  Module& add(Host& host, const std::string& name);
  [[nodiscard]] const std::vector<std::unique_ptr<Module>>& modules() const { return modules_; }

  /// Whether every view is exactly right now.
  [[nodiscard]] bool is_right() const { return ledger_.is_right(); }
  /// The present faults of the views, in words; empty: none.
  [[nodiscard]] std::string complaints() const { return ledger_.complaints(); }
  /// Until every view is right, in steps; false after `at_most`.
  bool settle(base::Duration at_most);

  /// Each time that one host was told `del reason=expired` of another one which was well all the time, in words.
  [[nodiscard]] const std::set<std::string>& false_departures() const { return false_departures_; }
  [[nodiscard]] std::size_t events() const { return events_; }
  [[nodiscard]] Ledger& ledger() { return ledger_; }
  [[nodiscard]] const Ledger& ledger() const { return ledger_; }
  /// While true, wrong views are not held against anybody: the network is cut, say.
  bool is_excused = false;

 private:
  void check_identifiers();
  void watch(Module& module);
  void see(Module& module, std::string_view line, const gcnp::Statement& statement);
  [[nodiscard]] bool is_served_by(Module& module, std::string_view participant, Module& other) const;

  World& world_;
  Ledger ledger_;
  std::vector<std::unique_ptr<Module>> modules_;
  base::Instant same_identifier_since_ = base::never;
  base::Instant reach_changed_{-std::chrono::hours(1)};
  std::set<std::string> false_departures_;
  std::size_t events_ = 0;
};

}  // namespace geminga::sim

#endif
