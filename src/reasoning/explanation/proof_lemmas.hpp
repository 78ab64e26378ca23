// Inclusions that an engine finds between class expressions of a small set of axioms, for where the rules of a proof
// end.
#ifndef GEMINGA_REASONING_EXPLANATION_PROOF_LEMMAS_HPP
#define GEMINGA_REASONING_EXPLANATION_PROOF_LEMMAS_HPP

#include <map>
#include <optional>
#include <vector>

#include "reasoning/explanation/explain_module.hpp"
#include "reasoning/explanation/explain_oracle.hpp"
#include "reasoning/explanation/proof_search.hpp"

namespace geminga::reasoner {

/// Asks about class expressions, for which it names new classes in the module's source.
class ProofLemmas {
 public:
  ProofLemmas(Module& module, Oracle& oracle) : module_(module), oracle_(oracle) {}

  /// Whether these axioms entail sub SubClassOf super, two class expressions.
  [[nodiscard]] bool holds(const AxiomSet& axioms, el::TermId sub, el::TermId super);
  /// The fewest of these axioms that entail it, or nothing where all of them do not.
  [[nodiscard]] std::optional<AxiomSet> find(const AxiomSet& axioms, el::TermId sub, el::TermId super);

  /// Gives the search one lemma after the other, until it reaches its goal; the goal itself at last.
  std::uint32_t bridge(ProofSearch& search, const AxiomSet& axioms, el::TermId sub, el::TermId super);

 private:
  struct Named {
    el::TermId name{};
    std::optional<std::uint32_t> axiom;  ///< that says what the name is for, where it is a new one
  };
  Named name_below(el::TermId expression);
  Named name_above(el::TermId expression);
  [[nodiscard]] el::TermId fresh();

  Module& module_;
  Oracle& oracle_;
  std::map<el::TermId, Named> below_;
  std::map<el::TermId, Named> above_;
  std::uint32_t fresh_count_ = 0;
};

}  // namespace geminga::reasoner

#endif
