// A finite automaton over roles: the words that imply a property.
#ifndef GEMINGA_REASONING_OWL_AUTOMATON_HPP
#define GEMINGA_REASONING_OWL_AUTOMATON_HPP

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "reasoning/owl/role.hpp"

namespace geminga::owl {

/// Words begin in state 0. They end in state 1, or, after reduced(), in the states of is_final().
class Automaton {
 public:
  using State = std::uint32_t;
  struct Move {
    State from = 0;
    Role label;
    State to = 0;
    friend auto operator<=>(const Move&, const Move&) = default;
  };
  static constexpr State begin = 0;
  static constexpr State end = 1;

  State add_state() { return states_++; }
  void add_move(State from, Role label, State to) { moves_.push_back({from, label, to}); }
  void add_empty_move(State from, State to) { empty_moves_.emplace_back(from, to); }
  /// A copy of another automaton between two states of this one.
  void add_copy(State from, const Automaton& other, State to);

  /// Whether `second` holds wherever `first` does.
  using Includes = std::function<bool(Role first, Role second)>;
  /// The automaton of the same language without empty moves, without states that lead nowhere, and without moves that
  /// others make superfluous.
  [[nodiscard]] Automaton reduced(const Includes& includes) const;

  [[nodiscard]] State state_count() const { return states_; }
  [[nodiscard]] const std::vector<Move>& moves() const { return moves_; }
  [[nodiscard]] bool is_final(State state) const { return final_.empty() ? state == end : final_[state]; }
  /// Whether no move leaves it.
  [[nodiscard]] bool is_dead_end(State state) const;

 private:
  [[nodiscard]] std::vector<std::vector<State>> empty_closures() const;
  class Inclusions;
  void drop_superfluous(const Includes& includes);
  void drop_smaller(const Inclusions& labels, const auto& is_simulated);
  void trim();

  State states_ = 2;
  std::vector<Move> moves_;
  std::vector<std::pair<State, State>> empty_moves_;
  std::vector<bool> final_;
};

}  // namespace geminga::owl

#endif
