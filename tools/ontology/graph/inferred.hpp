// The triples that follow from an ontology: the hierarchies of classes and properties, and the types and facts of
// individuals.
#ifndef GEMINGA_ONTOLOGY_GRAPH_INFERRED_HPP
#define GEMINGA_ONTOLOGY_GRAPH_INFERRED_HPP

#include <optional>
#include <string>

#include "ontology/individuals/realized_files.hpp"
#include "ontology/loading/classified_files.hpp"
#include "reasoning/syntax/graph/graph.hpp"

namespace geminga::ontology {

/// Adds the relations that follow, all of them or the direct ones. The types of
/// individuals and their facts are those of the realisation. Requires a consistent ontology. Each relation that
/// is looked at costs a step; where the budget ends that, returns so in one line, and relations are missing. The graph
/// has its own limit.
[[nodiscard]] std::optional<std::string> add_inferred(const ClassifiedFiles& classified,
                                                      const realization::Realization& realization, bool as_closure,
                                                      base::Budget& budget, graph::Graph& graph);
/// Adds the declaration of each name in these sorted relations, for readers of nothing else: the kinds of the names are
/// those of the axioms that the relations are. Adds these to the source. Returns why that failed, in one line.
[[nodiscard]] std::optional<std::string> add_declarations(ClassifiedFiles& classified, graph::Graph& graph);

/// The reason why relations may be missing, in one line; nothing where none is missing.
[[nodiscard]] std::optional<std::string> why_incomplete(const ClassifiedFiles& classified);

}  // namespace geminga::ontology

#endif
