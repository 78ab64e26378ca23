// Why one class of a vocabulary is below another, or what it lacks.
#ifndef GEMINGA_REASONING_VOCABULARY_EXPLANATION_HPP
#define GEMINGA_REASONING_VOCABULARY_EXPLANATION_HPP

#include <string>
#include <vector>

#include "reasoning/explanation/explain_module.hpp"
#include "reasoning/taxonomy/class_number.hpp"

namespace geminga::vocabulary {

/// The result of Vocabulary::explain().
struct Explanation {
  bool is_subsumed = false;
  /// A minimal set of axioms that entails it, in the order of the argument. Empty if it holds in every ontology or if,
  /// rarely, no engine derives it within its limits.
  std::vector<explanation::ExplainedAxiom> axioms;
  /// If it is not subsumed: the most specific classes above both, and lines for a person that say what is nearest.
  std::vector<taxonomy::ClassNumber> common;
  std::vector<std::string> missing;
};

}  // namespace geminga::vocabulary

#endif
