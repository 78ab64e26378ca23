// Triples as text in RDF/XML (https://www.w3.org/TR/rdf-syntax-grammar/).
#ifndef GEMINGA_REASONING_SYNTAX_GRAPH_RDF_XML_HPP
#define GEMINGA_REASONING_SYNTAX_GRAPH_RDF_XML_HPP

#include <expected>
#include <string>

#include "reasoning/syntax/graph/graph.hpp"
#include "reasoning/syntax/graph/placed_nodes.hpp"

namespace geminga::graph {

/// The text, or why there is none: a property whose name does not end as the name of an XML element does, or a control
/// character. Triples must be sorted.
[[nodiscard]] std::expected<std::string, std::string> write_rdf_xml(Triples sorted, const Prefixes& prefixes);

}  // namespace geminga::graph

#endif
