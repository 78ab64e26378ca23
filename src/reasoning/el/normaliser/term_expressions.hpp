// The expressions of an ontology's terms.
#ifndef GEMINGA_REASONING_EL_NORMALISER_TERM_EXPRESSIONS_HPP
#define GEMINGA_REASONING_EL_NORMALISER_TERM_EXPRESSIONS_HPP

#include <cstdint>
#include <span>
#include <vector>

#include "base/interner.hpp"
#include "reasoning/el/index/index_builder.hpp"
#include "reasoning/el/normaliser/data_normaliser.hpp"
#include "reasoning/el/normaliser/opaque_atoms.hpp"
#include "reasoning/el/normaliser/property_roles.hpp"
#include "reasoning/owl/source.hpp"

namespace geminga::el {

/// Gives each term its expression when it is first asked for, on either side of SubClassOf. An expression without rules
/// becomes an atom of its own.
class TermExpressions {
 public:
  TermExpressions(const owl::Ontology& source, IndexBuilder& index, DataNormaliser& data);

  /// The expression of a class, a data range, an individual or a literal.
  ExprId expression(owl::TermId term) {
    std::uint32_t& known = exprs_[static_cast<std::size_t>(term)];
    return known != none ? ExprId{known} : make(term);
  }
  /// True if expression() was asked for the term.
  [[nodiscard]] bool has_expression(owl::TermId term) const { return exprs_[static_cast<std::size_t>(term)] != none; }
  Property property(owl::TermId term) { return roles_.find(term); }

  /// Treats an unqualified min R as min R T.
  [[nodiscard]] static bool is_qualified(const owl::Term& restriction) { return restriction.arguments.size() == 2; }
  /// The filler C of a restriction on R and C.
  ExprId filler_of(const owl::Term& restriction) {
    return is_qualified(restriction) ? expression(restriction.arguments[1]) : top_expr;
  }

  /// Returns T or F, one of the parts, or an atom that has no rules yet.
  ExprId union_of(std::span<const ExprId> parts);
  /// The atom of a restriction without rules.
  ExprId opaque_restriction(owl::TermKind kind, std::uint32_t count, const Property& property, ExprId filler);

  /// All individuals that were asked for, in order.
  [[nodiscard]] const std::vector<ExprId>& individuals() const { return individuals_; }

 private:
  static constexpr std::uint32_t none = base::NumberTable::none;

  ExprId make(owl::TermId id);
  ExprId make_expression(owl::TermId id);
  ExprId make_complement(const owl::Term& term);
  ExprId make_restriction(const owl::Term& term);
  ExprId make_some(const Property& property, ExprId filler);
  [[nodiscard]] std::vector<ExprId> expressions(std::span<const owl::TermId> terms);

  const owl::Ontology& source_;
  IndexBuilder& index_;
  DataNormaliser& data_;
  PropertyRoles roles_;
  OpaqueAtoms opaque_;
  std::vector<std::uint32_t> exprs_;  ///< by term
  std::vector<ExprId> individuals_;
};

}  // namespace geminga::el

#endif
