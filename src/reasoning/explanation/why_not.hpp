// Why one class is not below another: what they have in common, and what is missing.
#ifndef GEMINGA_REASONING_EXPLANATION_WHY_NOT_HPP
#define GEMINGA_REASONING_EXPLANATION_WHY_NOT_HPP

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "reasoning/compiled/ontology.hpp"
#include "reasoning/explanation/explain_module.hpp"
#include "reasoning/explanation/explain_oracle.hpp"

namespace geminga::explanation {

/// Something that every instance of the broader class has to be.
struct Requirement {
  std::string text;  ///< "core:observes some soccer:Ball"
  bool is_met = false;
  std::string remark;  ///< of what is nearly met: in how far; empty for others
};

/// One axiom that says what the broader class is.
struct Way {
  ExplainedAxiom axiom;
  /// Whether everything that meets all requirements is in the class. If not, they are necessary and not sufficient.
  bool is_sufficient = false;
  std::vector<Requirement> requirements;
  [[nodiscard]] std::size_t missing_count() const;
};

struct WhyNot {
  /// The most specific classes above both, one for each node. owl:Thing if there is no other.
  std::vector<taxonomy::ClassNumber> common;
  /// Sufficient ones first, and of these the nearest first, of which least is missing.
  std::vector<Way> ways;
  bool has_more_ways = false;  ///< than are listed
  /// The two classes are disjoint, and these axioms say so.
  bool is_excluded = false;
  std::vector<ExplainedAxiom> exclusion;
  /// Axioms were left out when the ontology was loaded. With them it might follow.
  bool may_be_incomplete = false;
};

/// Requires that `sub` is not below `super`. Costs a pass over the kinds of all axioms, and a question to the engines
/// for each requirement.
[[nodiscard]] WhyNot why_not(const compiled::Ontology& ontology, taxonomy::ClassNumber sub, taxonomy::ClassNumber super,
                             Patience patience = Patience::of_a_person);

/// The same in lines for a person, without the first one ("A is not subsumed by B").
[[nodiscard]] std::vector<std::string> describe(const compiled::Ontology& ontology, taxonomy::ClassNumber sub,
                                                taxonomy::ClassNumber super, const WhyNot& why_not);

/// The same in one short line: what is nearest, and what the nearest sufficient axiom requires beyond that.
[[nodiscard]] std::string describe_briefly(const compiled::Ontology& ontology, taxonomy::ClassNumber sub,
                                           taxonomy::ClassNumber super, const WhyNot& why_not);

}  // namespace geminga::explanation

#endif
