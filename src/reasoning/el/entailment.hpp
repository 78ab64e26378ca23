// One entailment from some axioms: is this class below that one? Explanations ask it.
#ifndef GEMINGA_REASONING_EL_ENTAILMENT_HPP
#define GEMINGA_REASONING_EL_ENTAILMENT_HPP

#include <cstdint>
#include <span>

#include "reasoning/owl/source.hpp"

namespace geminga::el {

enum class Entailed : std::uint8_t {
  yes,
  no,        ///< all axioms were used, and it does not follow
  not_found  ///< it was not derived, but an axiom was not used in full
};

/// Decides whether these axioms of the source entail `sub` SubClassOf `super`, two named classes. The cost is that of
/// the given axioms and of the contexts that the sub class leads to; other classes are not looked at.
[[nodiscard]] Entailed find_entailed(const owl::Ontology& source, std::span<const std::uint32_t> axioms,
                                     owl::TermId sub, owl::TermId super);

/// True if find_entailed() says yes.
[[nodiscard]] inline bool entails(const owl::Ontology& source, std::span<const std::uint32_t> axioms, owl::TermId sub,
                                  owl::TermId super) {
  return find_entailed(source, axioms, sub, super) == Entailed::yes;
}

}  // namespace geminga::el

#endif
