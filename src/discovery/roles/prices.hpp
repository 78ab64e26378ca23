// Prices of roles: how little any choice of robots can cost.
#ifndef GEMINGA_DISCOVERY_ROLES_PRICES_HPP
#define GEMINGA_DISCOVERY_ROLES_PRICES_HPP

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "discovery/roles/decisions.hpp"
#include "discovery/roles/pool.hpp"

namespace geminga::roles {

/// A Lagrangian relaxation (Held and Karp 1971; Fisher 1981; for set covers Beasley 1990): instead of filling all roles
/// a choice is paid a price for each holder. A robot then takes what pays it, by itself, and those that gain most are
/// chosen. What is paid for all roles less what the robots gain is a bound from below at any prices; the best prices
/// give that of the linear programme. All numbers are whole, so that the result is equal on every host. `pool` is
/// borrowed.
class Prices {
 public:
  /// The unit of prices and bounds in terms of one unit of cost.
  static constexpr Cost unit = 4096;

  /// Each robot costs `cost_of_robot` beside its holdings. Prices begin with what the last holder needed would cost.
  Prices(const Pool& pool, Cost cost_of_robot);

  /// The least that a choice can cost that agrees with the decisions, in units. Robots times their roles.
  Cost bound(const Decisions& decisions);
  /// Those who are chosen at these prices.
  [[nodiscard]] const std::vector<bool>& chosen() const { return chosen_; }
  /// Whether they fill each role, if everybody may hold any number.
  [[nodiscard]] bool fills_all() const;
  /// By robot: what it costs, less what it is paid.
  [[nodiscard]] const std::vector<Cost>& values() const { return values_; }
  /// Decisions that must be made since another decision costs more than `gap` units beyond the bound.
  [[nodiscard]] std::vector<std::pair<std::size_t, Decisions::State>> forced(const Decisions& decisions,
                                                                             Cost gap) const;

  /// Moves the prices towards what the last bound() showed to be short or too many: a subgradient, deflected by the
  /// former ones (Camerini, Fratta and Maffioli 1975). `part` is out of 256 parts of the step by which a straight way
  /// would rise by `distance` units. False if the prices are the best.
  bool move(Cost distance, Cost part);
  /// Forgets the direction of former moves.
  void stand() { direction_.assign(direction_.size(), 0); }

  [[nodiscard]] const std::vector<Cost>& of_roles() const { return prices_; }
  void set(std::vector<Cost> prices) { prices_ = std::move(prices); }

  struct Match {
    bool is_possible = false;
    Cost bound = 0;  ///< in units; 0 where robots without a place may be chosen
    std::vector<bool> robots{};
  };
  /// The cheapest matching of roles that are not shared where shared roles are paid their prices, and the robots in it,
  /// filled up with the best others. Is asked for behind bound(). The prices of roles that are not shared become those
  /// of the matching, and the next move() is by what shared roles lack in it.
  Match match(const Decisions& decisions);

 private:
  [[nodiscard]] Cost gain_of_shared(const Candidate& robot) const;
  /// The robots that may take a place in a matching, and what each of them costs beside its holding.
  struct Entrants {
    std::vector<std::size_t> robots{};
    std::vector<Cost> costs{};
    Cost bonuses = 0;  ///< of bound robots, all together
  };
  [[nodiscard]] Entrants entrants(const Decisions& decisions) const;
  /// The costs of a matching of places and entrants.
  [[nodiscard]] std::vector<Cost> costs_of_places(const Entrants& entrants,
                                                  const std::vector<std::uint32_t>& role_of) const;
  /// Counts the holders of shared roles that these robots lack.
  void count_short(const std::vector<bool>& robots);
  /// Adds the best open robots, up to `most` in all.
  void fill_up(std::vector<bool>& robots, std::size_t most) const;
  [[nodiscard]] bool needs_place(std::size_t robot, const Decisions& decisions) const;

  const Pool& pool_;
  Cost cost_of_robot_;
  std::vector<Cost> prices_;  ///< by role
  std::vector<Cost> direction_;
  std::vector<Cost> short_of_;           ///< by role: holders that are lacking; negative: too many
  std::vector<Cost> values_;             ///< by robot
  std::vector<std::uint32_t> place_of_;  ///< by robot: the role that is not shared that it takes
  std::vector<bool> chosen_;
  std::vector<std::size_t> free_;  ///< robots that are open, those who are taken first
  std::size_t taken_ = 0;
};

}  // namespace geminga::roles

#endif
