// The hierarchy, chains and features of properties in some axioms, each with the axioms that state it.
#ifndef GEMINGA_REASONING_EXPLANATION_PROOF_ROLES_HPP
#define GEMINGA_REASONING_EXPLANATION_PROOF_ROLES_HPP

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "reasoning/explanation/explain_minimal.hpp"
#include "reasoning/explanation/proof_terms.hpp"
#include "reasoning/owl/source.hpp"

namespace geminga::explanation {

/// A property expression, and the axioms by which another one is below it. No axioms if it is that one itself.
struct RoleAbove {
  owl::TermId role{};
  AxiomSet axioms;
};
/// A chain of properties that is below a property.
struct RoleChain {
  std::vector<owl::TermId> links;
  owl::TermId super{};
  std::uint32_t axiom = 0;
};
/// A feature of a property: a range, or being functional. A domain is a range of the inverse.
struct RoleFeature {
  owl::TermId role{};
  owl::TermId range{};  ///< owl:Thing if the feature is no range
  std::uint32_t axiom = 0;
};

/// Object properties with their inverses, and data properties. The axioms are few, so all tables are lists.
class ProofRoles {
 public:
  ProofRoles(owl::Ontology& source, ProofTerms& terms, std::span<const std::uint32_t> axioms);

  /// The property expressions above one, each by the fewest axioms. The expression itself comes first.
  [[nodiscard]] const std::vector<RoleAbove>& above(owl::TermId role);
  /// The axioms by which `sub` is below `super`. Nothing if it is not.
  [[nodiscard]] const AxiomSet* find(owl::TermId sub, owl::TermId super);
  [[nodiscard]] const std::vector<RoleChain>& chains() const { return chains_; }
  [[nodiscard]] const std::vector<RoleFeature>& ranges() const { return ranges_; }
  [[nodiscard]] const std::vector<RoleFeature>& functional() const { return functional_; }

 private:
  struct Inclusion {
    owl::TermId sub{};
    owl::TermId super{};
    std::uint32_t axiom = 0;
  };
  void add(std::uint32_t axiom);
  void include(owl::TermId sub, owl::TermId super, std::uint32_t axiom);
  void add_chain(std::vector<owl::TermId> links, owl::TermId super, std::uint32_t axiom);
  [[nodiscard]] owl::TermId role(owl::TermId term);
  [[nodiscard]] owl::TermId inverse(owl::TermId role) { return terms_.inverse(role); }

  owl::Ontology& source_;
  ProofTerms& terms_;
  std::vector<Inclusion> inclusions_;
  std::vector<RoleChain> chains_;
  std::vector<RoleFeature> ranges_;
  std::vector<RoleFeature> functional_;
  std::map<owl::TermId, std::vector<RoleAbove>> above_;
};

}  // namespace geminga::explanation

#endif
