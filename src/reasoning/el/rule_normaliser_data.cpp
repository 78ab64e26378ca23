// Literals and datatypes as atoms, and what is known between them. Legend as in indexed_ontology.hpp; u v are literals.
#include <algorithm>
#include <string>

#include "reasoning/el/rule_normaliser.hpp"
#include "reasoning/owl/literal_value.hpp"

namespace geminga::el {
namespace {

constexpr std::string_view rdfs_literal = "http://www.w3.org/2000/01/rdf-schema#Literal";

}  // namespace

ExprId RuleNormaliser::make_datatype(const owl::Term& term) {
  const std::string_view iri = source_.name(term.name);
  if (iri == rdfs_literal) return top_expr;
  const ExprId expr = index_.add_atom();
  if (const auto type = owl::Datatype::find(iri)) datatypes_.emplace_back(*type, expr);
  return expr;
}

// Literals with the same value are one atom. Of a literal whose datatype nobody knows it is known that it is itself.
ExprId RuleNormaliser::make_literal(owl::TermId id, const owl::Term& term) {
  auto value = value_of(source_, term);
  if (!value) return index_.add_atom();
  family_of_literal_.emplace(id, value->family);
  is_exact_literal_.emplace(id, value->is_exact);
  const auto [known, is_new] = expr_of_value_.try_emplace({value->family, value->canonical}, top_expr);
  if (is_new) {
    known->second = index_.add_atom();
    values_.emplace_back(std::move(*value), known->second);
  }
  return known->second;
}

void RuleNormaliser::use_negative_literal(owl::TermId id) {
  note_literal(id);
  const auto family = family_of_literal_.find(id);
  if (family != family_of_literal_.end()) has_negative_literal_[static_cast<std::size_t>(family->second)] = true;
}

void RuleNormaliser::note_literal(owl::TermId id) {
  const auto exact = is_exact_literal_.find(id);
  if (exact != is_exact_literal_.end() && !exact->second) note_use(family_of_literal_.at(id));
}

owl::Construct RuleNormaliser::use_positive_datatype(const owl::Term& term) {
  if (const auto type = owl::Datatype::find(source_.name(term.name))) note_use(*type);
  return owl::Construct::none;
}

void RuleNormaliser::relate_data() {
  const auto exclude = [&](ExprId one, ExprId other) {
    const ExprId both_of_them = index_.conjunction({one, other});
    index_.mark_negative(both_of_them);
    index_.add_told(both_of_them, bottom_expr);
  };
  std::array<ExprId, owl::data_family_count> families{};
  const auto put_under_family = [&](ExprId expr, owl::DataFamily family) {
    ExprId& atom = families[static_cast<std::size_t>(family)];
    if (atom == top_expr) atom = index_.add_atom();
    index_.add_told(expr, atom);
  };

  //  D < E where D is a part of E;  D and E < F where they have no value in common
  for (const auto& [type, expr] : datatypes_) {
    put_under_family(expr, type.family());
    for (const auto& [other, other_expr] : datatypes_) {
      if (expr == other_expr || type.family() != other.family()) continue;
      if (type.is_within(other)) index_.add_told(expr, other_expr);
      if (expr < other_expr && type.is_disjoint(other)) exclude(expr, other_expr);
    }
  }
  //  {v} < D where v is in D;  {v} and D < F where it is not
  std::vector<ExprId> exact;
  for (const auto& [value, expr] : values_) {
    put_under_family(expr, value.family);
    if (value.is_exact) exact.push_back(expr);
    for (const auto& [type, type_expr] : datatypes_) {
      if (type.family() != value.family) continue;
      if (value.is_in(type)) {
        index_.add_told(expr, type_expr);
      } else if (value.is_exact) {
        exclude(expr, type_expr);
      }
    }
  }
  //  {u} and {v} < F where u and v differ; values of different families do
  if (exact.size() > 1) index_.add_disjoint(exact);
  std::vector<ExprId> used;
  for (const ExprId atom : families) {
    if (atom != top_expr) used.push_back(atom);
  }
  if (used.size() > 1) index_.add_disjoint(used);
}

}  // namespace geminga::el
