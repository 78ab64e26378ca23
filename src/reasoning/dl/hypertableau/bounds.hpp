// Number restrictions: when there are too many neighbours, and the NI rule.
//
//   <=-rule:  <= n R.B(x), R(x,y1), B(y1), ..., R(x,yn+1), B(yn+1): two of the y are equal.
//   NI-rule:  <= n R.B(x), R(x,y), B(y), x a root, y in the tree of another node: y is one of n roots of x, R and B.
//             Otherwise blocked trees, unfolded without end, would give x more neighbours than it may have.
// After Motik, Shearer, Horrocks 2009, sections 3.2.3 and 4.2.
#ifndef GEMINGA_REASONING_DL_HYPERTABLEAU_BOUNDS_HPP
#define GEMINGA_REASONING_DL_HYPERTABLEAU_BOUNDS_HPP

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "reasoning/dl/hypertableau/disjunctions.hpp"
#include "reasoning/dl/hypertableau/facts/assertions.hpp"
#include "reasoning/dl/hypertableau/facts/choice.hpp"
#include "reasoning/dl/hypertableau/facts/effort.hpp"
#include "reasoning/dl/hypertableau/facts/neighbours.hpp"
#include "reasoning/dl/hypertableau/facts/numbers.hpp"
#include "reasoning/dl/hypertableau/graph/dependency.hpp"
#include "reasoning/dl/hypertableau/graph/graph.hpp"
#include "reasoning/dl/hypertableau/program/program.hpp"

namespace geminga::hypertableau {

/// Checks bounds that may be exceeded, and keeps those that only a choice can enforce.
class Bounds {
 public:
  Bounds(const Program& program, const Graph& graph, Effort& effort, Assertions& facts, Neighbours& neighbours,
         const Numbers& numbers, Disjunctions& disjunctions)
      : program_(program),
        graph_(graph),
        effort_(effort),
        facts_(facts),
        neighbours_(neighbours),
        numbers_(numbers),
        disjunctions_(disjunctions) {}

  /// Clashes if another number restriction of the node excludes this one, and returns whether one does.
  bool contradicts(const Choice& restriction, DependencySet dependency);

  // Notes the bounds that a new fact may exceed. check_last() looks at them.
  void note(const Suspect& suspect) { suspects_.push_back(suspect); }
  void note_role(std::uint32_t property, NodeId from, NodeId to, bool is_data);
  void note_loop(std::uint32_t property, NodeId node);
  /// Clashes if at-leasts of the node exceed a bound that the concept brings.
  void note_concept(std::uint32_t id, NodeId node);

  [[nodiscard]] bool has_suspects() const { return !suspects_.empty(); }
  /// Looks at the last suspect, and asserts what follows without a choice.
  void check_last();

  /// A bound that demands a choice, and the dependencies of the node that has it.
  struct Demand {
    Suspect suspect;
    DependencySet dependency = no_dependency;
  };
  /// The next one whose node is still there.
  [[nodiscard]] std::optional<Demand> next_demand();
  /// The choice that the bound demands. A single alternative is asserted at once.
  [[nodiscard]] std::optional<Decision> enforce(const Demand& demand);

  /// Of the demands. No suspect must be left.
  struct Sizes {
    std::size_t demands = 0;
    std::size_t next = 0;
  };
  [[nodiscard]] Sizes sizes() const { return {demands_.size(), next_demand_}; }
  void restore(const Sizes& sizes);

 private:
  void check_conditional(const Suspect& suspect);
  bool introduce(const Suspect& suspect, std::span<const Neighbour> neighbours, DependencySet dependency);
  [[nodiscard]] bool is_foreign(NodeId neighbour, NodeId of) const;
  void add_unless(const Bound& bound, NodeId node, std::vector<Choice>& alternatives);
  void add_introductions(const Suspect& suspect, NodeId foreign, std::vector<Choice>& alternatives);
  /// False: the question is over a limit, and not all pairs were looked at.
  bool add_equalities(const Bound& bound, std::span<const Neighbour> neighbours, std::vector<Choice>& alternatives,
                      DependencySet& reasons);
  [[nodiscard]] DependencySet unite(DependencySet first, DependencySet second) { return graph_.unite(first, second); }

  const Program& program_;
  const Graph& graph_;
  Effort& effort_;
  Assertions& facts_;
  Neighbours& neighbours_;
  const Numbers& numbers_;
  Disjunctions& disjunctions_;
  std::vector<Suspect> suspects_;
  std::vector<Suspect> demands_;
  std::size_t next_demand_ = 0;
};

}  // namespace geminga::hypertableau

#endif
