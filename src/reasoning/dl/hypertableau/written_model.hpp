// The labels of the finished model, as an answer gives them.
#ifndef GEMINGA_REASONING_DL_HYPERTABLEAU_WRITTEN_MODEL_HPP
#define GEMINGA_REASONING_DL_HYPERTABLEAU_WRITTEN_MODEL_HPP

#include <cstddef>

#include "reasoning/dl/hypertableau/graph/dependency.hpp"
#include "reasoning/dl/hypertableau/graph/graph.hpp"
#include "reasoning/dl/hypertableau/tableau.hpp"

namespace geminga::hypertableau {

/// The labels of the model that is in the graph, of concepts below `concept_count`.
///
/// `asked` is the node that was made for the question, or none, and what is asked depends on `supposed`. Nodes older
/// than `before` belong to earlier models, and are left out unless they have changed.
[[nodiscard]] Model write_model(const Graph& graph, std::size_t concept_count, NodeId asked, DependencySet supposed,
                                const Mark& before);

}  // namespace geminga::hypertableau

#endif
