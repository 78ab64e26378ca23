// From OWL axioms to the index: what EL can say exactly is said, what it cannot is weakened soundly and named.
#ifndef GEMINGA_REASONING_EL_NORMALISER_RULE_NORMALISER_HPP
#define GEMINGA_REASONING_EL_NORMALISER_RULE_NORMALISER_HPP

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "reasoning/el/index/indexed_ontology.hpp"
#include "reasoning/el/index/open_parts.hpp"
#include "reasoning/el/normaliser/data_normaliser.hpp"
#include "reasoning/el/normaliser/expression_normaliser.hpp"
#include "reasoning/el/normaliser/key_normaliser.hpp"
#include "reasoning/el/normaliser/pending_uses.hpp"
#include "reasoning/el/normaliser/property_normaliser.hpp"
#include "reasoning/el/normaliser/term_expressions.hpp"
#include "reasoning/el/normaliser/universal_normaliser.hpp"
#include "reasoning/owl/construct.hpp"
#include "reasoning/owl/source.hpp"

namespace geminga::el {

/// Rewrites axioms one by one into an index. Everything it adds follows from the axioms (over names of its own), so
/// that whatever is derived is sound; where it returns Construct::none, nothing of the axiom is lost.
///
/// It adds the axioms of classes and individuals itself, and gives what they are made of to the classes below it. Each
/// of these knows only those that are declared before it.
class RuleNormaliser {
 public:
  RuleNormaliser(const owl::Ontology& source, IndexedOntology& index);
  RuleNormaliser(const RuleNormaliser&) = delete;
  RuleNormaliser& operator=(const RuleNormaliser&) = delete;

  /// Adds one axiom of the source; the first construct in it that is not used in full.
  owl::Construct add(std::uint32_t axiom);
  /// To be called once after the last axiom: says how literals and datatypes relate, what universals and the ranges of
  /// chains say, and which axioms turn out only then not to be used in full.
  [[nodiscard]] UnusedAxioms finish(Universals universals = Universals::left_out);

  /// After finish(): the axioms of which a part is used by a universal rule, ascending.
  [[nodiscard]] const UnusedAxioms& uses_of_universals() const { return universals_.uses(); }

  /// What the rules do not use of the added axioms.
  [[nodiscard]] const OpenParts& open() const { return open_; }

  /// The expression of a class, whether an axiom uses it or not.
  ExprId expression(owl::TermId term) { return terms_.expression(term); }
  /// All individuals that the added axioms name.
  [[nodiscard]] const std::vector<ExprId>& individuals() const { return terms_.individuals(); }

 private:
  owl::Construct add_class_axiom(const owl::Axiom& axiom);
  owl::Construct add_assertion(const owl::Axiom& axiom);
  owl::Construct add_property_assertion(const owl::Axiom& axiom, bool is_negative);
  owl::Construct include(owl::TermId sub, owl::TermId super);
  std::optional<owl::Construct> include_as_range(owl::TermId sub, owl::TermId super);
  owl::Construct add_disjoint(std::span<const owl::TermId> members);
  owl::Construct add_disjoint_union(std::span<const owl::TermId> whole_and_parts);
  void exclude_each_other(std::vector<ExprId> members);

  const owl::Ontology& source_;
  IndexedOntology& index_;
  PendingUses pending_;
  OpenParts open_;
  DataNormaliser data_;
  TermExpressions terms_;
  UniversalNormaliser universals_;
  ExpressionNormaliser expressions_;
  PropertyNormaliser properties_;
  KeyNormaliser keys_;
};

}  // namespace geminga::el

#endif
