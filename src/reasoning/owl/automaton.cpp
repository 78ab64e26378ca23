// Closes over empty moves and reduces by simulation.
#include "reasoning/owl/automaton.hpp"

#include <algorithm>

#include "base/sorted.hpp"

namespace geminga::owl {
namespace {

/// Automata with more states are not searched for superfluous moves: the search grows with the cube of the states.
constexpr std::size_t max_simulated_states = 300;

}  // namespace

/// Which labels of moves include which. Each pair is asked about once.
class Automaton::Inclusions {
 public:
  Inclusions(const std::vector<Move>& moves, const Includes& includes) : asked_(includes) {
    for (const Move& move : moves) labels_.push_back(move.label);
    base::sort_unique(labels_);
    for (const Move& move : moves) {
      const auto place = std::ranges::lower_bound(labels_, move.label);
      label_of_.push_back(static_cast<std::size_t>(place - labels_.begin()));
    }
    known_.assign(labels_.size() * labels_.size(), unknown);
  }
  /// Of moves, by their positions.
  [[nodiscard]] bool includes(std::size_t first, std::size_t second) const {
    std::uint8_t& known = known_[label_of_[first] * labels_.size() + label_of_[second]];
    if (known == unknown) known = asked_(labels_[label_of_[first]], labels_[label_of_[second]]) ? 1 : 0;
    return known == 1;
  }

 private:
  static constexpr std::uint8_t unknown = 2;
  const Includes& asked_;
  std::vector<Role> labels_;
  std::vector<std::size_t> label_of_;
  mutable std::vector<std::uint8_t> known_;
};

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
  // A state that is reached from the first state without a letter is a first state, too.
  std::vector<bool> begins(states_, false);
  for (const State state : closures[begin]) begins[state] = true;
  for (const Move& move : moves_) {
    for (const State to : closures[move.to]) {
      result.moves_.push_back({move.from, move.label, to});
      if (begins[move.from]) result.moves_.push_back({begin, move.label, to});
    }
  }
  base::sort_unique(result.moves_);
  result.trim();
  if (result.states_ <= max_simulated_states) result.drop_superfluous(includes);
  result.trim();
  return result;
}

void Automaton::drop_superfluous(const Includes& includes) {
  // State q simulates state p if two things hold: q is final where p is, and each move of p has a move of q whose label
  // includes that of the first and whose target simulates its target. The greatest such relation is found by
  // refinement.
  const Inclusions labels(moves_, includes);
  std::vector<std::uint8_t> simulates(states_ * std::size_t{states_});  // [p, q]: q simulates p
  const auto at = [&](State p, State q) -> std::uint8_t& { return simulates[p * std::size_t{states_} + q]; };
  for (State p = 0; p < states_; ++p) {
    for (State q = 0; q < states_; ++q) at(p, q) = !final_[p] || final_[q] ? 1 : 0;
  }
  // Of each state, the first of its moves, which are sorted.
  std::vector<std::size_t> first(states_ + std::size_t{1}, 0);
  for (const Move& move : moves_) ++first[move.from + 1];
  for (State state = 0; state < states_; ++state) first[state + 1] += first[state];
  const auto follows = [&](std::size_t move, State q) {
    for (std::size_t other = first[q]; other < first[q + 1]; ++other) {
      if (at(moves_[move].to, moves_[other].to) != 0 && labels.includes(move, other)) return true;
    }
    return false;
  };
  for (bool changed = true; changed;) {
    changed = false;
    for (State p = 0; p < states_; ++p) {
      for (State q = 0; q < states_; ++q) {
        if (at(p, q) == 0 || p == q) continue;
        std::size_t move = first[p];
        while (move < first[p + 1] && follows(move, q)) ++move;
        if (move == first[p + 1]) continue;
        at(p, q) = 0;
        changed = true;
      }
    }
  }
  // States that simulate each other become one. A move is superfluous if another one is greater.
  std::vector<State> one(states_);
  for (State state = 0; state < states_; ++state) {
    one[state] = state;
    for (State other = 0; other < state; ++other) {
      if (at(state, other) != 0 && at(other, state) != 0) {
        one[state] = other;
        break;
      }
    }
  }
  for (Move& move : moves_) move = {one[move.from], move.label, one[move.to]};
  base::sort_unique(moves_);
  drop_smaller(Inclusions(moves_, includes), [&](State p, State q) { return at(p, q) != 0; });
}

void Automaton::drop_smaller(const Inclusions& labels, const auto& is_simulated) {
  std::vector<std::size_t> kept;
  for (std::size_t at = 0; at < moves_.size(); ++at) {
    const auto is_smaller = [&](std::size_t other) {
      return other != at && moves_[other].from == moves_[at].from && is_simulated(moves_[at].to, moves_[other].to) &&
             labels.includes(at, other);
    };
    bool is_superfluous = std::ranges::any_of(kept, is_smaller);
    for (std::size_t other = at + 1; other < moves_.size() && !is_superfluous; ++other) {
      if (moves_[other].from != moves_[at].from) break;
      is_superfluous = is_smaller(other);
    }
    if (!is_superfluous) kept.push_back(at);
  }
  std::vector<Move> moves;
  for (const std::size_t at : kept) moves.push_back(moves_[at]);
  moves_ = std::move(moves);
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

}  // namespace geminga::owl
