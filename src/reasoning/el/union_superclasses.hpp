// Superclasses of unions: C or D < E follows from C < E and D < E.
#ifndef GEMINGA_REASONING_EL_UNION_SUPERCLASSES_HPP
#define GEMINGA_REASONING_EL_UNION_SUPERCLASSES_HPP

#include <utility>
#include <vector>

#include "reasoning/el/closure/saturation.hpp"
#include "reasoning/el/index/open_parts.hpp"

namespace geminga::el {

/// Inclusions of the unions of `open` in atoms that are above all their parts, without those that are told.
/// Enumerations of individuals are unions, too. Linear in the number of atoms above the parts.
[[nodiscard]] std::vector<std::pair<ExprId, ExprId>> find_union_superclasses(const IndexedOntology& index,
                                                                             const Saturation& saturation,
                                                                             const OpenParts& open);

}  // namespace geminga::el

#endif
