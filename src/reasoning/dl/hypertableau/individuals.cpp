// The facts of the graph, read for the individuals.
#include "reasoning/dl/hypertableau/individuals.hpp"

#include <algorithm>

namespace geminga::hypertableau {

using clauses::number;

NodeId Individuals::certain(NodeId node) const {
  while (graph_.node(node).state == NodeState::merged && graph_.node(node).merged_by == no_dependency)
    node = graph_.node(node).merged_into;
  return node;
}

NodeId Individuals::current(NodeId node) const {
  while (graph_.node(node).state == NodeState::merged) node = graph_.node(node).merged_into;
  return node;
}

NodeId Individuals::certain_node(clauses::IndividualId individual) const { return certain(nodes_[number(individual)]); }

NodeId Individuals::node(clauses::IndividualId individual) const { return current(nodes_[number(individual)]); }

std::vector<clauses::ConceptId> Individuals::label(NodeId node, bool is_certain) const {
  std::vector<clauses::ConceptId> found;
  for (FactId id = graph_.node(node).labels; id != none; id = graph_.fact(id).next_a) {
    const Fact& fact = graph_.fact(id);
    const bool counts = !is_certain || fact.dependency == no_dependency;
    if (counts && fact.predicate < set_.concepts.size()) found.push_back(clauses::ConceptId{fact.predicate});
  }
  return found;
}

// The facts of a node that was merged without a choice stand with the node that it was merged into, too.
std::vector<Individuals::Link> Individuals::certain_links() const {
  std::vector<Link> found;
  for (const Fact& fact : graph_.facts()) {
    if (fact.kind != FactKind::role || fact.dependency != no_dependency) continue;
    if (certain(fact.a) == fact.a && certain(fact.b) == fact.b)
      found.push_back({clauses::PropertyId{fact.predicate}, fact.a, fact.b});
  }
  return found;
}

std::vector<Individuals::Link> Individuals::links() const {
  std::vector<Link> found;
  for (const Fact& fact : graph_.facts()) {
    if (fact.kind == FactKind::role && graph_.is_active(fact.a) && graph_.is_active(fact.b))
      found.push_back({clauses::PropertyId{fact.predicate}, fact.a, fact.b});
  }
  return found;
}

bool Individuals::has_uncertain_links() const {
  return std::ranges::any_of(graph_.facts(), [&](const Fact& fact) {
    return fact.kind == FactKind::role && fact.dependency != no_dependency && graph_.is_active(fact.a) &&
           graph_.is_active(fact.b);
  });
}

std::vector<Individuals::Value> Individuals::values(bool are_certain) const {
  std::vector<Value> found;
  for (const Fact& fact : graph_.facts()) {
    if (fact.kind != FactKind::data_role) continue;
    const NodeId value = are_certain ? certain(fact.b) : current(fact.b);
    const bool counts =
        are_certain ? fact.dependency == no_dependency && certain(fact.a) == fact.a : graph_.is_active(fact.a);
    if (counts) found.push_back({clauses::DataPropertyId{fact.predicate}, fact.a, value});
  }
  return found;
}

bool Individuals::has_blocked_nodes() const {
  for (NodeId node = 0; node < graph_.node_count(); ++node) {
    if (graph_.node(node).kind == NodeKind::tree && graph_.is_active(node) && graph_.node(node).is_blocked) return true;
  }
  return false;
}

}  // namespace geminga::hypertableau
