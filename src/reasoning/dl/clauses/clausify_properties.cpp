// Axioms about object and data properties.
//
// Legend: R S roles, U V data properties, C a class expression, D a data range.
#include <algorithm>

#include "reasoning/dl/clauses/clausifier.hpp"

namespace geminga::clauses {

using owl::AxiomKind;
using owl::TermId;
using owl::TermKind;

namespace {}  // namespace

void Clausifier::collect_roles(const Ordered& axiom, std::vector<owl::RoleInclusion>& inclusions,
                               std::vector<owl::RoleChain>& chains) {
  const auto& arguments = axiom.arguments;
  const auto role = [&](std::size_t at) { return vocabulary_.role(arguments[at]); };
  switch (axiom.kind) {
    case AxiomKind::sub_object_property_of: {
      if (source_.name_of(arguments[1]) == owl::owl_top_object_property) return;
      if (source_.kind(arguments[0]) != TermKind::object_property_chain) {
        inclusions.push_back({role(0), role(1)});
        return;
      }
      owl::RoleChain chain{{}, role(1), axiom.axiom};
      for (const TermId part : source_.term(arguments[0]).arguments) chain.word.push_back(vocabulary_.role(part));
      chains.push_back(std::move(chain));
      return;
    }
    case AxiomKind::equivalent_object_properties:
      for (std::size_t at = 0; at < arguments.size(); ++at) {
        inclusions.push_back({role(at), role((at + 1) % arguments.size())});
      }
      return;
    case AxiomKind::inverse_object_properties:
      inclusions.push_back({role(0), inverse(role(1))});
      inclusions.push_back({inverse(role(1)), role(0)});
      return;
    case AxiomKind::symmetric_object_property:
      inclusions.push_back({inverse(role(0)), role(0)});
      return;
    case AxiomKind::transitive_object_property:
      chains.push_back({{role(0), role(0)}, role(0), axiom.axiom});
      return;
    default:
      return;
  }
}

void Clausifier::build_roles() {
  std::vector<owl::RoleInclusion> inclusions;
  std::vector<owl::RoleChain> chains;
  for (const Ordered& axiom : axioms_) collect_roles(axiom, inclusions, chains);
  if (top_role_) {
    // Everything is connected with one individual, and thus with everything else.
    inclusions.push_back({inverse(*top_role_), *top_role_});
    chains.push_back({{*top_role_, *top_role_}, *top_role_, 0});
  }
  roles_.emplace(set_.properties.size(), inclusions, chains, limits_.automaton_states);
  translator_.emplace(vocabulary_, *roles_, set_, limits_.clauses);
  allowed_.emplace(vocabulary_, *roles_, limits_.cardinality);
  for (const std::uint32_t axiom : roles_->left_out()) set_.unused.push_back({axiom, "an irregular property chain"});
  add_hierarchy(inclusions);
  if (top_role_) {
    const AtLeast connection{1, roles_->canonical(*top_role_), vocabulary_.nominal(vocabulary_.fresh_individual())};
    translator_->add_clause({{}, {{AtomKind::at_least, centre, centre, vocabulary_.index(connection)}}});
  }
  if (bottom_role_) translator_->add_every(*bottom_role_, bottom, bottom);
  if (bottom_data_) translator_->add_clause({{{AtomKind::data_role, centre, 1, number(*bottom_data_)}}, {}});
}

void Clausifier::add_hierarchy(std::span<const owl::RoleInclusion> inclusions) {
  // R(x,y) -> S(x,y)
  const auto add = [&](Role sub, Role super) {
    translator_->add_clause({{translator_->role_atom(sub, centre, 1)}, {translator_->role_atom(super, centre, 1)}});
  };
  for (const auto& [sub, super] : inclusions) {
    if (roles_->canonical(sub) != roles_->canonical(super)) add(sub, super);
  }
  for (std::uint32_t at = 0; at < set_.properties.size(); ++at) {
    const Role role{PropertyId{at}, false};
    if (!roles_->is_symmetric(role) || roles_->canonical(role) != role) continue;
    translator_->add_clause(
        {{{AtomKind::role, centre, 1, number(role.property)}}, {{AtomKind::role, 1, centre, number(role.property)}}});
  }
}

std::string_view Clausifier::problem_of_properties(const Ordered& axiom) {
  const auto all_simple = [&] {
    return std::ranges::all_of(axiom.arguments, [&](TermId property) { return allowed_->is_simple(property); });
  };
  switch (axiom.kind) {
    case AxiomKind::functional_object_property:
      return all_simple() ? "" : "owl:FunctionalProperty of a property that is not simple";
    case AxiomKind::inverse_functional_object_property:
      return all_simple() ? "" : "owl:InverseFunctionalProperty of a property that is not simple";
    case AxiomKind::irreflexive_object_property:
      return all_simple() ? "" : "owl:IrreflexiveProperty of a property that is not simple";
    case AxiomKind::asymmetric_object_property:
      return all_simple() ? "" : "owl:AsymmetricProperty of a property that is not simple";
    case AxiomKind::disjoint_object_properties:
      return all_simple() ? "" : "owl:propertyDisjointWith of a property that is not simple";
    case AxiomKind::object_property_domain:
    case AxiomKind::object_property_range:
      return allowed_->problem(positive(axiom.arguments[1]));
    default:
      return {};
  }
}

void Clausifier::add_property_axiom(const Ordered& axiom) {
  const auto& arguments = axiom.arguments;
  const auto role = [&](std::size_t at) { return vocabulary_.role(arguments[at]); };
  const auto atom = [&](Role of, Variable from, Variable to) { return translator_->role_atom(of, from, to); };
  switch (axiom.kind) {
    case AxiomKind::object_property_domain:
      translator_->add_every(role(0), bottom, positive(arguments[1]));
      return;
    case AxiomKind::object_property_range:
      translator_->add_every(inverse(role(0)), bottom, positive(arguments[1]));
      return;
    case AxiomKind::functional_object_property:
    case AxiomKind::inverse_functional_object_property: {
      // R(x,y1), R(x,y2) -> y1 = y2
      const Role along = axiom.kind == AxiomKind::functional_object_property ? role(0) : inverse(role(0));
      translator_->add_clause({{atom(along, centre, 1), atom(along, centre, 2)}, {{AtomKind::equal, 1, 2, 0}}});
      return;
    }
    case AxiomKind::reflexive_object_property:
      translator_->add_clause({{}, {atom(role(0), centre, centre)}});
      return;
    case AxiomKind::irreflexive_object_property:
      translator_->add_clause({{atom(role(0), centre, centre)}, {}});
      return;
    case AxiomKind::asymmetric_object_property:
      translator_->add_clause({{atom(role(0), centre, 1), atom(role(0), 1, centre)}, {}});
      return;
    case AxiomKind::disjoint_object_properties:
      for (std::size_t first = 0; first < arguments.size(); ++first) {
        for (std::size_t second = first + 1; second < arguments.size() && !translator_->is_full(); ++second) {
          translator_->add_clause({{atom(role(first), centre, 1), atom(role(second), centre, 1)}, {}});
        }
      }
      return;
    default:
      return;
  }
}

void Clausifier::add_data_property_axiom(const Ordered& axiom) {
  const auto& arguments = axiom.arguments;
  const auto atom = [&](std::size_t at, Variable value) {
    return Atom{AtomKind::data_role, centre, value, number(vocabulary_.data_property(arguments[at]))};
  };
  switch (axiom.kind) {
    case AxiomKind::sub_data_property_of:  // U(x,v) -> V(x,v)
      if (!allowed_->is_top_data(arguments[1])) translator_->add_clause({{atom(0, 1)}, {atom(1, 1)}});
      return;
    case AxiomKind::equivalent_data_properties:
      for (std::size_t at = 0; at < arguments.size(); ++at) {
        translator_->add_clause({{atom(at, 1)}, {atom((at + 1) % arguments.size(), 1)}});
      }
      return;
    case AxiomKind::disjoint_data_properties:  // U(x,v), V(x,v) -> false
      for (std::size_t first = 0; first < arguments.size(); ++first) {
        for (std::size_t second = first + 1; second < arguments.size() && !translator_->is_full(); ++second) {
          translator_->add_clause({{atom(first, 1), atom(second, 1)}, {}});
        }
      }
      return;
    case AxiomKind::data_property_domain: {  // U(x,v) -> C(x)
      Draft draft;
      draft.clause.body.push_back(atom(0, draft.variables++));
      draft.is_binary = true;
      draft.waiting.push_back({positive(arguments[1]), centre});
      translator_->add(std::move(draft));
      return;
    }
    case AxiomKind::data_property_range: {  // U(x,v) -> D(v)
      const DataRangeId range = vocabulary_.data_range(range_of(source_, arguments[1], false));
      if (range == DataRangeId{0}) return;
      Clause clause{{atom(0, 1)}, {}};
      if (range != DataRangeId{1}) clause.head.push_back({AtomKind::data_range, 1, centre, number(range)});
      translator_->add_clause(std::move(clause));
      return;
    }
    case AxiomKind::functional_data_property:  // U(x,v1), U(x,v2) -> v1 = v2
      translator_->add_clause({{atom(0, 1), atom(0, 2)}, {{AtomKind::data_equal, 1, 2, 0}}});
      return;
    default:
      return;
  }
}

}  // namespace geminga::clauses
