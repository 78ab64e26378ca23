// Axioms of properties. Legend as in expressions.hpp.
#ifndef GEMINGA_REASONING_EL_NORMALISER_PROPERTY_NORMALISER_HPP
#define GEMINGA_REASONING_EL_NORMALISER_PROPERTY_NORMALISER_HPP

#include <span>

#include "reasoning/el/index/index_builder.hpp"
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

/// Adds the axioms of properties to the index: hierarchy, chains, domains, ranges and characteristics.
class PropertyNormaliser {
 public:
  PropertyNormaliser(const owl::Ontology& source, IndexBuilder& index, TermExpressions& terms,
                     ExpressionNormaliser& expressions, UniversalNormaliser& universals, PendingUses& pending,
                     OpenParts& open);

  /// Adds an axiom of object properties, or a domain or range. Returns the first construct in it that is not used.
  owl::Construct add_object(const owl::Axiom& axiom);
  /// Adds any other axiom of data properties.
  owl::Construct add_data(const owl::Axiom& axiom);
  /// Adds a range of the current axiom. Requires a property that is neither an inverse nor the top property.
  owl::Construct add_range(const Property& property, owl::TermId range);

  /// Adds what inverses say to the properties themselves. To be called once, after the last axiom.
  void mirror();
  /// Adds the axioms to `unused` that count or compare successors of properties with chains.
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
  IndexBuilder& index_;
  TermExpressions& terms_;
  ExpressionNormaliser& expressions_;
  UniversalNormaliser& universals_;
  PendingUses& pending_;
  OpenParts& open_;
  RoleChains chains_;
};

}  // namespace geminga::el

#endif
