// Closing over empty moves, and the reduction by simulation.
#include "clauses/automaton.hpp"

#include <algorithm>

namespace geminga::clauses {
namespace {

/// Larger automata are not looked through for superfluous moves: the search grows with the cube of the states.
constexpr std::size_t max_simulated_states = 300;

void sort_unique(auto& items) {
  std::ranges::sort(items);
  const auto repeated = std::ranges::unique(items);
  items.erase(repeated.begin(), repeated.end());
}

}  // namespace

void Automaton::add_copy(State from, const Automaton& other, State to) {
  const State offset = states_;
  states_ += other.states_;
  for (const Move& move : other.moves_) moves_.push_back({offset + move.from, move.label, offset + move.to});
  for (const auto& [first, second] : other.empty_moves_) empty_moves_.emplace_back(offset + first, offset + second);
  empty_moves_.emplace_back(from, offset + begin);
  for (State state = 0; state < other.states_; ++state) {
    if (other.is_final(state)) empty_moves_.emplace_back(offset + state, to);
  }
}

bool Automaton::is_dead_end(State state) const {
  return std::ranges::none_of(moves_, [state](const Move& move) { return move.from == state; });
}

std::vector<std::vector<Automaton::State>> Automaton::empty_closures() const {
  std::vector<std::vector<State>> next(states_);
  for (const auto& [from, to] : empty_moves_) next[from].push_back(to);
  std::vector<std::vector<State>> closures(states_);
  std::vector<State> seen_for(states_, states_);
  for (State state = 0; state < states_; ++state) {
    std::vector<State>& closure = closures[state];
    closure.push_back(state);
    seen_for[state] = state;
    for (std::size_t at = 0; at < closure.size(); ++at) {
      for (const State to : next[closure[at]]) {
        if (seen_for[to] == state) continue;
        seen_for[to] = state;
        closure.push_back(to);
      }
    }
  }
  return closures;
}

Automaton Automaton::reduced(const Includes& includes) const {
  const auto closures = empty_closures();
  Automaton result;
  result.states_ = states_;
  result.final_.assign(states_, false);
  result.final_[end] = true;
  for (const State state : closures[begin]) {
    if (state == end) result.final_[begin] = true;
  }
  // What is reachable from the beginning without a letter begins there, too.
  std::vector<bool> begins(states_, false);
  for (const State state : closures[begin]) begins[state] = true;
  for (const Move& move : moves_) {
    for (const State to : closures[move.to]) {
      result.moves_.push_back({move.from, move.label, to});
      if (begins[move.from]) result.moves_.push_back({begin, move.label, to});
    }
  }
  sort_unique(result.moves_);
  result.trim();
  if (result.states_ <= max_simulated_states) result.drop_superfluous(includes);
  result.trim();
  return result;
}

void Automaton::drop_superfluous(const Includes& includes) {
  // A state p is simulated by q if q ends words where p does, and for every move of p one of q by a role that includes
  // the label leads to a state that simulates the target. The greatest such relation, by refinement.
  std::vector<std::vector<bool>> simulates(states_, std::vector<bool>(states_, true));  // [p][q]: q simulates p
  std::vector<std::vector<Move>> from(states_);
  for (const Move& move : moves_) from[move.from].push_back(move);
  for (State p = 0; p < states_; ++p) {
    for (State q = 0; q < states_; ++q) simulates[p][q] = !final_[p] || final_[q];
  }
  for (bool changed = true; changed;) {
    changed = false;
    for (State p = 0; p < states_; ++p) {
      for (State q = 0; q < states_; ++q) {
        if (!simulates[p][q] || p == q) continue;
        const bool holds = std::ranges::all_of(from[p], [&](const Move& move) {
          return std::ranges::any_of(from[q], [&](const Move& other) {
            return simulates[move.to][other.to] && includes(move.label, other.label);
          });
        });
        if (!holds) simulates[p][q] = false;
        changed = changed || !holds;
      }
    }
  }
  // States that simulate each other are one; then a move is superfluous beside a greater one.
  std::vector<State> one(states_);
  for (State state = 0; state < states_; ++state) {
    one[state] = state;
    for (State other = 0; other < state; ++other) {
      if (simulates[state][other] && simulates[other][state]) {
        one[state] = other;
        break;
      }
    }
  }
  for (Move& move : moves_) move = {one[move.from], move.label, one[move.to]};
  sort_unique(moves_);
  std::vector<Move> kept;
  for (std::size_t at = 0; at < moves_.size(); ++at) {
    const Move& move = moves_[at];
    const auto is_greater = [&](const Move& other) {
      return other.from == move.from && other != move && includes(move.label, other.label) &&
             simulates[move.to][other.to];
    };
    const bool is_superfluous =
        std::ranges::any_of(kept, is_greater) ||
        std::any_of(moves_.begin() + static_cast<std::ptrdiff_t>(at) + 1, moves_.end(), is_greater);
    if (!is_superfluous) kept.push_back(move);
  }
  moves_ = std::move(kept);
}

void Automaton::trim() {
  std::vector<bool> is_reached(states_, false);
  std::vector<bool> reaches_end = final_;
  is_reached[begin] = true;
  for (bool changed = true; changed;) {
    changed = false;
    for (const Move& move : moves_) {
      if (is_reached[move.from] && !is_reached[move.to]) changed = is_reached[move.to] = true;
      if (reaches_end[move.to] && !reaches_end[move.from]) changed = reaches_end[move.from] = true;
    }
  }
  std::vector<State> renumbered(states_, 0);
  std::vector<bool> kept_final;
  State next = 0;
  for (State state = 0; state < states_; ++state) {
    if (state != begin && !(is_reached[state] && reaches_end[state])) continue;
    renumbered[state] = next++;
    kept_final.push_back(final_[state]);
  }
  std::erase_if(moves_, [&](const Move& move) {
    return !is_reached[move.from] || !is_reached[move.to] || !reaches_end[move.to] || !reaches_end[move.from];
  });
  for (Move& move : moves_) move = {renumbered[move.from], move.label, renumbered[move.to]};
  std::ranges::sort(moves_);
  final_ = std::move(kept_final);
  states_ = next;
}

}  // namespace geminga::clauses
