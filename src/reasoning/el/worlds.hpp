// Exact reasoning with nominals where it depends on a class being not empty.
//
// What is below a nominal and not empty is that individual. Within one saturation only what is not empty in every model
// is merged with its individual. "G < D" asks what holds where G has an instance; so a class that leads to something
// below a nominal is saturated once more with an instance of its own (Kazakov, Kroetzsch, Simancik 2012 show why less
// is incomplete).
#ifndef GEMINGA_REASONING_EL_WORLDS_HPP
#define GEMINGA_REASONING_EL_WORLDS_HPP

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "reasoning/el/closure/saturation.hpp"
#include "reasoning/el/index/indexed_ontology.hpp"

namespace geminga::el {

/// Those of the ascending `asked` atoms for which a saturation with an instance of their own may say more.
[[nodiscard]] std::vector<ExprId> find_conditional_roots(const IndexedOntology& index, const Saturation& saturation,
                                                         std::span<const ExprId> asked);

/// What holds for one atom in the models in which it has an instance, which is all that holds for it.
struct World {
  bool is_possible = true;    ///< false: the atom is unsatisfiable, or the ontology inconsistent
  std::vector<ExprId> above;  ///< the representatives of all atoms above it, itself and T included
};

/// Saturates with an instance of `root` beside all individuals. Nothing where the limits do not allow that.
[[nodiscard]] std::optional<World> find_world(const IndexedOntology& index, ExprId root,
                                              std::span<const ExprId> individuals, const SaturationLimits& limits);

}  // namespace geminga::el

#endif
