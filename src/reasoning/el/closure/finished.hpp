// The classes that are complete although the budget cut a closure by inheritance off.
#ifndef GEMINGA_REASONING_EL_CLOSURE_FINISHED_HPP
#define GEMINGA_REASONING_EL_CLOSURE_FINISHED_HPP

#include <span>
#include <vector>

#include "reasoning/el/closure/inheritance.hpp"
#include "reasoning/el/index/indexed_ontology.hpp"

namespace geminga::el {

/// Says of each expression, a representative of a class, whether all its subsumers are known if the ontology is
/// consistent: its node and all nodes above it are final. Requires that the rules use every axiom. Linear in the edges
/// between nodes.
[[nodiscard]] std::vector<bool> find_finished(const IndexedOntology& index, const Inheritance& inheritance,
                                              std::span<const ExprId> exprs);

}  // namespace geminga::el

#endif
