// What some axioms say of properties, with the axioms that say it.
#ifndef GEMINGA_REASONING_EXPLANATION_PROOF_ROLES_HPP
#define GEMINGA_REASONING_EXPLANATION_PROOF_ROLES_HPP

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "reasoning/explanation/explain_minimal.hpp"
#include "reasoning/explanation/proof_terms.hpp"
#include "reasoning/owl/source.hpp"

namespace geminga::reasoner {

/// A property expression, and the axioms by which another is below it; none where it is that other itself.
struct RoleAbove {
  el::TermId role{};
  AxiomSet axioms;
};
/// A chain of properties that is below a property.
struct RoleChain {
  std::vector<el::TermId> links;
  el::TermId super{};
  std::uint32_t axiom = 0;
};
/// What holds of a property: its range, that it is functional. A domain is the range of the inverse.
struct RoleFeature {
  el::TermId role{};
  el::TermId range{};  ///< owl:Thing where it is not about a range
  std::uint32_t axiom = 0;
};

/// Object properties and their inverses, and data properties. For few axioms: everything is a list.
class ProofRoles {
 public:
  ProofRoles(el::OntologySource& source, ProofTerms& terms, std::span<const std::uint32_t> axioms);

  /// Everything above a property expression, itself first, each by the fewest axioms.
  [[nodiscard]] const std::vector<RoleAbove>& above(el::TermId role);
  /// The axioms by which `sub` is below `super`; nothing where it is not.
  [[nodiscard]] const AxiomSet* find(el::TermId sub, el::TermId super);
  [[nodiscard]] const std::vector<RoleChain>& chains() const { return chains_; }
  [[nodiscard]] const std::vector<RoleFeature>& ranges() const { return ranges_; }
  [[nodiscard]] const std::vector<RoleFeature>& functional() const { return functional_; }

 private:
  struct Inclusion {
    el::TermId sub{};
    el::TermId super{};
    std::uint32_t axiom = 0;
  };
  void add(std::uint32_t axiom);
  void include(el::TermId sub, el::TermId super, std::uint32_t axiom);
  void add_chain(std::vector<el::TermId> links, el::TermId super, std::uint32_t axiom);
  [[nodiscard]] el::TermId role(el::TermId term);
  [[nodiscard]] el::TermId inverse(el::TermId role) { return terms_.inverse(role); }

  el::OntologySource& source_;
  ProofTerms& terms_;
  std::vector<Inclusion> inclusions_;
  std::vector<RoleChain> chains_;
  std::vector<RoleFeature> ranges_;
  std::vector<RoleFeature> functional_;
  std::map<el::TermId, std::vector<RoleAbove>> above_;
};

}  // namespace geminga::reasoner

#endif
