// What all parts of a union have above them, and so the union, too: C or D < E where C < E and D < E.
#ifndef GEMINGA_REASONING_EL_UNION_SUPERCLASSES_HPP
#define GEMINGA_REASONING_EL_UNION_SUPERCLASSES_HPP

#include <utility>
#include <vector>

#include "reasoning/el/closure/saturation.hpp"
#include "reasoning/el/index/open_parts.hpp"

namespace geminga::el {

/// Inclusions between the unions of `open` and atoms that follow from what was derived of the parts and that are not
/// told. Enumerations of individuals are unions, too. Linear in what is above the parts.
[[nodiscard]] std::vector<std::pair<ExprId, ExprId>> find_shared(const IndexedOntology& index,
                                                                 const Saturation& saturation, const OpenParts& open);

}  // namespace geminga::el

#endif
