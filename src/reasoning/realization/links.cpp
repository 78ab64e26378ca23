#include "reasoning/realization/links.hpp"

#include <algorithm>
#include <set>
#include <tuple>

namespace geminga::realization {
namespace {

using clauses::number;
using clauses::PropertyId;
using hypertableau::Individuals;
using hypertableau::NodeId;
using owl::Automaton;
using owl::Role;

/// The links of each node in both directions, sorted.
class Neighbourhood {
 public:
  explicit Neighbourhood(const std::vector<Individuals::Link>& links) {
    for (const Individuals::Link& link : links) {
      edges_.emplace_back(link.first, Role{link.property, false}, link.second);
      edges_.emplace_back(link.second, Role{link.property, true}, link.first);
    }
    std::ranges::sort(edges_);
  }

  void for_each(NodeId from, Role along, const std::function<void(NodeId)>& use) const {
    for (auto edge = std::ranges::lower_bound(edges_, Edge{from, along, 0});
         edge != edges_.end() && std::get<0>(*edge) == from && std::get<1>(*edge) == along; ++edge)
      use(std::get<2>(*edge));
  }
  /// Each node that has a link, once, ascending.
  [[nodiscard]] std::vector<NodeId> nodes() const {
    std::vector<NodeId> found;
    for (const Edge& edge : edges_) {
      if (found.empty() || found.back() != std::get<0>(edge)) found.push_back(std::get<0>(edge));
    }
    return found;
  }

 private:
  using Edge = std::tuple<NodeId, Role, NodeId>;
  std::vector<Edge> edges_;
};

/// Whether a path can come back from a thing without a name that is made for another one. Without nominals there is no
/// other way from it to an individual.
bool leads_back(const Automaton& automaton, const std::vector<Individuals::Link>& links,
                const Individuals& individuals) {
  return std::ranges::any_of(automaton.moves(), [&](const Automaton::Move& move) {
    return std::ranges::any_of(links, [&](const Individuals::Link& link) {
      if (link.property != move.label.property) return false;
      const NodeId from = move.label.is_inverse ? link.second : link.first;
      const NodeId to = move.label.is_inverse ? link.first : link.second;
      return individuals.parent_of(from) == to;
    });
  });
}

bool has_nominals(const clauses::ClauseSet& set) {
  return std::ranges::any_of(set.concepts,
                             [](const clauses::Concept& of) { return of.kind == clauses::ConceptKind::nominal; });
}

}  // namespace

LinkNames::LinkNames(const owl::Ontology& source, const clauses::ClauseSet& set)
    : set_(set), names_(set.properties.size()) {
  for (std::uint32_t at = 0; at < set.properties.size(); ++at) {
    const owl::TermId property = set.properties[at];
    const std::string_view iri = source.name_of(property);
    if (iri == owl::owl_top_object_property || iri == owl::owl_bottom_object_property) continue;
    const Role canonical = set.roles->canonical({PropertyId{at}, false});
    if (set.roles->is_simple(canonical)) {
      names_[number(canonical.property)].push_back({property, canonical.is_inverse});
    } else {
      composite_.emplace_back(property, canonical);
    }
  }
}

void LinkNames::name(const Individuals::Link& link, const UseLink& use) const {
  for (const Name& name : names_[number(link.property)]) {
    use(name.property, name.is_inverse ? link.second : link.first, name.is_inverse ? link.first : link.second);
  }
}

Paths LinkNames::follow(const std::vector<Individuals::Link>& links, const Individuals& individuals,
                        base::Budget* budget, const UseLink& use) const {
  Paths paths;
  if (composite_.empty()) return paths;
  const Neighbourhood neighbourhood(links);
  const bool are_blocked = individuals.has_blocked_nodes();
  const bool reaches_all = are_blocked && has_nominals(set_);
  const std::vector<NodeId> nodes = neighbourhood.nodes();
  base::BudgetUse steps(budget);
  for (const auto& [property, role] : composite_) {
    const Automaton& automaton = set_.roles->automaton(role);
    if (reaches_all || (are_blocked && leads_back(automaton, links, individuals))) paths.are_open = true;
    std::vector<std::vector<Automaton::Move>> moves(automaton.state_count());
    for (const Automaton::Move& move : automaton.moves()) moves[move.from].push_back(move);
    for (const NodeId begin : nodes) {
      std::set<std::pair<Automaton::State, NodeId>> seen{{Automaton::begin, begin}};
      std::vector<std::pair<Automaton::State, NodeId>> open{{Automaton::begin, begin}};
      while (!open.empty()) {
        const auto [state, node] = open.back();
        open.pop_back();
        if (automaton.is_final(state)) use(property, begin, node);
        for (const Automaton::Move& move : moves[state]) {
          neighbourhood.for_each(node, move.label, [&](NodeId next) {
            if (seen.insert({move.to, next}).second) open.emplace_back(move.to, next);
          });
        }
        if (!steps.spend(1)) {
          paths.is_cut_off = true;
          return paths;
        }
      }
    }
  }
  return paths;
}

}  // namespace geminga::realization
