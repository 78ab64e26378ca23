// The neighbours of a node that a bound counts.
#ifndef GEMINGA_REASONING_DL_HYPERTABLEAU_FACTS_NEIGHBOURS_HPP
#define GEMINGA_REASONING_DL_HYPERTABLEAU_FACTS_NEIGHBOURS_HPP

#include <optional>
#include <span>
#include <vector>

#include "reasoning/dl/hypertableau/facts/assertions.hpp"
#include "reasoning/dl/hypertableau/facts/choice.hpp"
#include "reasoning/dl/hypertableau/facts/effort.hpp"
#include "reasoning/dl/hypertableau/graph/dependency.hpp"
#include "reasoning/dl/hypertableau/graph/graph.hpp"
#include "reasoning/dl/hypertableau/program/program.hpp"

namespace geminga::hypertableau {

struct Neighbour {
  NodeId node = 0;
  DependencySet dependency = no_dependency;  ///< why it is one
};

/// Compares bounds with the neighbours in the graph. It changes nothing.
class Neighbours {
 public:
  Neighbours(const Program& program, const Graph& graph, Effort& effort, Assertions& facts)
      : program_(program), graph_(graph), effort_(effort), facts_(facts) {}

  /// Whether the bound holds of the node; sets `dependency` to why.
  [[nodiscard]] bool is_bound(const Suspect& suspect, DependencySet& dependency) const;
  /// The neighbours that the bound counts, ascending.
  [[nodiscard]] std::vector<Neighbour> counted(const Suspect& suspect);
  /// Whether more of them than the bound allows are known to differ from each other. If so, unites the reasons into
  /// `dependency`. One set is tried: each neighbour that differs from all taken ones is taken.
  [[nodiscard]] bool exceeds(const Bound& bound, std::span<const Neighbour> neighbours, DependencySet& dependency);

  /// A fact that puts the node into a concept that excludes this one; none if there is none.
  [[nodiscard]] FactId find_excluder(std::uint32_t id, NodeId node) const;
  /// Why the node is one that an at-least with this filler asks for; nothing if it is not known to be.
  [[nodiscard]] std::optional<DependencySet> membership(std::uint32_t filler, NodeId node) const;
  /// Why the nodes differ, if they are known to, or are in concepts that exclude each other.
  [[nodiscard]] std::optional<DependencySet> difference(NodeId a, NodeId b);

  /// Whether the denial (program/denials.hpp) cannot hold of the node, because something forbidden does.
  [[nodiscard]] bool is_denied(std::uint32_t denial, NodeId node) const;

  /// Whether the node may have at most one neighbour by the role.
  [[nodiscard]] bool is_functional(clauses::Role role, NodeId node) const;
  /// The neighbour in the graph, if the node may have one by the role at most.
  [[nodiscard]] std::optional<Neighbour> only(clauses::Role role, NodeId node);
  /// Whether the choice brings a bound that counts more neighbours than it allows, so that some must be equal.
  [[nodiscard]] bool crowds(const Choice& choice);
  /// Whether the node of the choice has a neighbour, or asks for one, in a direction in which the choice speaks of
  /// neighbours (program/directions.hpp). It looks at a few facts of the node only.
  [[nodiscard]] bool meets(const Choice& choice) const;

 private:
  [[nodiscard]] bool has_concepts(std::span<const std::uint32_t> concepts, NodeId node) const;
  [[nodiscard]] bool is_forbidden(const Forbidden& all, NodeId node) const;
  [[nodiscard]] bool counts(const Bound& bound, NodeId node, DependencySet& dependency);
  /// Whether the bound says no more than that the role is functional.
  [[nodiscard]] static bool is_of_functional(const Bound& bound, clauses::Role role) {
    const bool is_plain = bound.filler == no_predicate && bound.unless == no_predicate && bound.count == 1;
    return is_plain && bound.is_inverse == role.is_inverse;
  }
  [[nodiscard]] DependencySet unite(DependencySet first, DependencySet second) { return graph_.unite(first, second); }

  const Program& program_;
  const Graph& graph_;
  Effort& effort_;
  Assertions& facts_;
};

}  // namespace geminga::hypertableau

#endif
