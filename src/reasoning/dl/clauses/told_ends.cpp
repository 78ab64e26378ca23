// Collects domains, ranges and told classes, and closes over both hierarchies.
#include "reasoning/dl/clauses/told_ends.hpp"

#include <algorithm>
#include <set>
#include <unordered_set>

namespace geminga::clauses {

using owl::AxiomKind;
using owl::TermId;
using owl::TermKind;

ToldEnds::ToldEnds(Vocabulary& vocabulary, const owl::RoleBox& roles, std::span<const owl::RoleInclusion> inclusions,
                   Allowed& allowed, std::span<const OrderedAxiom> axioms)
    : source_(vocabulary.source()), roles_(roles) {
  bool has_paths = false;
  for (const OrderedAxiom& axiom : axioms) {
    const bool is_domain = axiom.kind == AxiomKind::object_property_domain;
    if (!is_domain && axiom.kind != AxiomKind::object_property_range) continue;
    const Role role = vocabulary.role(axiom.arguments[0]);
    has_paths = has_paths || !roles.is_simple(role);
    const Shape shape = shape_of(source_, positive(axiom.arguments[1]));
    if (shape.kind == ShapeKind::atom) ranges_[roles.canonical(is_domain ? inverse(role) : role)].push_back(shape.term);
  }
  if (!has_paths) ranges_.clear();
  if (ranges_.empty()) return;
  for (const OrderedAxiom& axiom : axioms) add_classes(axiom, allowed);
  for (const auto& [sub, super] : inclusions) {
    supers_[roles.canonical(sub)].push_back(roles.canonical(super));
    supers_[roles.canonical(inverse(sub))].push_back(roles.canonical(inverse(super)));
  }
}

void ToldEnds::add_classes(const OrderedAxiom& axiom, Allowed& allowed) {
  const auto& arguments = axiom.arguments;
  switch (axiom.kind) {
    case AxiomKind::sub_class_of:
      add_inclusion(arguments[0], arguments[1], allowed);
      return;
    case AxiomKind::equivalent_classes:
      for (const TermId other : std::span(arguments).subspan(1)) {
        add_inclusion(arguments[0], other, allowed);
        add_inclusion(other, arguments[0], allowed);
      }
      return;
    case AxiomKind::disjoint_union:
      for (const TermId part : std::span(arguments).subspan(1)) add_inclusion(part, arguments[0], allowed);
      return;
    default:
      return;
  }
}

void ToldEnds::add_inclusion(TermId sub, TermId super, Allowed& allowed) {
  const Shape below = shape_of(source_, positive(sub));
  if (below.kind != ShapeKind::atom) return;
  const Shape shape = shape_of(source_, positive(super));
  if (shape.kind == ShapeKind::atom) above_[below.term].push_back(shape.term);
  if (shape.kind != ShapeKind::all_of || !allowed.problem(positive(super)).empty()) return;
  for (const Literal operand : shape.operands) {
    const Shape part = shape_of(source_, operand);
    if (part.kind == ShapeKind::atom) above_[below.term].push_back(part.term);
  }
}

const std::vector<TermId>& ToldEnds::ends_of(Role role) {
  const auto [found, is_new] = ends_.try_emplace(roles_.canonical(role));
  std::vector<TermId>& ends = found->second;
  if (!is_new) return ends;
  std::vector<Role> supers = {roles_.canonical(role)};
  std::set<Role> seen_roles(supers.begin(), supers.end());
  for (std::size_t at = 0; at < supers.size(); ++at) {
    const auto told = supers_.find(supers[at]);
    if (told == supers_.end()) continue;
    for (const Role super : told->second) {
      if (seen_roles.insert(super).second) supers.push_back(super);
    }
  }
  std::unordered_set<TermId> seen;
  const auto add = [&](const std::vector<TermId>& classes) {
    for (const TermId one : classes) {
      if (seen.insert(one).second) ends.push_back(one);
    }
  };
  for (const Role super : supers) {
    if (const auto told = ranges_.find(super); told != ranges_.end()) add(told->second);
  }
  for (std::size_t at = 0; at < ends.size(); ++at) {
    if (const auto told = above_.find(ends[at]); told != above_.end()) add(told->second);
  }
  std::ranges::sort(ends);
  return ends;
}

bool ToldEnds::ends_in(Role role, TermId named_class) {
  return !ranges_.empty() && std::ranges::binary_search(ends_of(role), named_class);
}

}  // namespace geminga::clauses
