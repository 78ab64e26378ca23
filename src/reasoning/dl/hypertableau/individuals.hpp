// The part of a model that is about the individuals of a clause set: their types, who is the same, and their facts.
#ifndef GEMINGA_REASONING_DL_HYPERTABLEAU_INDIVIDUALS_HPP
#define GEMINGA_REASONING_DL_HYPERTABLEAU_INDIVIDUALS_HPP

#include <span>
#include <utility>
#include <vector>

#include "reasoning/dl/clauses/clause.hpp"
#include "reasoning/dl/hypertableau/graph/graph.hpp"

namespace geminga::hypertableau {

/// Statements that are supposed beside the facts.
struct Supposition {
  std::vector<clauses::ConceptFact> facts;
  std::vector<std::pair<clauses::IndividualId, clauses::IndividualId>> different;
};

/// Reads the model in the graph; valid until the search goes on.
///
/// Certain facts were derived without a choice, and so hold in every model. What does not hold in the model does not
/// follow. Individuals that are certainly one have the same certain node, and those that are one in this model have the
/// same node. Certain facts are those of certain nodes.
class Individuals {
 public:
  Individuals(const clauses::ClauseSet& set, const Graph& graph, std::span<const NodeId> nodes)
      : set_(set), graph_(graph), nodes_(nodes) {}

  [[nodiscard]] NodeId certain_node(clauses::IndividualId individual) const;
  [[nodiscard]] NodeId node(clauses::IndividualId individual) const;
  /// The concepts of a certain node that hold in every model, in no order.
  [[nodiscard]] std::vector<clauses::ConceptId> certain_label(NodeId certain) const { return label(certain, true); }
  /// All concepts of a node in this model, in no order.
  [[nodiscard]] std::vector<clauses::ConceptId> label(NodeId node) const { return label(node, false); }
  [[nodiscard]] bool is_in(NodeId node, clauses::ConceptId of) const {
    return graph_.find(FactKind::concept_of, clauses::number(of), node) != none;
  }
  [[nodiscard]] bool has_link(clauses::PropertyId property, NodeId first, NodeId second) const {
    return graph_.find(FactKind::role, clauses::number(property), first, second) != none;
  }

  struct Link {
    clauses::PropertyId property{};
    NodeId first = 0;
    NodeId second = 0;
  };
  /// The facts between any two nodes that hold in every model.
  [[nodiscard]] std::vector<Link> certain_links() const;
  /// The facts between any two nodes of this model.
  [[nodiscard]] std::vector<Link> links() const;

  /// Whether a fact between nodes depends on a choice.
  [[nodiscard]] bool has_uncertain_links() const;

  struct Value {
    clauses::DataPropertyId property{};
    NodeId subject = 0;
    NodeId value = 0;
  };
  /// The facts about values that hold in every model, or all of this model.
  [[nodiscard]] std::vector<Value> values(bool are_certain) const;

  /// The node whose at-least made this one; none: it is an individual.
  [[nodiscard]] NodeId parent_of(NodeId node) const { return graph_.node(node).parent; }
  /// Whether the model has a node that is no individual and has no successors of its own because another one like it
  /// has them.
  [[nodiscard]] bool has_blocked_nodes() const;

 private:
  [[nodiscard]] std::vector<clauses::ConceptId> label(NodeId node, bool is_certain) const;
  [[nodiscard]] NodeId certain(NodeId node) const;
  [[nodiscard]] NodeId current(NodeId node) const;

  const clauses::ClauseSet& set_;
  const Graph& graph_;
  std::span<const NodeId> nodes_;
};

}  // namespace geminga::hypertableau

#endif
