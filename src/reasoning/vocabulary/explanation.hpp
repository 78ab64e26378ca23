// Why one class of a vocabulary is below another, or what it lacks to be.
#ifndef GEMINGA_REASONING_VOCABULARY_EXPLANATION_HPP
#define GEMINGA_REASONING_VOCABULARY_EXPLANATION_HPP

#include <string>
#include <vector>

#include "reasoning/explanation/explain_module.hpp"
#include "reasoning/taxonomy/class_number.hpp"

namespace geminga::vocabulary {

/// What Vocabulary::explain() gives.
struct Explanation {
  bool is_subsumed = false;
  /// A minimal set that says so, in the order of the argument. Empty: it is so in every ontology, or (rarely) no engine
  /// finds it again within its limits.
  std::vector<explanation::ExplainedAxiom> axioms;
  /// Where it is not subsumed: the most specific classes above both, and lines for a person that say what is nearest.
  std::vector<taxonomy::ClassNumber> common;
  std::vector<std::string> missing;
};

}  // namespace geminga::vocabulary

#endif
