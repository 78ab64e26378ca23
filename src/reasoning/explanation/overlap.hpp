// Whether something can be an instance of two classes at once, and the axioms that forbid it.
#ifndef GEMINGA_REASONING_EXPLANATION_OVERLAP_HPP
#define GEMINGA_REASONING_EXPLANATION_OVERLAP_HPP

#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "reasoning/compiled/ontology.hpp"
#include "reasoning/explanation/explain_module.hpp"
#include "reasoning/explanation/explain_oracle.hpp"

namespace geminga::explanation {

/// If more axioms may matter for a pair, the engines are not asked.
inline constexpr std::size_t max_overlap_axioms = 20'000;

enum class Common : std::uint8_t {
  possible,    ///< some model has an instance of both
  impossible,  ///< no model has one
  undecided,
};

struct Overlap {
  Common common = Common::undecided;
  std::string reason{};  ///< of undecided: one line for a user
};

/// A class expression of another source, which must outlive it, with names of the ontology.
struct WrittenClass {
  const owl::Ontology& source;
  owl::TermId term;
};
using Class = std::variant<taxonomy::ClassNumber, WrittenClass>;

/// Both answers but undecided are certain: impossible follows, and possible has a model, which takes every axiom into
/// account. So nothing is possible where axioms were left out when the ontology was read. Work is counted, so that the
/// answer is the same everywhere.
[[nodiscard]] Overlap find_overlap(const compiled::Ontology& ontology, taxonomy::ClassNumber one, const Class& other,
                                   Patience patience = Patience::of_a_person);

/// A minimal set of axioms by which nothing is an instance of both, in the order of the argument. Empty if that does
/// not follow or, rarely, no engine finds it again within its limits.
[[nodiscard]] std::vector<ExplainedAxiom> explain_exclusion(const compiled::Ontology& ontology,
                                                            taxonomy::ClassNumber one, const Class& other,
                                                            Patience patience = Patience::of_a_person);

}  // namespace geminga::explanation

#endif
