// From the triples of all files to axioms: the mapping of OWL 2 to RDF (W3C Recommendation, 11 December 2012),
// backwards.
#ifndef GEMINGA_REASONING_SYNTAX_RDF_MAPPING_MAPPING_HPP
#define GEMINGA_REASONING_SYNTAX_RDF_MAPPING_MAPPING_HPP

#include <vector>

#include "reasoning/owl/annotation.hpp"
#include "reasoning/owl/source.hpp"
#include "reasoning/syntax/rdf/triples/graph.hpp"

namespace geminga::rdf {

/// Adds the axioms of an indexed graph to an ontology. What cannot be mapped is left out by name; nothing is refused.
/// All files are read before anything is mapped, so that the order of triples means nothing. `files` are the
/// ontology's numbers of the graph's files.
/// Annotations are appended where `annotations` is not null.
void map_to_axioms(const Graph& graph, owl::Ontology& ontology, std::vector<owl::FileId> files,
                   std::vector<owl::Annotation>* annotations = nullptr);

}  // namespace geminga::rdf

#endif
