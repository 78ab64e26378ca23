// One question to some axioms: is this class below that one? The goal-directed run behind explanations.
#ifndef GEMINGA_EL_ENTAILMENT_HPP
#define GEMINGA_EL_ENTAILMENT_HPP

#include <cstdint>
#include <span>

#include "el/source.hpp"

namespace geminga::el {

/// Whether these axioms of the source entail `sub` SubClassOf `super`, two named classes, as far as classify() finds
/// it. Cost: that of the axioms given and of what the sub class leads to; other classes are not looked at.
[[nodiscard]] bool entails(const OntologySource& source, std::span<const std::uint32_t> axioms, TermId sub,
                           TermId super);

}  // namespace geminga::el

#endif
