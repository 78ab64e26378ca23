// One kind of axiom after the other. Legend as in expressions.hpp.
#include "reasoning/el/normaliser/rule_normaliser.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace geminga::el {

RuleNormaliser::RuleNormaliser(const owl::Ontology& source, IndexBuilder& index)
    : source_(source),
      index_(index),
      data_(source, index, pending_),
      terms_(source, index, data_),
      universals_(index, pending_, open_),
      expressions_(source, index, terms_, data_, universals_, pending_, open_),
      properties_(source, index, terms_, expressions_, universals_, pending_, open_),
      keys_(source, index, terms_, expressions_, pending_) {}

owl::Construct RuleNormaliser::add(std::uint32_t number) {
  const owl::Axiom axiom = source_.axiom(number);
  pending_.begin(number);
  switch (axiom.kind) {
    case owl::AxiomKind::declaration:
      return owl::Construct::none;
    case owl::AxiomKind::sub_class_of:
    case owl::AxiomKind::equivalent_classes:
    case owl::AxiomKind::disjoint_classes:
    case owl::AxiomKind::disjoint_union:
    case owl::AxiomKind::datatype_definition:
      return add_class_axiom(axiom);
    case owl::AxiomKind::dl_safe_rule:
      // A rule is about named individuals.
      return names_individuals() ? open_.beyond(owl::Construct::rule) : owl::Construct::none;
    case owl::AxiomKind::has_key:
      return open_.beyond(keys_.add(axiom));
    case owl::AxiomKind::sub_data_property_of:
    case owl::AxiomKind::equivalent_data_properties:
    case owl::AxiomKind::disjoint_data_properties:
    case owl::AxiomKind::functional_data_property:
      return properties_.add_data(axiom);
    case owl::AxiomKind::same_individual:
    case owl::AxiomKind::different_individuals:
    case owl::AxiomKind::class_assertion:
    case owl::AxiomKind::object_property_assertion:
    case owl::AxiomKind::negative_object_property_assertion:
    case owl::AxiomKind::data_property_assertion:
    case owl::AxiomKind::negative_data_property_assertion:
      return add_assertion(axiom);
    default:
      return properties_.add_object(axiom);
  }
}

bool RuleNormaliser::names_individuals() {
  if (!names_individuals_) {
    names_individuals_ = false;
    for (std::uint32_t id = 0; id < source_.term_count() && !*names_individuals_; ++id)
      names_individuals_ = source_.kind(owl::TermId{id}) == owl::TermKind::individual;
  }
  return *names_individuals_;
}

UnusedAxioms RuleNormaliser::finish(Universals universals) {
  UnusedAxioms unused;
  properties_.mirror();
  keys_.finish(unused);
  data_.relate();
  data_.find_unused(unused);
  if (index_.roles().chains().empty() && !universals_.has_universals()) return unused;
  Roles closed = index_.roles();
  if (!closed.close_hierarchy(max_role_pairs)) return unused;  // the index will not close either, and that is reported
  properties_.find_not_simple(closed, unused);
  universals_.finish(closed, properties_.chains(), universals, unused);
  return unused;
}

owl::Construct RuleNormaliser::include(owl::TermId sub, owl::TermId super) {
  if (const std::optional<owl::Construct> range = include_as_range(sub, super)) return *range;
  index_.add_told(terms_.expression(sub), terms_.expression(super));
  return first_unused(expressions_.use_left(sub), expressions_.use_right(super));
}

//  T < R only C              is the range C of R
//  inverse R some T < C      too
std::optional<owl::Construct> RuleNormaliser::include_as_range(owl::TermId sub, owl::TermId super) {
  const owl::Term left = source_.term(sub);
  const owl::Term right = source_.term(super);
  const bool is_all =
      right.kind == owl::TermKind::object_all_values_from || right.kind == owl::TermKind::data_all_values_from;
  if (is_all && terms_.expression(sub) == top_expr) {
    const Property role = terms_.property(right.arguments[0]);
    if (!role.is_inverse && !role.is_top) return properties_.add_range(role, right.arguments[1]);
  }
  if (left.kind == owl::TermKind::object_some_values_from && terms_.expression(left.arguments[1]) == top_expr) {
    const Property role = terms_.property(left.arguments[0]);
    if (role.is_inverse) return properties_.add_range(role, super);
  }
  return std::nullopt;
}

owl::Construct RuleNormaliser::add_class_axiom(const owl::Axiom& axiom) {
  const auto arguments = axiom.arguments;
  switch (axiom.kind) {
    case owl::AxiomKind::sub_class_of:
      return include(arguments[0], arguments[1]);
    case owl::AxiomKind::disjoint_classes:
      return add_disjoint(arguments);
    case owl::AxiomKind::disjoint_union:
      return add_disjoint_union(arguments);
    default: {
      owl::Construct unused = owl::Construct::none;
      for (const owl::TermId other : arguments.subspan(1)) {
        unused = first_unused(unused, first_unused(include(arguments[0], other), include(other, arguments[0])));
      }
      return unused;
    }
  }
}

owl::Construct RuleNormaliser::add_disjoint_union(std::span<const owl::TermId> whole_and_parts) {
  const owl::TermId told = whole_and_parts[0];
  const std::span<const owl::TermId> members = whole_and_parts.subspan(1);
  owl::Construct unused = owl::Construct::none;
  for (const owl::TermId part : members) unused = first_unused(unused, include(part, told));
  unused = first_unused(unused, add_disjoint(members));
  std::vector<ExprId> parts;
  for (const owl::TermId part : members) parts.push_back(terms_.expression(part));
  const ExprId whole = terms_.union_of(parts);
  index_.add_told(terms_.expression(told), whole);
  if (members.size() == 1) return first_unused(unused, expressions_.use_right(members[0]));
  expressions_.leave_union_open(whole, parts);
  return first_unused(unused, owl::Construct::disjoint_union_of);
}

owl::Construct RuleNormaliser::add_disjoint(std::span<const owl::TermId> members) {
  owl::Construct unused = owl::Construct::none;
  std::vector<ExprId> exprs;
  for (const owl::TermId member : members) {
    exprs.push_back(terms_.expression(member));
    unused = first_unused(unused, expressions_.use_left(member));
  }
  exclude_each_other(std::move(exprs));
  return unused;
}

void RuleNormaliser::exclude_each_other(std::vector<ExprId> members) {
  // Small axioms, and axioms with equal members, become pairs; n members of a large one would need n * n conjunctions.
  constexpr std::size_t max_by_pairs = 4;
  std::ranges::sort(members);
  // Next to T, no other member can have an instance; a member that stands twice has none.
  for (std::size_t at = 0; at + 1 < members.size(); ++at) {
    if (members[at] == members[at + 1]) index_.add_told(members[at], bottom_expr);
  }
  members.erase(std::unique(members.begin(), members.end()), members.end());
  std::erase(members, bottom_expr);
  if (members.size() < 2) return;
  if (members.size() > max_by_pairs && members.front() != top_expr) {
    index_.add_disjoint(members);
    return;
  }
  for (std::size_t first = 0; first < members.size(); ++first) {
    for (std::size_t second = first + 1; second < members.size(); ++second) {
      if (first > 0 && members.front() == top_expr) continue;  // the other members are empty already
      expressions_.exclude(members[first], members[second]);
    }
  }
}

owl::Construct RuleNormaliser::add_assertion(const owl::Axiom& axiom) {
  const auto arguments = axiom.arguments;
  switch (axiom.kind) {
    case owl::AxiomKind::same_individual:
      for (const owl::TermId other : arguments.subspan(1)) {
        index_.add_told(terms_.expression(arguments[0]), terms_.expression(other));
        index_.add_told(terms_.expression(other), terms_.expression(arguments[0]));
      }
      return owl::Construct::none;
    case owl::AxiomKind::different_individuals:
      return add_disjoint(arguments);
    case owl::AxiomKind::class_assertion:
      index_.add_told(terms_.expression(arguments[1]), terms_.expression(arguments[0]));
      return expressions_.use_right(arguments[0]);
    case owl::AxiomKind::object_property_assertion:
    case owl::AxiomKind::data_property_assertion:
      return add_property_assertion(axiom, false);
    default:
      return add_property_assertion(axiom, true);
  }
}

owl::Construct RuleNormaliser::add_property_assertion(const owl::Axiom& axiom, bool is_negative) {
  const Property role = terms_.property(axiom.arguments[0]);
  ExprId from = terms_.expression(axiom.arguments[1]);
  ExprId to = terms_.expression(axiom.arguments[2]);
  if (role.is_top) {
    if (!is_negative) return owl::Construct::none;
    index_.add_told(from, bottom_expr);  // the top property relates all, so that this cannot hold
    return owl::Construct::none;
  }
  const owl::TermId value = axiom.arguments[2];
  if (source_.kind(value) == owl::TermKind::literal) {
    data_.note_literal(value);
    if (is_negative) data_.note_wanted_literal(value);
  }
  if (role.is_inverse) std::swap(from, to);
  if (is_negative) {
    expressions_.exclude(from, expressions_.recognised_some(role, to));
  } else {
    index_.add_told(from, index_.existential(role.role, to));
  }
  return owl::Construct::none;
}

}  // namespace geminga::el
