// Lemmas of a proof: inclusions between class expressions that an engine derives from a small set of axioms.
#ifndef GEMINGA_REASONING_EXPLANATION_PROOF_LEMMAS_HPP
#define GEMINGA_REASONING_EXPLANATION_PROOF_LEMMAS_HPP

#include <map>
#include <optional>

#include "reasoning/explanation/explain_module.hpp"
#include "reasoning/explanation/explain_oracle.hpp"
#include "reasoning/explanation/proof_search.hpp"

namespace geminga::explanation {

/// Asks about class expressions, and adds new names for them to the module's source.
class ProofLemmas {
 public:
  ProofLemmas(Module& module, Oracle& oracle) : module_(module), oracle_(oracle) {}

  /// True if an engine derives sub SubClassOf super, two class expressions, from these axioms.
  [[nodiscard]] bool holds(const AxiomSet& axioms, owl::TermId sub, owl::TermId super);
  /// Decides the same; a no is certain, too.
  [[nodiscard]] Oracle::Decision decide(const AxiomSet& axioms, owl::TermId sub, owl::TermId super);
  /// A minimal subset of these axioms that entails it. Nothing if all of them do not.
  [[nodiscard]] std::optional<AxiomSet> find(const AxiomSet& axioms, owl::TermId sub, owl::TermId super);

  /// Gives the search one lemma after the other until it reaches its goal. The last lemma is the goal itself.
  std::uint32_t bridge(ProofSearch& search, const AxiomSet& axioms, owl::TermId sub, owl::TermId super);

 private:
  struct Named {
    owl::TermId name{};
    std::optional<std::uint32_t> axiom;  ///< the axiom that defines the name, if it is a new one
  };
  Named name_below(owl::TermId expression);
  Named name_above(owl::TermId expression);
  [[nodiscard]] owl::TermId fresh();
  /// A question between names, with the axioms that define the names.
  struct Asked {
    AxiomSet axioms;
    owl::TermId below{};
    owl::TermId above{};
  };
  [[nodiscard]] Asked asked(const AxiomSet& axioms, owl::TermId sub, owl::TermId super);

  Module& module_;
  Oracle& oracle_;
  std::map<owl::TermId, Named> below_;
  std::map<owl::TermId, Named> above_;
  std::uint32_t fresh_count_ = 0;
};

}  // namespace geminga::explanation

#endif
