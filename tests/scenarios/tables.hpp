// The checker of what participants keep: never more than they have room for, and in the end nobody who is gone.
#ifndef GEMINGA_TESTS_SCENARIOS_TABLES_HPP
#define GEMINGA_TESTS_SCENARIOS_TABLES_HPP

#include <cstddef>
#include <map>

#include "sim/team.hpp"
#include "sim/world.hpp"

namespace geminga::scenarios {

/// Asks daemons by `query status`, as an operator does.
class Tables {
 public:
  /// Asks one host after the other, for as long as the world runs.
  Tables(sim::World& world, sim::Team& team);

  /// All views are right and all that was forged is over: everybody must know everybody and everything, and nobody
  /// else.
  void check_all();

 private:
  void ask_next();
  void ask(sim::Host& host);
  void hear(const sim::Host& host, const gcnp::Statement& status);

  sim::World& world_;
  sim::Team& team_;
  std::size_t next_ = 0;
  std::map<const sim::Host*, sim::Client*> askers_;
  bool is_exact_ = false;
};

}  // namespace geminga::scenarios

#endif
