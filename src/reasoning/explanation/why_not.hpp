// The answer to "why not": what two classes have in common, and what one lacks to be below the other.
#ifndef GEMINGA_REASONING_EXPLANATION_WHY_NOT_HPP
#define GEMINGA_REASONING_EXPLANATION_WHY_NOT_HPP

#include <cstddef>
#include <string>
#include <vector>

#include "reasoning/compiled/ontology.hpp"
#include "reasoning/explanation/explain_module.hpp"
#include "reasoning/explanation/explain_oracle.hpp"

namespace geminga::explanation {

/// A requirement on the instances of the broader class.
struct Requirement {
  std::string text;  ///< "core:observes some soccer:Ball"
  bool is_met = false;
  std::string remark;  ///< how far the requirement is nearly met; empty for others
};

/// One axiom about the broader class.
struct Way {
  ExplainedAxiom axiom;
  /// True if everything that meets all requirements is in the class. If not, they are necessary and not sufficient.
  bool is_sufficient = false;
  std::vector<Requirement> requirements;
  [[nodiscard]] std::size_t missing_count() const;
};

struct WhyNot {
  /// The most specific classes above both, one for each node. owl:Thing if there is no other.
  std::vector<taxonomy::ClassNumber> common;
  /// The ways, sufficient ones first; of these the nearest first, which lack least.
  std::vector<Way> ways;
  bool has_more_ways = false;  ///< there are more ways than are listed
  /// The two classes are disjoint, and these axioms say so.
  bool is_excluded = false;
  std::vector<ExplainedAxiom> exclusion;
  /// True if the subsumption might follow after all: axioms were left out when the ontology was loaded, or not
  /// everything was decided.
  bool may_be_incomplete = false;
};

/// Compares two classes. Requires that `sub` is not below `super`. Costs a pass over the kinds of all axioms, and a
/// question to the engines for each requirement.
[[nodiscard]] WhyNot why_not(const compiled::Ontology& ontology, taxonomy::ClassNumber sub, taxonomy::ClassNumber super,
                             Patience patience = Patience::of_a_person);

/// The comparison in lines for a person, without the first line ("A is not subsumed by B").
[[nodiscard]] std::vector<std::string> describe(const compiled::Ontology& ontology, taxonomy::ClassNumber sub,
                                                taxonomy::ClassNumber super, const WhyNot& why_not);

/// The comparison in one short line: the nearest class, and what the nearest sufficient axiom requires beyond it.
[[nodiscard]] std::string describe_briefly(const compiled::Ontology& ontology, taxonomy::ClassNumber sub,
                                           taxonomy::ClassNumber super, const WhyNot& why_not);

}  // namespace geminga::explanation

#endif
