// A proof: a minimal set of axioms as an argument of numbered steps, each from axioms and earlier steps by a named
// rule.
//
// Where the rules of proof_search.hpp are not enough, an engine adds lemmas: inclusions between class expressions of
// the set that some of the axioms entail together. Such a step says so, and names the axioms. At worst the goal itself
// is such a step.
#ifndef GEMINGA_REASONING_EXPLANATION_PROOF_HPP
#define GEMINGA_REASONING_EXPLANATION_PROOF_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "reasoning/explanation/explain.hpp"
#include "reasoning/explanation/proof_search.hpp"

namespace geminga::explanation {

/// One step. Its number is one more than the number of axioms and of earlier steps.
struct ProofStep {
  std::string text;  ///< the conclusion in readable syntax
  ProofRule rule = ProofRule::subclass;
  std::vector<std::uint32_t> from;  ///< numbers of axioms and earlier steps, ascending
  owl::TermId sub{};                ///< the conclusion as terms of the module: sub SubClassOf super
  owl::TermId super{};
};

struct Proof {
  AxiomSet axioms;               ///< numbers of the module, in the order of the argument; numbered from 1
  std::vector<ProofStep> steps;  ///< the last one is the goal; none if an axiom is the goal
};

/// The argument for a set that the explainer found. Adds terms and questions to the explainer's module.
[[nodiscard]] Proof prove(Explainer& explainer, const AxiomSet& axioms);

}  // namespace geminga::explanation

#endif
