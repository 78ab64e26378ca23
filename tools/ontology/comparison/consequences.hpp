// The subsumptions between named classes that follow from one of two ontologies and not from the other, with reasons.
#ifndef GEMINGA_ONTOLOGY_COMPARISON_CONSEQUENCES_HPP
#define GEMINGA_ONTOLOGY_COMPARISON_CONSEQUENCES_HPP

#include <cstddef>
#include <string>
#include <vector>

#include "base/budget.hpp"
#include "ontology/comparison/statements.hpp"
#include "ontology/loading/classified_files.hpp"
#include "reasoning/compiled/ontology.hpp"

namespace geminga::ontology {

/// One of two ontologies that are compared. All that it refers to must outlive the comparison.
struct Compared {
  const ClassifiedFiles& files;
  const compiled::Ontology& ontology;
};

/// An axiom of a reason, and whether the other ontology lacks it.
struct ReasonAxiom {
  explanation::ExplainedAxiom axiom;
  bool is_different = false;
};

/// A subsumption that one ontology has and the other has not.
struct Different {
  std::string sub;  ///< IRI
  std::string super;
  /// It follows from no other different one and what both have.
  bool is_telling = false;
  std::vector<ReasonAxiom> reason;  ///< of telling ones up to a limit; empty: none was looked for or found
};

struct ChangedConsequences {
  std::vector<Different> gained;   ///< between classes of both: those of the new ontology alone, telling ones first
  std::vector<Different> lost;     ///< and those of the old one alone
  std::vector<Different> emptied;  ///< classes that can have no instance in the new one alone; `super` is owl:Nothing
  std::vector<Different> filled;   ///< and in the old one alone, of those that both have
  bool is_compared = true;         ///< false: one contradicts itself, or there are too many to compare
  bool may_miss = false;           ///< some question about one of them is not decided
  [[nodiscard]] bool is_empty() const { return gained.empty() && lost.empty() && emptied.empty() && filled.empty(); }
};

/// Compares what follows, and looks for so many reasons of each list within the budget.
[[nodiscard]] ChangedConsequences compare_consequences(const Compared& before, const Compared& after,
                                                       std::size_t reasons, base::Budget& budget);

}  // namespace geminga::ontology

#endif
