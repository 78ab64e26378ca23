// The way from OWL axioms to the index: EL axioms are added exactly, others are weakened soundly and named.
#ifndef GEMINGA_REASONING_EL_NORMALISER_RULE_NORMALISER_HPP
#define GEMINGA_REASONING_EL_NORMALISER_RULE_NORMALISER_HPP

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "reasoning/el/index/index_builder.hpp"
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

/// Rewrites axioms one by one into an index. Everything that it adds follows from the axioms (over names of its own),
/// so that derivations are sound. If add() returns Construct::none, nothing of the axiom is lost.
///
/// It adds the axioms of classes and individuals itself, and leaves their parts to its members. Each member knows only
/// members that are declared before it.
class RuleNormaliser {
 public:
  RuleNormaliser(const owl::Ontology& source, IndexBuilder& index);
  RuleNormaliser(const RuleNormaliser&) = delete;
  RuleNormaliser& operator=(const RuleNormaliser&) = delete;

  /// Adds one axiom of the source. Returns the first construct in it that is not used in full.
  owl::Construct add(std::uint32_t axiom);
  /// Adds how literals and datatypes relate, universals, and ranges of chains. Returns the axioms that only then turn
  /// out not to be used in full. To be called once, after the last axiom.
  [[nodiscard]] UnusedAxioms finish(Universals universals = Universals::left_out);

  /// The axioms of which a part became a universal rule, ascending. Requires finish().
  [[nodiscard]] const UnusedAxioms& uses_of_universals() const { return universals_.uses(); }

  /// The parts of the added axioms that the rules do not use.
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
  /// Whether some term of the source is a named individual.
  bool names_individuals();

  std::optional<bool> names_individuals_;
  const owl::Ontology& source_;
  IndexBuilder& index_;
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
