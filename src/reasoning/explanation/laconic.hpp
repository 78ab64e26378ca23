// Laconic explanations: minimal sets of axioms without superfluous parts.
#ifndef GEMINGA_REASONING_EXPLANATION_LACONIC_HPP
#define GEMINGA_REASONING_EXPLANATION_LACONIC_HPP

#include <cstddef>
#include <cstdint>
#include <vector>

#include "reasoning/explanation/explain.hpp"

namespace geminga::explanation {

/// The most questions to the engines for one set. Beyond it parts stay as they are.
inline constexpr std::size_t max_laconic_questions = 1'000;

/// The parts of a minimal set that entail the conclusion by themselves.
struct Laconic {
  /// An axiom that follows from one of the set.
  struct PartOf {
    std::uint32_t axiom = 0;  ///< in the module's source, with file and line of the whole
    std::uint32_t whole = 0;  ///< the axiom of the set
    bool is_whole = false;    ///< the part says all that the axiom says
  };
  std::vector<PartOf> parts;  ///< in the order of the argument
  /// False if a limit was reached: there may be parts that are not needed.
  bool is_laconic = true;
};

/// Replaces the axioms of a set that find_one() gave by parts of them that still entail the conclusion, and that cannot
/// be weakened further: no class in them can be left out or be replaced by owl:Thing or owl:Nothing (Horridge, Parsia,
/// Sattler: Laconic and Precise Justifications in OWL, 2008). Adds the parts to the module's source.
[[nodiscard]] Laconic find_laconic(Explainer& explainer, const AxiomSet& set);

}  // namespace geminga::explanation

#endif
