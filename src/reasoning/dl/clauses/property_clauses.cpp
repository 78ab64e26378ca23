#include "reasoning/dl/clauses/property_clauses.hpp"

#include <algorithm>

namespace geminga::clauses {

using owl::AxiomKind;
using owl::TermId;
using owl::TermKind;

// Legend: R S roles, U V data properties, C a class expression, D a data range.

void collect_roles(const OrderedAxiom& axiom, Vocabulary& vocabulary, std::vector<owl::RoleInclusion>& inclusions,
                   std::vector<owl::RoleChain>& chains) {
  const auto& arguments = axiom.arguments;
  const auto role = [&](std::size_t at) { return vocabulary.role(arguments[at]); };
  switch (axiom.kind) {
    case AxiomKind::sub_object_property_of: {
      if (vocabulary.source().name_of(arguments[1]) == owl::owl_top_object_property) return;
      if (vocabulary.source().kind(arguments[0]) != TermKind::object_property_chain) {
        inclusions.push_back({role(0), role(1)});
        return;
      }
      owl::RoleChain chain{{}, role(1), axiom.axiom};
      for (const TermId part : vocabulary.source().term(arguments[0]).arguments)
        chain.word.push_back(vocabulary.role(part));
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

void PropertyClauses::add_hierarchy(std::span<const owl::RoleInclusion> inclusions, const owl::RoleBox& roles,
                                    std::size_t property_count) {
  // R(x,y) -> S(x,y)
  const auto add = [&](Role sub, Role super) {
    translator_.add_clause({{translator_.role_atom(sub, centre, 1)}, {translator_.role_atom(super, centre, 1)}});
  };
  for (const auto& [sub, super] : inclusions) {
    if (roles.canonical(sub) != roles.canonical(super)) add(sub, super);
  }
  for (std::uint32_t at = 0; at < property_count; ++at) {
    const Role role{PropertyId{at}, false};
    if (!roles.is_symmetric(role) || roles.canonical(role) != role) continue;
    translator_.add_clause(
        {{{AtomKind::role, centre, 1, number(role.property)}}, {{AtomKind::role, 1, centre, number(role.property)}}});
  }
}

std::string_view PropertyClauses::problem(const OrderedAxiom& axiom) {
  const auto all_simple = [&] {
    return std::ranges::all_of(axiom.arguments, [&](TermId property) { return allowed_.is_simple(property); });
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
      return allowed_.problem(positive(axiom.arguments[1]));
    default:
      return {};
  }
}

void PropertyClauses::add(const OrderedAxiom& axiom) {
  add_object_property_axiom(axiom);
  add_data_property_axiom(axiom);
}

void PropertyClauses::add_object_property_axiom(const OrderedAxiom& axiom) {
  const auto& arguments = axiom.arguments;
  const auto role = [&](std::size_t at) { return vocabulary_.role(arguments[at]); };
  const auto atom = [&](Role of, Variable from, Variable to) { return translator_.role_atom(of, from, to); };
  switch (axiom.kind) {
    case AxiomKind::object_property_domain:
      translator_.add_every(role(0), bottom, positive(arguments[1]));
      return;
    case AxiomKind::object_property_range:
      translator_.add_every(inverse(role(0)), bottom, positive(arguments[1]));
      return;
    case AxiomKind::functional_object_property:
    case AxiomKind::inverse_functional_object_property: {
      // R(x,y1), R(x,y2) -> y1 = y2
      const Role along = axiom.kind == AxiomKind::functional_object_property ? role(0) : inverse(role(0));
      translator_.add_clause({{atom(along, centre, 1), atom(along, centre, 2)}, {{AtomKind::equal, 1, 2, 0}}});
      return;
    }
    case AxiomKind::reflexive_object_property:
      translator_.add_clause({{}, {atom(role(0), centre, centre)}});
      return;
    case AxiomKind::irreflexive_object_property:
      translator_.add_clause({{atom(role(0), centre, centre)}, {}});
      return;
    case AxiomKind::asymmetric_object_property:
      translator_.add_clause({{atom(role(0), centre, 1), atom(role(0), 1, centre)}, {}});
      return;
    case AxiomKind::disjoint_object_properties:
      for (std::size_t first = 0; first < arguments.size(); ++first) {
        for (std::size_t second = first + 1; second < arguments.size() && !translator_.is_full(); ++second) {
          translator_.add_clause({{atom(role(first), centre, 1), atom(role(second), centre, 1)}, {}});
        }
      }
      return;
    default:
      return;
  }
}

void PropertyClauses::add_data_property_axiom(const OrderedAxiom& axiom) {
  const auto& arguments = axiom.arguments;
  const auto atom = [&](std::size_t at, Variable value) {
    return Atom{AtomKind::data_role, centre, value, number(vocabulary_.data_property(arguments[at]))};
  };
  switch (axiom.kind) {
    case AxiomKind::sub_data_property_of:  // U(x,v) -> V(x,v)
      if (!allowed_.is_top_data(arguments[1])) translator_.add_clause({{atom(0, 1)}, {atom(1, 1)}});
      return;
    case AxiomKind::equivalent_data_properties:
      for (std::size_t at = 0; at < arguments.size(); ++at) {
        translator_.add_clause({{atom(at, 1)}, {atom((at + 1) % arguments.size(), 1)}});
      }
      return;
    case AxiomKind::disjoint_data_properties:  // U(x,v), V(x,v) -> false
      for (std::size_t first = 0; first < arguments.size(); ++first) {
        for (std::size_t second = first + 1; second < arguments.size() && !translator_.is_full(); ++second) {
          translator_.add_clause({{atom(first, 1), atom(second, 1)}, {}});
        }
      }
      return;
    case AxiomKind::data_property_domain: {  // U(x,v) -> C(x)
      Draft draft;
      draft.clause.body.push_back(atom(0, draft.variables++));
      draft.is_binary = true;
      draft.waiting.push_back({positive(arguments[1]), centre});
      translator_.add(std::move(draft));
      return;
    }
    case AxiomKind::data_property_range: {  // U(x,v) -> D(v)
      const DataRangeId range = vocabulary_.data_range(range_of(vocabulary_.source(), arguments[1], false));
      if (range == DataRangeId{0}) return;
      Clause clause{{atom(0, 1)}, {}};
      if (range != DataRangeId{1}) clause.head.push_back({AtomKind::data_range, 1, centre, number(range)});
      translator_.add_clause(std::move(clause));
      return;
    }
    case AxiomKind::functional_data_property:  // U(x,v1), U(x,v2) -> v1 = v2
      translator_.add_clause({{atom(0, 1), atom(0, 2)}, {{AtomKind::data_equal, 1, 2, 0}}});
      return;
    default:
      return;
  }
}

}  // namespace geminga::clauses
