// One kind of axiom after the other. Legend as in expressions.hpp.
#include "reasoning/el/normaliser/property_normaliser.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <variant>
#include <vector>

namespace geminga::el {

PropertyNormaliser::PropertyNormaliser(const owl::Ontology& source, IndexBuilder& index, TermExpressions& terms,
                                       ExpressionNormaliser& expressions, UniversalNormaliser& universals,
                                       PendingUses& pending, OpenParts& open)
    : source_(source),
      index_(index),
      terms_(terms),
      expressions_(expressions),
      universals_(universals),
      pending_(pending),
      open_(open),
      chains_(index) {}

owl::Construct PropertyNormaliser::add_object(const owl::Axiom& axiom) {
  const auto arguments = axiom.arguments;
  if (axiom.kind == owl::AxiomKind::sub_object_property_of &&
      source_.kind(arguments[0]) == owl::TermKind::object_property_chain) {
    return add_chain(source_.term(arguments[0]), arguments[1]);
  }
  const Property first = terms_.property(arguments[0]);
  switch (axiom.kind) {
    case owl::AxiomKind::sub_object_property_of:
      return include(first, terms_.property(arguments[1]));
    case owl::AxiomKind::equivalent_object_properties: {
      owl::Construct unused = owl::Construct::none;
      for (const owl::TermId term : arguments.subspan(1)) {
        const Property other = terms_.property(term);
        unused = first_unused(unused, first_unused(include(first, other), include(other, first)));
      }
      return unused;
    }
    case owl::AxiomKind::object_property_domain:
    case owl::AxiomKind::object_property_range:
    case owl::AxiomKind::data_property_domain:
    case owl::AxiomKind::data_property_range:
      return add_domain_or_range(axiom, first);
    case owl::AxiomKind::inverse_object_properties:
      return add_inverse(first, terms_.property(arguments[1]));
    default:
      return add_characteristic(axiom.kind, first);
  }
}

owl::Construct PropertyNormaliser::include(const Property& sub, const Property& super) {
  if (super.is_top) return owl::Construct::none;
  if (sub.is_top) return open_.beyond(owl::Construct::top_property);
  if (sub.is_inverse != super.is_inverse) return leave_inverse_open(sub, super, owl::Construct::inverse_of);
  index_.roles().add_sub_role(sub.role, super.role);
  return owl::Construct::none;
}

// The domain of an inverse is a range, and the other way round.
owl::Construct PropertyNormaliser::add_domain_or_range(const owl::Axiom& axiom, const Property& property) {
  if (property.is_top) return open_.beyond(owl::Construct::top_property);
  const bool is_told_range =
      axiom.kind == owl::AxiomKind::object_property_range || axiom.kind == owl::AxiomKind::data_property_range;
  return is_told_range != property.is_inverse ? add_range(property, axiom.arguments[1])
                                              : add_domain(property, axiom.arguments[1]);
}

owl::Construct PropertyNormaliser::add_domain(const Property& property, owl::TermId domain) {
  const ExprId some = expressions_.recognised_some(property, top_expr);
  index_.add_told(some, terms_.expression(domain));
  return expressions_.use_right(domain);
}

owl::Construct PropertyNormaliser::add_range(const Property& property, owl::TermId range) {
  const ExprId atom = index_.range_atom(property.role);
  index_.add_told(atom, terms_.expression(range));
  universals_.add_range(property.role, terms_.expression(range));
  return expressions_.use_right(range);
}

owl::Construct PropertyNormaliser::add_characteristic(owl::AxiomKind kind, const Property& property) {
  switch (kind) {
    case owl::AxiomKind::transitive_object_property:
      if (!property.is_top) chains_.add(std::array{property.role, property.role}, property.role);
      return owl::Construct::none;
    case owl::AxiomKind::reflexive_object_property:
      if (!property.is_top) index_.add_told(top_expr, index_.self(property.role));
      return owl::Construct::none;
    case owl::AxiomKind::irreflexive_object_property:
      return add_irreflexive(property);
    case owl::AxiomKind::functional_object_property:
      if (property.is_top) return open_.beyond(owl::Construct::functional);
      if (property.is_inverse) return open_.beyond(owl::Construct::inverse_functional);
      return add_functional(property, owl::Construct::functional_not_simple);
    case owl::AxiomKind::inverse_functional_object_property:
      if (property.is_top || !property.is_inverse) return open_.beyond(owl::Construct::inverse_functional);
      return add_functional(property, owl::Construct::inverse_functional_not_simple);
    case owl::AxiomKind::symmetric_object_property:
      return leave_inverse_open(property, property, owl::Construct::symmetric);
    case owl::AxiomKind::asymmetric_object_property:
      return open_.beyond(owl::Construct::asymmetric);
    default:
      return open_.beyond(owl::Construct::disjoint_properties);
  }
}

owl::Construct PropertyNormaliser::add_functional(const Property& property, owl::Construct not_simple) {
  pending_.note(SimpleUse{property.role, not_simple});
  index_.add_functional(top_expr, property.role);
  return owl::Construct::none;
}

owl::Construct PropertyNormaliser::add_irreflexive(const Property& property) {
  if (property.is_top) return open_.beyond(owl::Construct::top_property);
  pending_.note(SimpleUse{property.role, owl::Construct::irreflexive_not_simple});
  const ExprId self = index_.self(property.role);
  index_.mark_negative(self);
  index_.add_told(self, bottom_expr);
  return owl::Construct::none;
}

owl::Construct PropertyNormaliser::add_chain(const owl::Term& chain, owl::TermId super) {
  const Property to = terms_.property(super);
  if (to.is_top) return owl::Construct::none;
  std::vector<RoleId> roles;
  for (const owl::TermId link : chain.arguments) {
    const Property one = terms_.property(link);
    if (one.is_inverse != to.is_inverse) return open_.beyond(owl::Construct::inverse_of);
    if (one.is_top) return open_.beyond(owl::Construct::top_property);
    roles.push_back(one.role);
  }
  if (to.is_inverse) std::ranges::reverse(roles);
  chains_.add(roles, to.role);
  return owl::Construct::none;
}

owl::Construct PropertyNormaliser::add_inverse(const Property& one, const Property& other) {
  if (one.is_inverse != other.is_inverse) return open_.beyond(owl::Construct::inverse_of);
  leave_inverse_open(other, one, owl::Construct::inverse_of);
  return leave_inverse_open(one, other, owl::Construct::inverse_of);
}

//  sub R, super inverse S:  R(x,y) says S(y,x)
owl::Construct PropertyNormaliser::leave_inverse_open(const Property& sub, const Property& super,
                                                      owl::Construct construct) {
  if (sub.is_top || super.is_top) return open_.beyond(construct);
  open_.inverses.push_back({sub.role, super.role});
  return construct;
}

owl::Construct PropertyNormaliser::add_data(const owl::Axiom& axiom) {
  const Property first = terms_.property(axiom.arguments[0]);
  switch (axiom.kind) {
    case owl::AxiomKind::sub_data_property_of:
      return include(first, terms_.property(axiom.arguments[1]));
    case owl::AxiomKind::equivalent_data_properties: {
      owl::Construct unused = owl::Construct::none;
      for (const owl::TermId term : axiom.arguments.subspan(1)) {
        const Property other = terms_.property(term);
        unused = first_unused(unused, include(first, other));
        unused = first_unused(unused, include(other, first));
      }
      return unused;
    }
    case owl::AxiomKind::functional_data_property:
      if (first.is_top) return open_.beyond(owl::Construct::functional);
      index_.add_functional(top_expr, first.role);
      return owl::Construct::none;
    default:
      return open_.beyond(owl::Construct::disjoint_properties);
  }
}

// Inverses are left to another engine if that has to classify everything again.
void PropertyNormaliser::mirror() { open_.is_mirrored = !open_.is_more && chains_.mirror(open_.inverses); }

// OWL 2 DL allows axioms that count or compare successors for properties without chains only. From the others the rules
// derive nothing wrong, but not everything that follows.
void PropertyNormaliser::find_not_simple(const Roles& closed, UnusedAxioms& unused) const {
  std::vector<bool> is_simple(closed.count(), true);
  for (const Roles::Chain& chain : closed.chains()) {
    for (const RoleId super : closed.supers(chain.result)) is_simple[static_cast<std::size_t>(super)] = false;
  }
  for (const PendingUse& pending : pending_.all()) {
    const auto* use = std::get_if<SimpleUse>(&pending.what);
    if (use != nullptr && !is_simple[static_cast<std::size_t>(use->role)])
      unused.emplace_back(pending.axiom, use->construct);
  }
}

}  // namespace geminga::el
