// The rules that an expression needs because it occurs left or right of SubClassOf.
//
// Legend as in expressions.hpp; X is the atom that stands for an expression without rules.
#ifndef GEMINGA_REASONING_EL_NORMALISER_EXPRESSION_NORMALISER_HPP
#define GEMINGA_REASONING_EL_NORMALISER_EXPRESSION_NORMALISER_HPP

#include <cstdint>
#include <span>
#include <vector>

#include "reasoning/el/index/index_builder.hpp"
#include "reasoning/el/index/open_parts.hpp"
#include "reasoning/el/normaliser/data_normaliser.hpp"
#include "reasoning/el/normaliser/pending_uses.hpp"
#include "reasoning/el/normaliser/property_roles.hpp"
#include "reasoning/el/normaliser/term_expressions.hpp"
#include "reasoning/el/normaliser/universal_normaliser.hpp"
#include "reasoning/owl/construct.hpp"
#include "reasoning/owl/source.hpp"

namespace geminga::el {

/// Adds, once for each term and side, the rules that recognise its expression or that draw its conclusions.
class ExpressionNormaliser {
 public:
  ExpressionNormaliser(const owl::Ontology& source, IndexBuilder& index, TermExpressions& terms, DataNormaliser& data,
                       UniversalNormaliser& universals, PendingUses& pending, OpenParts& open);

  /// Recognises a term that stands left of SubClassOf. Returns the first construct in it without rules.
  owl::Construct use_left(owl::TermId term) { return use(term, Side::left); }
  /// Asserts a term that stands right of SubClassOf. Returns the first construct in it without rules.
  owl::Construct use_right(owl::TermId term) { return use(term, Side::right); }

  /// Recognises R some C of a property that is read forwards.
  ExprId recognised_some(const Property& property, ExprId filler);
  /// Adds C and D < F.
  void exclude(ExprId one, ExprId other);
  /// Keeps X < C or D, for which there is no rule.
  void leave_union_open(ExprId whole, std::span<const ExprId> parts);

 private:
  owl::Construct use(owl::TermId term, Side side);
  owl::Construct use_all_right(std::span<const owl::TermId> terms);
  owl::Construct use_filler(const owl::Term& term, Side side);

  owl::Construct make_left(owl::TermId id);
  owl::Construct make_left_restriction(const owl::Term& term, ExprId expr);
  owl::Construct make_right(owl::TermId id);
  owl::Construct make_right_union(const owl::Term& term, ExprId expr);
  owl::Construct make_right_complement(const owl::Term& term, ExprId expr);
  owl::Construct make_right_restriction(const owl::Term& term, ExprId expr);
  owl::Construct make_all_values(const Property& property, owl::TermId filler, ExprId expr);
  owl::Construct make_at_least(std::uint32_t count, const Property& property, const owl::Term& term);
  owl::Construct make_at_most(std::uint32_t limit, const Property& property, const owl::Term& term, ExprId expr);
  void leave_count_open(std::vector<OpenCount>& counts, const OpenCount& count);

  const owl::Ontology& source_;
  IndexBuilder& index_;
  TermExpressions& terms_;
  DataNormaliser& data_;
  UniversalNormaliser& universals_;
  PendingUses& pending_;
  OpenParts& open_;
  std::vector<std::uint8_t> left_;  ///< by term: 0 not used yet, else 1 + construct
  std::vector<std::uint8_t> right_;
};

}  // namespace geminga::el

#endif
