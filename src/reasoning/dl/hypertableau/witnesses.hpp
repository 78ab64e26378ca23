// Witnesses: nodes that are there and satisfy an at-least, so that none is made for it.
//
//   >= 1 R.C(x) is satisfied by a neighbour in C, or of which the parts of C hold (program/parts.hpp). If R is not
//   simple, a path of edges between individuals whose word implies R is as good as an edge.
//
// That a cousin has an ancestor with a sibling is mostly derived from such nodes. What is not in the labels of x and a
// neighbour, but around that neighbour, is looked for if x is an individual, and only at individuals. These are there
// once, whatever is blocked, so each model that the graph stands for has what is around them. A blocked node lives on
// what is around its blocker, and blocking compares only the labels of the two and of their parents. Around a neighbour
// only individuals count: if two individuals are merged, labels and edges between individuals stay, but the nodes below
// one of them go, and those that are made anew may choose otherwise.
#ifndef GEMINGA_REASONING_DL_HYPERTABLEAU_WITNESSES_HPP
#define GEMINGA_REASONING_DL_HYPERTABLEAU_WITNESSES_HPP

#include <cstdint>
#include <vector>

#include "reasoning/dl/clauses/clause.hpp"
#include "reasoning/dl/hypertableau/facts/assertions.hpp"
#include "reasoning/dl/hypertableau/facts/effort.hpp"
#include "reasoning/dl/hypertableau/facts/neighbours.hpp"
#include "reasoning/dl/hypertableau/graph/graph.hpp"
#include "reasoning/dl/hypertableau/program/program.hpp"

namespace geminga::hypertableau {

/// Looks for witnesses among the facts. It changes nothing. What it finds holds as long as the facts are there.
class Witnesses {
 public:
  Witnesses(const clauses::ClauseSet& set, const Program& program, const Graph& graph, Effort& effort,
            Assertions& facts, Neighbours& neighbours);

  /// Whether as many nodes, or values, as the at-least asks for satisfy it.
  [[nodiscard]] bool satisfy(const Fact& at_least);

 private:
  [[nodiscard]] bool satisfy_several(const Fact& at_least);
  [[nodiscard]] bool satisfy_data(const Fact& at_least);
  [[nodiscard]] bool differs_from_all(NodeId node, const std::vector<NodeId>& others);
  /// Whether some node satisfies the at-least, which asks for one neighbour, of this node.
  [[nodiscard]] bool satisfy(std::uint32_t at_least, NodeId node, std::uint32_t depth);
  [[nodiscard]] bool has_path(const clauses::AtLeast& one, NodeId node, std::uint32_t depth);
  /// `looks_around`: what is around the node counts, if it is an individual.
  [[nodiscard]] bool is_in(std::uint32_t filler, NodeId node, bool looks_around, std::uint32_t depth);

  const clauses::ClauseSet& set_;
  const Program& program_;
  const Graph& graph_;
  Effort& effort_;
  Assertions& facts_;
  Neighbours& neighbours_;
  std::vector<bool> is_composite_;  ///< by at-least: its property is not simple
};

}  // namespace geminga::hypertableau

#endif
