// Individuals as the axioms state them, where no model can be built.
#ifndef GEMINGA_REASONING_REALIZATION_TOLD_HPP
#define GEMINGA_REASONING_REALIZATION_TOLD_HPP

#include <cstddef>

#include "reasoning/owl/source.hpp"
#include "reasoning/realization/realization.hpp"

namespace geminga::realization {

/// The named individuals with the named classes that axioms state and those above, and the stated facts of named
/// properties up to a limit of octets, if it is not 0. All of them are undecided, and there are no gaps yet.
[[nodiscard]] Realization realize_told(const owl::Ontology& source, const taxonomy::Classification& classification,
                                       std::size_t most_fact_octets);

}  // namespace geminga::realization

#endif
