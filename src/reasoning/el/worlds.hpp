// Worlds: exact reasoning with nominals for classes that must be assumed to have an instance.
//
// A class below a nominal that has an instance is that individual. One saturation merges only classes that have an
// instance in every model. "G < D" asks what holds if G has an instance; so a class that leads to something below a
// nominal is saturated once more with an instance of its own (Kazakov, Kroetzsch, Simancik 2012 show why less is
// incomplete).
#ifndef GEMINGA_REASONING_EL_WORLDS_HPP
#define GEMINGA_REASONING_EL_WORLDS_HPP

#include <optional>
#include <span>
#include <vector>

#include "reasoning/el/closure/saturation.hpp"
#include "reasoning/el/index/indexed_ontology.hpp"

namespace geminga::el {

/// The ascending atoms of `asked` of which a saturation with an instance of their own may say more.
[[nodiscard]] std::vector<ExprId> find_conditional_roots(const IndexedOntology& index, const Saturation& saturation,
                                                         std::span<const ExprId> asked);

/// The subsumers of one atom, from the models in which it has an instance.
struct World {
  bool is_possible = true;    ///< false: the atom is unsatisfiable, or the ontology inconsistent
  std::vector<ExprId> above;  ///< the representatives of all atoms above it, itself and T included
};

/// Saturates with an instance of `root` beside all individuals. Nothing over a limit.
[[nodiscard]] std::optional<World> find_world(const IndexedOntology& index, ExprId root,
                                              std::span<const ExprId> individuals, const SaturationLimits& limits);

}  // namespace geminga::el

#endif
