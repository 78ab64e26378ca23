// The statements that one of two ontologies has and the other has not: axioms, annotations and names.
#ifndef GEMINGA_ONTOLOGY_COMPARISON_STATEMENTS_HPP
#define GEMINGA_ONTOLOGY_COMPARISON_STATEMENTS_HPP

#include <string>
#include <vector>

#include "ontology/comparison/axioms.hpp"
#include "reasoning/explanation/explain_module.hpp"
#include "reasoning/syntax/rdf/load.hpp"

namespace geminga::ontology {

/// Statements that the old ontology has and the new one has not, and the other way round.
struct Changed {
  std::vector<explanation::ExplainedAxiom> removed;  ///< by file and line
  std::vector<explanation::ExplainedAxiom> added;
  [[nodiscard]] bool is_empty() const { return removed.empty() && added.empty(); }
};

struct ChangedStatements {
  Changed axioms;                          ///< without declarations
  Changed annotations;                     ///< of names, sorted; they have no line
  std::vector<std::string> names_removed;  ///< IRIs that no axiom and no annotation uses any more, sorted
  std::vector<std::string> names_added;
  [[nodiscard]] bool is_empty() const {
    return axioms.is_empty() && annotations.is_empty() && names_removed.empty() && names_added.empty();
  }
};

/// Compares what is stated. Annotations are compared where they were kept.
[[nodiscard]] ChangedStatements compare_statements(const rdf::Loaded& before, const rdf::Loaded& after);

}  // namespace geminga::ontology

#endif
