// The slow and exact way to the place of an expression: the whole ontology is classified again, with a name for it.
//
// It is needed if individuals matter. The conclusions about an expression then depend on its having an instance, which
// may be an individual of which the base knows less (el/worlds.hpp).
#ifndef GEMINGA_REASONING_PLACEMENT_EXPRESSION_SCRATCH_HPP
#define GEMINGA_REASONING_PLACEMENT_EXPRESSION_SCRATCH_HPP

#include <optional>

#include "reasoning/placement/expression.hpp"
#include "reasoning/placement/expression_base.hpp"

namespace geminga::placement {

/// Classifies the axioms of the base with a class that is equivalent to the expression. Nothing if there are more
/// axioms than ExpressionLimits::scratch_axioms.
[[nodiscard]] std::optional<ExpressionPlace> place_by_scratch(const ExpressionBase& base, const owl::Ontology& query,
                                                              owl::TermId expression);

}  // namespace geminga::placement

#endif
