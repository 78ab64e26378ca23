// The statements that one of two ontologies has and the other has not: axioms, annotations and names.
#ifndef GEMINGA_ONTOLOGY_COMPARISON_STATEMENTS_HPP
#define GEMINGA_ONTOLOGY_COMPARISON_STATEMENTS_HPP

#include <set>
#include <string>
#include <vector>

#include "reasoning/explanation/explain_module.hpp"
#include "reasoning/owl/canonical.hpp"
#include "reasoning/syntax/rdf/load.hpp"

namespace geminga::ontology {

/// Hashes of axioms by what they say. Anonymous individuals count as alike, because their labels are those of a file:
/// two axioms that differ in nothing else are one.
class Axioms {
 public:
  explicit Axioms(const owl::Ontology& source);
  /// Whether an axiom of another source is among them. `hashes` are those of that source, with blank nodes alike.
  [[nodiscard]] bool has(const owl::ContentHashes& hashes, const owl::Axiom& axiom) const {
    return known_.contains(hashes.hash_of(axiom));
  }

 private:
  std::set<owl::ContentHashes::Hash> known_;
};

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
