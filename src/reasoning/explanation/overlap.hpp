// Overlap of two classes: whether they can have a common instance, and the axioms that forbid it.
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

/// The limit of axioms that may matter for a pair; beyond it the engines are not asked.
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

/// Decides the overlap. The answers are certain, except undecided: impossible follows, and possible has a model of
/// every axiom. So no pair is possible if the reader left axioms out. Work is counted, so that the answer is the same
/// everywhere.
[[nodiscard]] Overlap find_overlap(const compiled::Ontology& ontology, taxonomy::ClassNumber one, const Class& other,
                                   Patience patience = Patience::of_a_person);

/// A minimal set of axioms by which the two have no common instance, in the order of the argument. Empty if that does
/// not follow or, rarely, no engine finds it again within its limits.
[[nodiscard]] std::vector<ExplainedAxiom> explain_exclusion(const compiled::Ontology& ontology,
                                                            taxonomy::ClassNumber one, const Class& other,
                                                            Patience patience = Patience::of_a_person);

}  // namespace geminga::explanation

#endif
