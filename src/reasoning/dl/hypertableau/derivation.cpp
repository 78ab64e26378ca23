// The treatment of a fact of each kind.
#include "reasoning/dl/hypertableau/derivation.hpp"

namespace geminga::hypertableau {

using clauses::number;

void Derivation::process(FactId id) {
  const Fact fact = graph_.fact(id);
  if (!graph_.is_active(fact.a)) return;
  switch (fact.kind) {
    case FactKind::concept_of:
      process_concept(fact, id);
      return;
    case FactKind::role:
    case FactKind::data_role:
      process_role(fact, id);
      return;
    case FactKind::at_least:
    case FactKind::data_at_least:
      process_at_least(fact, id);
      return;
    case FactKind::at_most:
      if (!bounds_.contradicts({ChoiceKind::at_most, fact.predicate, fact.a, fact.a}, fact.dependency))
        bounds_.note({fact.a, fact.predicate});
      return;
    default:
      return;
  }
}

void Derivation::process_role(const Fact& fact, FactId id) {
  if (!graph_.is_active(fact.b)) return;
  const bool is_data = fact.kind == FactKind::data_role;
  if (!matches_.add_heads(is_data ? program_.of_data_role(fact.predicate) : program_.of_role(fact.predicate), id))
    return;
  bounds_.note_role(fact.predicate, fact.a, fact.b, is_data);
  if (is_data) {
    keep_apart(fact);
  } else if (fact.a == fact.b) {
    bounds_.note_loop(fact.predicate, fact.a);
  }
}

void Derivation::process_at_least(const Fact& fact, FactId id) {
  const bool is_data = fact.kind == FactKind::data_at_least;
  const ChoiceKind kind = is_data ? ChoiceKind::data_at_least : ChoiceKind::at_least;
  if (bounds_.contradicts({kind, fact.predicate, fact.a, fact.a}, fact.dependency)) return;
  expansion_.add(fact, id);
  for (const std::uint32_t of :
       is_data ? program_.domains().of_data_at_least(fact.predicate) : program_.domains().of_at_least(fact.predicate)) {
    facts_.add_fact(FactKind::concept_of, of, fact.a, 0, fact.dependency);
  }
}

/// U(x,v), V(x,w) -> v != w  where U and V are disjoint
void Derivation::keep_apart(const Fact& fact) {
  for (const std::uint32_t other : program_.disjoint_with(fact.predicate)) {
    for (FactId id = graph_.node(fact.a).out; id != none && !facts_.has_clash(); id = graph_.fact(id).next_a) {
      const Fact edge = graph_.fact(id);
      if (edge.kind != FactKind::data_role || edge.predicate != other || !graph_.is_active(edge.b)) continue;
      facts_.add_unequal(fact.b, edge.b, graph_.unite(fact.dependency, edge.dependency));
    }
  }
}

void Derivation::process_concept(const Fact& fact, FactId id) {
  if (const auto individual = program_.nominal(fact.predicate)) {
    // {a}(x) -> x = a
    DependencySet dependency = fact.dependency;
    const NodeId node = graph_.current(facts_.individuals()[number(*individual)], dependency);
    if (node != fact.a) facts_.add_merge(fact.a, node, dependency);
  }
  // The mark and the concept that it excludes. Facts that came later wait for their own turn.
  if (const FactId opposite = facts_.find_opposite(fact); opposite < id) {
    facts_.clash(graph_.unite(fact.dependency, graph_.fact(opposite).dependency));
    return;
  }
  if (!matches_.add_heads(program_.of_concept(fact.predicate), id)) return;
  bounds_.note_concept(fact.predicate, fact.a);
}

}  // namespace geminga::hypertableau
