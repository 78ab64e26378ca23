// Loaded files as one document in a syntax of OWL's own.
#ifndef GEMINGA_ONTOLOGY_GRAPH_DOCUMENT_HPP
#define GEMINGA_ONTOLOGY_GRAPH_DOCUMENT_HPP

#include <cstdint>
#include <vector>

#include "ontology/loading/classified_files.hpp"
#include "reasoning/syntax/graph/graph.hpp"
#include "reasoning/syntax/writing/document.hpp"

namespace geminga::ontology {

/// All that the files say as one ontology: it has the name of the first file that has one, and the imports that no file
/// answered. Requires that annotations were kept. Both arguments must outlive the document.
[[nodiscard]] writing::Document document_of(const rdf::Loaded& loaded, const owl::Annotations& annotations);

/// Adds the relations that add_inferred() found as axioms of the source, and returns their numbers.
[[nodiscard]] std::vector<std::uint32_t> add_inferred_axioms(const graph::Graph& inferred, ClassifiedFiles& classified);
/// Adds a declaration of each name in these axioms, and returns the numbers of the declarations.
[[nodiscard]] std::vector<std::uint32_t> add_declarations(const std::vector<std::uint32_t>& axioms,
                                                          owl::Ontology& source);

}  // namespace geminga::ontology

#endif
