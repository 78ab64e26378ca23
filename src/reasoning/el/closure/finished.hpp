// What is known to the end where a closure by inheritance was cut off: most of it, as it goes from one seed to the
// next.
#ifndef GEMINGA_REASONING_EL_CLOSURE_FINISHED_HPP
#define GEMINGA_REASONING_EL_CLOSURE_FINISHED_HPP

#include <span>
#include <vector>

#include "reasoning/el/closure/inheritance.hpp"
#include "reasoning/el/index/indexed_ontology.hpp"

namespace geminga::el {

/// Of each expression, a representative of a class, whether nothing is missing above it, if the ontology is consistent:
/// its node and all that this has heard of are final. Requires that the rules use every axiom. Linear in what is above
/// the nodes.
[[nodiscard]] std::vector<bool> find_finished(const IndexedOntology& index, const Inheritance& inheritance,
                                              std::span<const ExprId> exprs);

}  // namespace geminga::el

#endif
