// How keys are looked for. The rule is in keys.hpp.
#include "reasoning/dl/hypertableau/keys.hpp"

#include <algorithm>

#include "reasoning/owl/source.hpp"

namespace geminga::hypertableau {

using clauses::number;

void Keys::check() {
  const std::span<const NodeId> individuals = facts_.individuals();
  if (individuals.empty() || set_.keys.empty()) return;
  is_named_.assign(graph_.node_count(), false);
  for (std::size_t at = 0; at < individuals.size(); ++at) {
    const owl::TermId term = set_.individuals[at];
    if (term == clauses::no_term || source_.kind(term) != owl::TermKind::individual) continue;
    DependencySet ignored = no_dependency;
    is_named_[graph_.current(individuals[at], ignored)] = true;
  }
  for (const clauses::Key& key : set_.keys) {
    std::vector<NodeId> members;
    for (NodeId node = 0; node < is_named_.size(); ++node) {
      if (!is_named_[node] || !graph_.is_active(node)) continue;
      const bool is_in = key.of == clauses::thing || graph_.find(FactKind::concept_of, number(key.of), node) != none;
      if (is_in) members.push_back(node);
    }
    for (std::size_t first = 0; first < members.size(); ++first) {
      for (std::size_t second = first + 1; second < members.size(); ++second) {
        DependencySet dependency = no_dependency;
        if (!agree(key, members[first], members[second], dependency)) continue;
        facts_.add_merge(members[first], members[second], dependency);
        return;
      }
    }
  }
}

bool Keys::agree(const clauses::Key& key, NodeId first, NodeId second, DependencySet& dependency) {
  const auto add = [&](FactId id) {
    if (id != none) dependency = graph_.unite(dependency, graph_.fact(id).dependency);
    return id != none;
  };
  if (key.of != clauses::thing) {
    add(graph_.find(FactKind::concept_of, number(key.of), first));
    add(graph_.find(FactKind::concept_of, number(key.of), second));
  }
  const auto shares = [&](FactKind kind, std::uint32_t property, bool is_inverse) {
    for (FactId id = is_inverse ? graph_.node(first).in : graph_.node(first).out; id != none;
         id = is_inverse ? graph_.fact(id).next_b : graph_.fact(id).next_a) {
      const Fact& fact = graph_.fact(id);
      const NodeId other = is_inverse ? fact.a : fact.b;
      if (fact.kind != kind || fact.predicate != property || !graph_.is_active(other)) continue;
      if (kind == FactKind::role && !is_named_[other]) continue;
      const FactId same =
          is_inverse ? graph_.find(kind, property, other, second) : graph_.find(kind, property, second, other);
      if (same == none) continue;
      add(id);
      add(same);
      return true;
    }
    return false;
  };
  return std::ranges::all_of(key.roles,
                             [&](const clauses::Role& role) {
                               return shares(FactKind::role, number(role.property), role.is_inverse);
                             }) &&
         std::ranges::all_of(key.data_properties, [&](clauses::DataPropertyId id) {
           return shares(FactKind::data_role, number(id), false);
         });
}

}  // namespace geminga::hypertableau
