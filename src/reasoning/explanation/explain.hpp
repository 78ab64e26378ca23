// Explanations of a subsumption: minimal sets of axioms that entail it, whichever engine derived it.
//
// A set is minimal if none of its axioms can be left out (a justification; Kalyanpur, Parsia, Horridge, Sirin 2007). A
// class is unsatisfiable if it is below owl:Nothing. The ontology is inconsistent if owl:Thing is below owl:Nothing.
#ifndef GEMINGA_REASONING_EXPLANATION_EXPLAIN_HPP
#define GEMINGA_REASONING_EXPLANATION_EXPLAIN_HPP

#include <cstddef>
#include <optional>
#include <vector>

#include "reasoning/compiled/ontology.hpp"
#include "reasoning/explanation/explain_module.hpp"
#include "reasoning/explanation/explain_oracle.hpp"
#include "reasoning/explanation/explanations.hpp"

namespace geminga::explanation {

/// One minimal set among these axioms of the oracle's source, which are tried in this order. Nothing if no engine
/// derives the subsumption from them. Where the budget is spent on the way, the set entails it and need not be minimal.
[[nodiscard]] std::optional<AxiomSet> find_justification(Oracle& oracle, const AxiomSet& candidates, owl::TermId sub,
                                                         owl::TermId super);

/// One question about one ontology, which it borrows, as it does the budget. Not thread-safe, but several explainers
/// may share an ontology.
class Explainer {
 public:
  Explainer(const compiled::Ontology& ontology, taxonomy::ClassNumber sub, taxonomy::ClassNumber super,
            Patience patience = Patience::of_a_person, base::Budget* budget = nullptr);
  Explainer(const Explainer&) = delete;
  Explainer& operator=(const Explainer&) = delete;

  /// One minimal set, as numbers of the module, ascending. Nothing if no engine derives the subsumption.
  [[nodiscard]] std::optional<AxiomSet> find_one();
  /// One minimal set among these axioms of the module, which are tried in this order.
  [[nodiscard]] std::optional<AxiomSet> find_one_of(const AxiomSet& candidates);

  /// All minimal sets up to limits. Work is counted in axioms asked about, so that the answer is the same everywhere.
  [[nodiscard]] AllSets find_all(const ExplanationLimits& limits = {}, std::size_t max_work = 4'000'000);

  /// Only its beginning, as long as that was enough to find a set.
  [[nodiscard]] Module& module() { return module_; }
  [[nodiscard]] const Module& module() const { return module_; }
  [[nodiscard]] Oracle& oracle() { return oracle_; }
  [[nodiscard]] owl::TermId sub() const { return sub_; }
  [[nodiscard]] owl::TermId super() const { return super_; }
  /// The axioms in readable syntax, in the order of the argument.
  [[nodiscard]] std::vector<ExplainedAxiom> explained(const AxiomSet& axioms) const;

 private:
  Module module_;
  Oracle oracle_;
  owl::TermId sub_;
  owl::TermId super_;
};

/// A minimal set of axioms that entails `sub` SubClassOf `super`, in the order of the argument. Empty if it holds in
/// every ontology. Nothing if it is not entailed or, rarely, no engine finds it again within its limits; is_subsumed()
/// of the ontology tells which.
[[nodiscard]] std::optional<std::vector<ExplainedAxiom>> explain(const compiled::Ontology& ontology,
                                                                 taxonomy::ClassNumber sub, taxonomy::ClassNumber super,
                                                                 Patience patience = Patience::of_a_person);

}  // namespace geminga::explanation

#endif
