// What follows from an ontology, as triples: the hierarchies of classes and properties, and the types of individuals.
#ifndef GEMINGA_ONTOLOGY_INFERENCES_HPP
#define GEMINGA_ONTOLOGY_INFERENCES_HPP

#include <expected>
#include <optional>
#include <string>

#include "knowledge.hpp"
#include "reasoning/syntax/graph/graph.hpp"

namespace geminga::ontology {

/// Classifies what is loaded with a class for each of its individuals, so that their types are classified, too. The
/// classes are in the result's taxonomy and not in what add_inferred() gives.
[[nodiscard]] std::expected<Knowledge, NoKnowledge> learn_types(rdf::Loaded loaded, Progress& progress,
                                                                const Learning& how = {});

/// Adds what follows, all of it or what is direct. The ontology must be consistent.
void add_inferred(const Knowledge& knowledge, bool as_closure, graph::Graph& graph);
/// Adds what each name of these relations is, for a reader who is given nothing else.
void add_declarations(const Knowledge& knowledge, graph::Graph& graph);

/// Why something may be missing, in one line; nothing: it is all.
[[nodiscard]] std::optional<std::string> why_incomplete(const Knowledge& knowledge);

}  // namespace geminga::ontology

#endif
