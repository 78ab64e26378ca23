// Axioms, one kind after the other. Expressions are in rule_normaliser_terms.cpp.
#include "reasoning/el/rule_normaliser.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "base/assert.hpp"

namespace geminga::el {
namespace {

/// The first construct of two that is not used.
owl::Construct both(owl::Construct first, owl::Construct second) {
  return first != owl::Construct::none ? first : second;
}

}  // namespace

owl::Construct RuleNormaliser::add(std::uint32_t number) {
  const owl::Axiom axiom = source_.axiom(number);
  current_axiom_ = number;
  switch (axiom.kind) {
    case owl::AxiomKind::declaration:
      return owl::Construct::none;
    case owl::AxiomKind::sub_class_of:
    case owl::AxiomKind::equivalent_classes:
    case owl::AxiomKind::disjoint_classes:
    case owl::AxiomKind::disjoint_union:
    case owl::AxiomKind::datatype_definition:
    case owl::AxiomKind::has_key:
      return add_class_axiom(axiom);
    case owl::AxiomKind::sub_data_property_of:
    case owl::AxiomKind::equivalent_data_properties:
    case owl::AxiomKind::disjoint_data_properties:
    case owl::AxiomKind::functional_data_property:
      return add_data_property_axiom(axiom);
    case owl::AxiomKind::same_individual:
    case owl::AxiomKind::different_individuals:
    case owl::AxiomKind::class_assertion:
    case owl::AxiomKind::object_property_assertion:
    case owl::AxiomKind::negative_object_property_assertion:
    case owl::AxiomKind::data_property_assertion:
    case owl::AxiomKind::negative_data_property_assertion:
      return add_assertion(axiom);
    default:
      return add_object_property_axiom(axiom);
  }
}

owl::Construct RuleNormaliser::include(owl::TermId sub, owl::TermId super) {
  if (const std::optional<owl::Construct> range = include_as_range(sub, super)) return *range;
  index_.add_told(expression(sub), expression(super));
  return both(use_negative(sub), use_positive(super));
}

//  T < R only C              is the range C of R
//  inverse R some T < C      too
std::optional<owl::Construct> RuleNormaliser::include_as_range(owl::TermId sub, owl::TermId super) {
  const owl::Term left = source_.term(sub);
  const owl::Term right = source_.term(super);
  const bool is_all =
      right.kind == owl::TermKind::object_all_values_from || right.kind == owl::TermKind::data_all_values_from;
  if (is_all && expression(sub) == top_expr) {
    const Property role = property(right.arguments[0]);
    if (!role.is_inverse && !role.is_top) return add_range(role, right.arguments[1], current_axiom_);
  }
  if (left.kind == owl::TermKind::object_some_values_from && expression(left.arguments[1]) == top_expr) {
    const Property role = property(left.arguments[0]);
    if (role.is_inverse) return add_range(role, super, current_axiom_);
  }
  return std::nullopt;
}

owl::Construct RuleNormaliser::add_class_axiom(const owl::Axiom& axiom) {
  const auto arguments = axiom.arguments;
  owl::Construct unused = owl::Construct::none;
  switch (axiom.kind) {
    case owl::AxiomKind::sub_class_of:
      return include(arguments[0], arguments[1]);
    case owl::AxiomKind::equivalent_classes:
    case owl::AxiomKind::datatype_definition:
      for (const owl::TermId other : arguments.subspan(1)) {
        unused = both(unused, both(include(arguments[0], other), include(other, arguments[0])));
      }
      return unused;
    case owl::AxiomKind::disjoint_classes:
      return add_disjoint(arguments);
    case owl::AxiomKind::disjoint_union: {
      for (const owl::TermId part : arguments.subspan(1)) unused = both(unused, include(part, arguments[0]));
      unused = both(unused, add_disjoint(arguments.subspan(1)));
      std::vector<ExprId> parts;
      for (const owl::TermId part : arguments.subspan(1)) parts.push_back(expression(part));
      const ExprId whole = make_union(parts);
      index_.add_told(expression(arguments[0]), whole);
      if (arguments.size() == 2) return both(unused, use_positive(arguments[1]));
      open_union(whole, parts);
      return both(unused, owl::Construct::disjoint_union_of);
    }
    default:
      return beyond(add_key(axiom));
  }
}

owl::Construct RuleNormaliser::add_disjoint(std::span<const owl::TermId> members) {
  // Small axioms, and those with equal members, go by pairs; n members of a large one would need n * n conjunctions.
  constexpr std::size_t max_by_pairs = 4;
  owl::Construct unused = owl::Construct::none;
  std::vector<ExprId> exprs;
  for (const owl::TermId member : members) {
    exprs.push_back(expression(member));
    unused = both(unused, use_negative(member));
  }
  std::vector<ExprId> sorted = exprs;
  std::ranges::sort(sorted);
  // T and another cannot both have instances; a member that is given twice has none.
  for (std::size_t at = 0; at + 1 < sorted.size(); ++at) {
    if (sorted[at] == sorted[at + 1]) index_.add_told(sorted[at], bottom_expr);
  }
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  std::erase(sorted, bottom_expr);
  if (sorted.size() < 2) return unused;
  if (sorted.size() > max_by_pairs && sorted.front() != top_expr) {
    index_.add_disjoint(sorted);
    return unused;
  }
  for (std::size_t first = 0; first < sorted.size(); ++first) {
    for (std::size_t second = first + 1; second < sorted.size(); ++second) {
      if (first > 0 && sorted.front() == top_expr) continue;  // then each of the others is empty already
      const ExprId both_of_them = index_.conjunction({sorted[first], sorted[second]});
      index_.mark_negative(both_of_them);
      index_.add_told(both_of_them, bottom_expr);
    }
  }
  return unused;
}

owl::Construct RuleNormaliser::add_domain(const Property& property, owl::TermId domain) {
  const ExprId some = negative_some(property, top_expr);
  index_.add_told(some, expression(domain));
  return use_positive(domain);
}

owl::Construct RuleNormaliser::add_range(const Property& property, owl::TermId range, std::uint32_t axiom) {
  const ExprId atom = index_.range_atom(property.role);
  index_.add_told(atom, expression(range));
  ranges_.push_back({axiom, property.role, expression(range)});
  return use_positive(range);
}

owl::Construct RuleNormaliser::add_chain(const owl::Term& chain, owl::TermId super) {
  const Property to = property(super);
  if (to.is_top) return owl::Construct::none;
  std::vector<RoleId> roles;
  bool is_inverse = to.is_inverse;
  for (const owl::TermId link : chain.arguments) {
    const Property one = property(link);
    if (one.is_inverse != is_inverse) return beyond(owl::Construct::inverse_of);
    if (one.is_top) return beyond(owl::Construct::top_property);
    roles.push_back(one.role);
  }
  if (is_inverse) std::ranges::reverse(roles);
  add_chain(roles, to.role);
  return owl::Construct::none;
}

void RuleNormaliser::add_chain(std::span<const RoleId> roles, RoleId super) {
  index_.roles().add_chain(roles, super);
  owl::RoleChain chain{{}, role_of(super), static_cast<std::uint32_t>(chains_.size())};
  for (const RoleId role : roles) chain.word.push_back(role_of(role));
  chains_.push_back(std::move(chain));
}

owl::Construct RuleNormaliser::add_object_property_axiom(const owl::Axiom& axiom) {
  const auto arguments = axiom.arguments;
  if (axiom.kind == owl::AxiomKind::sub_object_property_of &&
      source_.kind(arguments[0]) == owl::TermKind::object_property_chain) {
    return add_chain(source_.term(arguments[0]), arguments[1]);
  }
  const Property first = property(arguments[0]);
  const auto include_roles = [&](const Property& sub, const Property& super) {
    if (super.is_top) return owl::Construct::none;
    if (sub.is_top) return beyond(owl::Construct::top_property);
    if (sub.is_inverse != super.is_inverse) return open_inverse(sub, super, owl::Construct::inverse_of);
    index_.roles().add_sub_role(sub.role, super.role);
    return owl::Construct::none;
  };
  switch (axiom.kind) {
    case owl::AxiomKind::sub_object_property_of:
      return include_roles(first, property(arguments[1]));
    case owl::AxiomKind::equivalent_object_properties: {
      owl::Construct unused = owl::Construct::none;
      for (const owl::TermId other : arguments.subspan(1)) {
        unused = both(unused, both(include_roles(first, property(other)), include_roles(property(other), first)));
      }
      return unused;
    }
    case owl::AxiomKind::object_property_domain:
    case owl::AxiomKind::object_property_range: {
      if (first.is_top) return beyond(owl::Construct::top_property);
      const bool is_range = (axiom.kind == owl::AxiomKind::object_property_range) != first.is_inverse;
      return is_range ? add_range(first, arguments[1], current_axiom_) : add_domain(first, arguments[1]);
    }
    case owl::AxiomKind::data_property_domain:
      return first.is_top ? beyond(owl::Construct::top_property) : add_domain(first, arguments[1]);
    case owl::AxiomKind::data_property_range:
      return first.is_top ? beyond(owl::Construct::top_property) : add_range(first, arguments[1], current_axiom_);
    case owl::AxiomKind::transitive_object_property:
      if (!first.is_top) add_chain(std::array{first.role, first.role}, first.role);
      return owl::Construct::none;
    case owl::AxiomKind::reflexive_object_property:
      if (!first.is_top) index_.add_told(top_expr, index_.self(first.role));
      return owl::Construct::none;
    case owl::AxiomKind::irreflexive_object_property: {
      if (first.is_top) return beyond(owl::Construct::top_property);
      note_use(SimpleUse{first.role, owl::Construct::irreflexive_not_simple});
      const ExprId self = index_.self(first.role);
      index_.mark_negative(self);
      index_.add_told(self, bottom_expr);
      return owl::Construct::none;
    }
    case owl::AxiomKind::inverse_object_properties:
      return add_inverse(first, property(arguments[1]));
    case owl::AxiomKind::functional_object_property:
      if (first.is_top) return beyond(owl::Construct::functional);
      if (first.is_inverse) return beyond(owl::Construct::inverse_functional);
      note_use(SimpleUse{first.role, owl::Construct::functional_not_simple});
      index_.add_functional(top_expr, first.role);
      return owl::Construct::none;
    case owl::AxiomKind::inverse_functional_object_property:
      if (first.is_top || !first.is_inverse) return beyond(owl::Construct::inverse_functional);
      note_use(SimpleUse{first.role, owl::Construct::inverse_functional_not_simple});
      index_.add_functional(top_expr, first.role);
      return owl::Construct::none;
    case owl::AxiomKind::symmetric_object_property:
      return open_inverse(first, first, owl::Construct::symmetric);
    case owl::AxiomKind::asymmetric_object_property:
      return beyond(owl::Construct::asymmetric);
    default:
      return beyond(owl::Construct::disjoint_properties);
  }
}

owl::Construct RuleNormaliser::add_inverse(const Property& one, const Property& other) {
  if (one.is_inverse != other.is_inverse) return beyond(owl::Construct::inverse_of);
  open_inverse(other, one, owl::Construct::inverse_of);
  return open_inverse(one, other, owl::Construct::inverse_of);
}

owl::Construct RuleNormaliser::add_data_property_axiom(const owl::Axiom& axiom) {
  const auto arguments = axiom.arguments;
  const Property first = property(arguments[0]);
  switch (axiom.kind) {
    case owl::AxiomKind::sub_data_property_of:
    case owl::AxiomKind::equivalent_data_properties: {
      owl::Construct unused = owl::Construct::none;
      const auto include_roles = [&](const Property& sub, const Property& super) {
        if (super.is_top) return;
        if (sub.is_top) {
          unused = beyond(owl::Construct::top_property);
        } else {
          index_.roles().add_sub_role(sub.role, super.role);
        }
      };
      for (const owl::TermId other : arguments.subspan(1)) {
        include_roles(first, property(other));
        if (axiom.kind == owl::AxiomKind::equivalent_data_properties) include_roles(property(other), first);
      }
      return unused;
    }
    case owl::AxiomKind::functional_data_property:
      if (first.is_top) return beyond(owl::Construct::functional);
      index_.add_functional(top_expr, first.role);
      return owl::Construct::none;
    default:
      return beyond(owl::Construct::disjoint_properties);
  }
}

owl::Construct RuleNormaliser::add_assertion(const owl::Axiom& axiom) {
  const auto arguments = axiom.arguments;
  switch (axiom.kind) {
    case owl::AxiomKind::same_individual:
      for (const owl::TermId other : arguments.subspan(1)) {
        index_.add_told(expression(arguments[0]), expression(other));
        index_.add_told(expression(other), expression(arguments[0]));
      }
      return owl::Construct::none;
    case owl::AxiomKind::different_individuals:
      return add_disjoint(arguments);
    case owl::AxiomKind::class_assertion:
      index_.add_told(expression(arguments[1]), expression(arguments[0]));
      return use_positive(arguments[0]);
    case owl::AxiomKind::object_property_assertion:
    case owl::AxiomKind::data_property_assertion:
      return add_property_assertion(axiom, false);
    default:
      return add_property_assertion(axiom, true);
  }
}

owl::Construct RuleNormaliser::add_property_assertion(const owl::Axiom& axiom, bool is_negative) {
  const Property role = property(axiom.arguments[0]);
  ExprId from = expression(axiom.arguments[1]);
  ExprId to = expression(axiom.arguments[2]);
  if (role.is_top) {
    if (!is_negative) return owl::Construct::none;
    index_.add_told(from, bottom_expr);  // all are related by it, so that this cannot hold
    return owl::Construct::none;
  }
  const owl::TermId value = axiom.arguments[2];
  if (source_.kind(value) == owl::TermKind::literal) {
    note_literal(value);
    if (is_negative) use_negative_literal(value);
  }
  if (role.is_inverse) std::swap(from, to);
  const ExprId some = index_.existential(role.role, to);
  if (!is_negative) {
    index_.add_told(from, some);
    return owl::Construct::none;
  }
  index_.mark_negative(some);
  const ExprId clash = index_.conjunction({from, some});
  index_.mark_negative(clash);
  index_.add_told(clash, bottom_expr);
  return owl::Construct::none;
}

}  // namespace geminga::el
