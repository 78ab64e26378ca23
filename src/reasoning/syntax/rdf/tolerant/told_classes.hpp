// The class hierarchy that triples state, without reasoning.
#ifndef GEMINGA_REASONING_SYNTAX_RDF_TOLERANT_TOLD_CLASSES_HPP
#define GEMINGA_REASONING_SYNTAX_RDF_TOLERANT_TOLD_CLASSES_HPP

#include <utility>
#include <vector>

#include "reasoning/syntax/rdf/triples/graph.hpp"

namespace geminga::rdf {

/// The named classes of a graph.
struct ToldClasses {
  std::vector<NodeId> declared;  ///< that have a type of classes, each once, in the order of reading
  /// Subclass and superclass: what rdfs:subClassOf, owl:equivalentClass, owl:intersectionOf and owl:unionOf say of
  /// named classes, also inside one another, of OWL and of DAML+OIL.
  std::vector<std::pair<NodeId, NodeId>> inclusions;
};

/// Requires an indexed graph.
[[nodiscard]] ToldClasses told_classes(const Graph& graph);

}  // namespace geminga::rdf

#endif
