// One kind of term after the other; a term that equals T, F or another expression becomes that expression at once.
#include "reasoning/el/normaliser/term_expressions.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "base/assert.hpp"
#include "base/sorted.hpp"

namespace geminga::el {

TermExpressions::TermExpressions(const owl::Ontology& source, IndexBuilder& index, DataNormaliser& data)
    : source_(source),
      index_(index),
      data_(data),
      roles_(source, index),
      opaque_(index),
      exprs_(source.term_count(), none) {}

ExprId TermExpressions::make(owl::TermId id) {
  const ExprId made = make_expression(id);
  exprs_[static_cast<std::size_t>(id)] = number(made);
  return made;
}

ExprId TermExpressions::make_expression(owl::TermId id) {
  const owl::Term term = source_.term(id);
  switch (term.kind) {
    case owl::TermKind::named_class: {
      const std::string_view iri = source_.name(term.name);
      if (iri == owl::owl_thing) return top_expr;
      if (iri == owl::owl_nothing) return bottom_expr;
      return index_.add_atom();
    }
    case owl::TermKind::datatype:
      return data_.make_datatype(term);
    case owl::TermKind::literal:
      return data_.make_literal(id, term);
    case owl::TermKind::individual:
    case owl::TermKind::anonymous_individual:
      individuals_.push_back(index_.add_nominal());
      return individuals_.back();
    case owl::TermKind::object_intersection_of:
    case owl::TermKind::data_intersection_of:
      return index_.conjunction(expressions(term.arguments));
    case owl::TermKind::object_union_of:
    case owl::TermKind::data_union_of:
    case owl::TermKind::object_one_of:
    case owl::TermKind::data_one_of:
      return union_of(expressions(term.arguments));
    case owl::TermKind::object_complement_of:
    case owl::TermKind::data_complement_of:
      return make_complement(term);
    case owl::TermKind::datatype_restriction:
      return index_.add_atom();
    default:
      return make_restriction(term);
  }
}

std::vector<ExprId> TermExpressions::expressions(std::span<const owl::TermId> terms) {
  std::vector<ExprId> found;
  for (const owl::TermId term : terms) found.push_back(expression(term));
  return found;
}

ExprId TermExpressions::make_complement(const owl::Term& term) {
  const ExprId part = expression(term.arguments[0]);
  if (part == top_expr) return bottom_expr;
  if (part == bottom_expr) return top_expr;
  if (source_.kind(term.arguments[0]) == term.kind) return expression(source_.term(term.arguments[0]).arguments[0]);
  return opaque_.find(owl::TermKind::object_complement_of, 0, {number(part)});
}

ExprId TermExpressions::union_of(std::span<const ExprId> parts) {
  std::vector<std::uint32_t> key;
  for (const ExprId part : parts) {
    if (part == top_expr) return top_expr;
    if (part != bottom_expr) key.push_back(number(part));
  }
  base::sort_unique(key);
  if (key.empty()) return bottom_expr;
  if (key.size() == 1) return ExprId{key.front()};
  return opaque_.find(owl::TermKind::object_union_of, 0, std::move(key));
}

ExprId TermExpressions::make_some(const Property& property, ExprId filler) {
  if (filler == bottom_expr) return bottom_expr;
  if (property.is_inverse) return opaque_restriction(owl::TermKind::object_some_values_from, 0, property, filler);
  return index_.existential(property.role, filler);
}

ExprId TermExpressions::make_restriction(const owl::Term& term) {
  const Property role = property(term.arguments[0]);
  switch (term.kind) {
    case owl::TermKind::object_some_values_from:
    case owl::TermKind::data_some_values_from:
    case owl::TermKind::object_has_value:
    case owl::TermKind::data_has_value:
      return make_some(role, expression(term.arguments[1]));
    case owl::TermKind::object_has_self:
      return index_.self(role.role);
    case owl::TermKind::object_all_values_from:
    case owl::TermKind::data_all_values_from: {
      const ExprId filler = expression(term.arguments[1]);
      return filler == top_expr ? top_expr : opaque_restriction(owl::TermKind::object_all_values_from, 0, role, filler);
    }
    case owl::TermKind::object_min_cardinality:
    case owl::TermKind::data_min_cardinality:
      if (term.number == 0) return top_expr;
      if (term.number == 1 || filler_of(term) == bottom_expr) return make_some(role, filler_of(term));
      return opaque_restriction(owl::TermKind::object_min_cardinality, term.number, role, filler_of(term));
    case owl::TermKind::object_max_cardinality:
    case owl::TermKind::data_max_cardinality:
      if (filler_of(term) == bottom_expr) return top_expr;
      return opaque_restriction(owl::TermKind::object_max_cardinality, term.number, role, filler_of(term));
    case owl::TermKind::object_exact_cardinality:
    case owl::TermKind::data_exact_cardinality: {
      const ExprId filler = filler_of(term);
      if (filler == bottom_expr) return term.number == 0 ? top_expr : bottom_expr;
      const ExprId most = opaque_restriction(owl::TermKind::object_max_cardinality, term.number, role, filler);
      if (term.number == 0) return most;
      const ExprId least = term.number == 1
                               ? make_some(role, filler)
                               : opaque_restriction(owl::TermKind::object_min_cardinality, term.number, role, filler);
      return index_.conjunction({least, most});
    }
    default:
      GEMINGA_ASSERT(false);  // a term that is no class expression or data range
      return bottom_expr;
  }
}

ExprId TermExpressions::opaque_restriction(owl::TermKind kind, std::uint32_t count, const Property& property,
                                           ExprId filler) {
  return opaque_.find(kind, count,
                      {static_cast<std::uint32_t>(property.role), property.is_inverse ? 1U : 0U, number(filler)});
}

}  // namespace geminga::el
