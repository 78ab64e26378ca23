// Neighbours and values that are made because an at-least asks for them.
#ifndef GEMINGA_REASONING_DL_HYPERTABLEAU_NEW_NEIGHBOURS_HPP
#define GEMINGA_REASONING_DL_HYPERTABLEAU_NEW_NEIGHBOURS_HPP

#include <span>

#include "reasoning/dl/hypertableau/facts/assertions.hpp"
#include "reasoning/dl/hypertableau/facts/effort.hpp"
#include "reasoning/dl/hypertableau/facts/neighbours.hpp"
#include "reasoning/dl/hypertableau/graph/dependency.hpp"
#include "reasoning/dl/hypertableau/graph/graph.hpp"
#include "reasoning/dl/hypertableau/program/program.hpp"
#include "reasoning/dl/hypertableau/sharing.hpp"

namespace geminga::hypertableau {

/// Makes what an at-least asks for and what is not there. It keeps nothing.
class NewNeighbours {
 public:
  NewNeighbours(const Program& program, const Graph& graph, Effort& effort, Assertions& facts, Neighbours& neighbours,
                Sharing& sharing)
      : program_(program), graph_(graph), effort_(effort), facts_(facts), neighbours_(neighbours), sharing_(sharing) {}

  /// Makes the neighbours or values that are missing, or the edge to the individual that the filler is the nominal of.
  void make(const Fact& at_least);
  /// Gives the filler to the neighbour in the graph if there may be one at most. False: there is none, or may be more.
  bool give_to_neighbour(const Fact& at_least);
  /// Makes a neighbour without the filler.
  NodeId make_plain(const Fact& at_least);
  /// Whether the node may have one neighbour by the role at most.
  [[nodiscard]] bool is_functional(const Fact& at_least) const;

  /// Whether share() may save neighbours (Sharing::is_promising()).
  [[nodiscard]] bool may_share(const Fact& at_least) { return sharing_.is_promising(at_least); }
  /// Guesses that neighbours are among those that the at-least asks for, and makes those that are missing to them.
  void share(const Fact& at_least, DependencySet dependency);

 private:
  void make_objects(const Fact& at_least);
  void make_values(const Fact& at_least);
  /// Makes the neighbours that are missing to the known ones, which differ.
  void make_missing(const Fact& at_least, std::span<const NodeId> known, DependencySet dependency);
  void add_edge(const Fact& at_least, NodeId node, DependencySet dependency);

  const Program& program_;
  const Graph& graph_;
  Effort& effort_;
  Assertions& facts_;
  Neighbours& neighbours_;
  Sharing& sharing_;
};

}  // namespace geminga::hypertableau

#endif
