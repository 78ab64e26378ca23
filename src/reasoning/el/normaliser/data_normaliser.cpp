// The relations between literals and datatypes. Legend as in data_normaliser.hpp.
#include "reasoning/el/normaliser/data_normaliser.hpp"

#include <algorithm>
#include <string_view>
#include <variant>

#include "reasoning/owl/literal_value.hpp"

namespace geminga::el {
namespace {

constexpr std::string_view rdfs_literal = "http://www.w3.org/2000/01/rdf-schema#Literal";

/// True if the two have some values in common, and each has values that the other has not.
bool overlap(owl::Datatype one, owl::Datatype other) {
  return one.family() == other.family() && !one.is_within(other) && !other.is_within(one) && !one.is_disjoint(other);
}

/// The datatypes in which axioms put values. They are few, and axioms that use them are many.
std::vector<owl::Datatype> find_used(const PendingUses& pending) {
  std::vector<owl::Datatype> used;
  for (const PendingUse& use : pending.all()) {
    const auto* type = std::get_if<owl::Datatype>(&use.what);
    if (type == nullptr) continue;
    const auto is_same = [&](owl::Datatype other) {
      return type->family() == other.family() && type->is_within(other) && other.is_within(*type);
    };
    if (std::ranges::none_of(used, is_same)) used.push_back(*type);
  }
  return used;
}

}  // namespace

ExprId DataNormaliser::make_datatype(const owl::Term& term) {
  const std::string_view iri = source_.name(term.name);
  if (iri == rdfs_literal) return top_expr;
  const ExprId expr = index_.add_atom();
  if (const auto type = owl::Datatype::find(iri)) datatypes_.emplace_back(*type, expr);
  return expr;
}

// A literal of an unknown datatype is only known to equal itself.
ExprId DataNormaliser::make_literal(owl::TermId id, const owl::Term& term) {
  auto value = value_of(source_, term);
  if (!value) return index_.add_atom();
  literals_.emplace(id, Literal{value->family, value->is_exact});
  const auto [known, is_new] = expr_of_value_.try_emplace({value->family, value->canonical}, top_expr);
  if (is_new) {
    known->second = index_.add_atom();
    values_.emplace_back(std::move(*value), known->second);
  }
  return known->second;
}

void DataNormaliser::note_literal(owl::TermId id) {
  const auto literal = literals_.find(id);
  if (literal == literals_.end()) {
    has_opaque_literals_ = true;
    pending_.note(OpaqueUse{source_.term(source_.term(id).arguments[0]).name});
  } else if (!literal->second.is_exact) {
    pending_.note(literal->second.family);
  }
}

void DataNormaliser::note_wanted_literal(owl::TermId id) {
  note_literal(id);
  const auto literal = literals_.find(id);
  if (literal != literals_.end()) is_wanted_[static_cast<std::size_t>(literal->second.family)] = true;
}

void DataNormaliser::note_datatype(const owl::Term& term) {
  if (const auto type = owl::Datatype::find(source_.name(term.name))) {
    pending_.note(*type);
  } else {
    pending_.note(OpaqueUse{term.name});
  }
}

void DataNormaliser::note_wanted_datatype(const owl::Term& term) {
  if (!owl::Datatype::find(source_.name(term.name))) wanted_opaque_.insert(term.name);
}

void DataNormaliser::relate() {
  FamilyAtoms families{};
  relate_datatypes(families);
  relate_values(families);
  //  values of different families differ
  std::vector<ExprId> used;
  for (const ExprId atom : families) {
    if (atom != top_expr) used.push_back(atom);
  }
  if (used.size() > 1) index_.add_disjoint(used);
}

//  D < E where D is a part of E;  D and E < F where they have no value in common
void DataNormaliser::relate_datatypes(FamilyAtoms& families) {
  for (const auto& [type, expr] : datatypes_) {
    put_under_family(expr, type.family(), families);
    for (const auto& [other, other_expr] : datatypes_) {
      if (expr == other_expr || type.family() != other.family()) continue;
      if (type.is_within(other)) index_.add_told(expr, other_expr);
      if (expr < other_expr && type.is_disjoint(other)) exclude(expr, other_expr);
    }
  }
}

//  {v} < D where v is in D;  {v} and D < F where it is not;  {u} and {v} < F where u and v differ
void DataNormaliser::relate_values(FamilyAtoms& families) {
  std::vector<ExprId> exact;
  for (const auto& [value, expr] : values_) {
    put_under_family(expr, value.family, families);
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
  if (exact.size() > 1) index_.add_disjoint(exact);
}

void DataNormaliser::put_under_family(ExprId expr, owl::DataFamily family, FamilyAtoms& families) {
  ExprId& atom = families[static_cast<std::size_t>(family)];
  if (atom == top_expr) atom = index_.add_atom();
  index_.add_told(expr, atom);
}

void DataNormaliser::exclude(ExprId one, ExprId other) {
  const ExprId both_of_them = index_.conjunction({one, other});
  index_.mark_negative(both_of_them);
  index_.add_told(both_of_them, bottom_expr);
}

// Four facts are beyond EL. An element of a finite datatype is one of its values; this matters if a value is asked
// for. An element of two overlapping datatypes is in their intersection, which may be finite or a part of a third; the
// datatypes of OWL 2 EL never overlap. A literal may have the value of an inexact one.
// A value of few that is in a datatype of which nothing is known is in it wherever it stands, and has an atom in each
// place; this matters if the datatype is asked for, too. So it is for its literals, which are in it.
void DataNormaliser::find_unused(UnusedAxioms& unused) const {
  const std::vector<owl::Datatype> used = find_used(pending_);
  std::array<std::size_t, owl::data_family_count> value_counts{};
  for (const auto& [value, expr] : values_) ++value_counts[static_cast<std::size_t>(value.family)];
  const bool has_few = has_opaque_literals_ || !values_.empty() ||
                       std::ranges::any_of(datatypes_, [](const auto& datatype) { return datatype.first.is_finite(); });
  for (const PendingUse& use : pending_.all()) {
    if (const auto* opaque = std::get_if<OpaqueUse>(&use.what)) {
      if (has_few && wanted_opaque_.contains(opaque->datatype))
        unused.emplace_back(use.axiom, owl::Construct::overlapping_datatypes);
    } else if (const auto* family = std::get_if<owl::DataFamily>(&use.what)) {
      if (value_counts[static_cast<std::size_t>(*family)] > 1)
        unused.emplace_back(use.axiom, owl::Construct::inexact_literal);
    } else if (const auto* type = std::get_if<owl::Datatype>(&use.what)) {
      if (type->is_finite() && is_wanted_[static_cast<std::size_t>(type->family())]) {
        unused.emplace_back(use.axiom, owl::Construct::finite_datatype);
      } else if (std::ranges::any_of(used, [&](owl::Datatype other) { return overlap(*type, other); })) {
        unused.emplace_back(use.axiom, owl::Construct::overlapping_datatypes);
      }
    }
  }
}

}  // namespace geminga::el
