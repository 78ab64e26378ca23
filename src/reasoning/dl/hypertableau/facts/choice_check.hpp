// Whether the facts decide an alternative of a disjunction.
#ifndef GEMINGA_REASONING_DL_HYPERTABLEAU_FACTS_CHOICE_CHECK_HPP
#define GEMINGA_REASONING_DL_HYPERTABLEAU_FACTS_CHOICE_CHECK_HPP

#include <cstdint>

#include "reasoning/dl/hypertableau/facts/assertions.hpp"
#include "reasoning/dl/hypertableau/facts/choice.hpp"
#include "reasoning/dl/hypertableau/facts/neighbours.hpp"
#include "reasoning/dl/hypertableau/facts/numbers.hpp"
#include "reasoning/dl/hypertableau/graph/dependency.hpp"
#include "reasoning/dl/hypertableau/graph/graph.hpp"
#include "reasoning/dl/hypertableau/program/program.hpp"

namespace geminga::hypertableau {

/// Compares alternatives with the facts: with labels, neighbours and number restrictions. It changes nothing.
class ChoiceCheck {
 public:
  ChoiceCheck(const Program& program, const Graph& graph, Assertions& facts, Neighbours& neighbours,
              const Numbers& numbers)
      : program_(program), graph_(graph), facts_(facts), neighbours_(neighbours), numbers_(numbers) {}

  /// Whether the choice is a fact, or follows from a number restriction of its node.
  [[nodiscard]] bool holds(const Choice& choice) { return facts_.holds(choice) || numbers_.implies(choice); }
  /// Whether the facts exclude the choice. If so, unites the reasons into `dependency`.
  bool is_excluded(const Choice& choice, DependencySet& dependency);

 private:
  // The same of a concept and a node.
  bool is_excluded(std::uint32_t id, NodeId node, DependencySet& dependency);
  bool is_excluded_by_bound(std::uint32_t id, NodeId node, DependencySet& dependency);
  bool is_excluded_by_neighbour(const Choice& choice, DependencySet& dependency);

  const Program& program_;
  const Graph& graph_;
  Assertions& facts_;
  Neighbours& neighbours_;
  const Numbers& numbers_;
};

}  // namespace geminga::hypertableau

#endif
