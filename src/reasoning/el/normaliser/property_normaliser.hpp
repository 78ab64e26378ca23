// What axioms say of properties. Legend as in indexed_ontology.hpp.
#ifndef GEMINGA_REASONING_EL_NORMALISER_PROPERTY_NORMALISER_HPP
#define GEMINGA_REASONING_EL_NORMALISER_PROPERTY_NORMALISER_HPP

#include <span>

#include "reasoning/el/index/indexed_ontology.hpp"
#include "reasoning/el/index/open_parts.hpp"
#include "reasoning/el/normaliser/expression_normaliser.hpp"
#include "reasoning/el/normaliser/pending_uses.hpp"
#include "reasoning/el/normaliser/property_roles.hpp"
#include "reasoning/el/normaliser/role_chains.hpp"
#include "reasoning/el/normaliser/term_expressions.hpp"
#include "reasoning/el/normaliser/universal_normaliser.hpp"
#include "reasoning/owl/construct.hpp"
#include "reasoning/owl/source.hpp"

namespace geminga::el {

/// Tells the index the axioms of properties: what is below what, chains, domains, ranges and characteristics.
class PropertyNormaliser {
 public:
  PropertyNormaliser(const owl::Ontology& source, IndexedOntology& index, TermExpressions& terms,
                     ExpressionNormaliser& expressions, UniversalNormaliser& universals, PendingUses& pending,
                     OpenParts& open);

  /// An axiom of object properties, or of the domain or range of any. The first construct in it that is not used.
  owl::Construct add_object(const owl::Axiom& axiom);
  /// Any other axiom of data properties.
  owl::Construct add_data(const owl::Axiom& axiom);
  /// The current axiom says that successors by the property, which is no inverse and not the top, are in the range.
  owl::Construct add_range(const Property& property, owl::TermId range);

  /// To be called once, after the last axiom: says of the properties themselves what their inverses say.
  void mirror();
  /// Adds the axioms that count or compare the successors of properties with chains.
  void find_not_simple(const Roles& closed, UnusedAxioms& unused) const;
  [[nodiscard]] std::span<const owl::RoleChain> chains() const { return chains_.all(); }

 private:
  owl::Construct include(const Property& sub, const Property& super);
  owl::Construct add_domain_or_range(const owl::Axiom& axiom, const Property& property);
  owl::Construct add_domain(const Property& property, owl::TermId domain);
  owl::Construct add_characteristic(owl::AxiomKind kind, const Property& property);
  owl::Construct add_functional(const Property& property, owl::Construct not_simple);
  owl::Construct add_irreflexive(const Property& property);
  owl::Construct add_chain(const owl::Term& chain, owl::TermId super);
  owl::Construct add_inverse(const Property& one, const Property& other);
  owl::Construct leave_inverse_open(const Property& sub, const Property& super, owl::Construct construct);

  const owl::Ontology& source_;
  IndexedOntology& index_;
  TermExpressions& terms_;
  ExpressionNormaliser& expressions_;
  UniversalNormaliser& universals_;
  PendingUses& pending_;
  OpenParts& open_;
  RoleChains chains_;
};

}  // namespace geminga::el

#endif
