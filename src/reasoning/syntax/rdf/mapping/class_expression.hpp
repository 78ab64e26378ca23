// One class expression out of triples that hold nothing else, as a query writes it.
#ifndef GEMINGA_REASONING_SYNTAX_RDF_MAPPING_CLASS_EXPRESSION_HPP
#define GEMINGA_REASONING_SYNTAX_RDF_MAPPING_CLASS_EXPRESSION_HPP

#include <expected>
#include <string>

#include "reasoning/owl/source.hpp"
#include "reasoning/syntax/rdf/triples/graph.hpp"

namespace geminga::rdf {

/// Maps the blank node of an indexed graph to a class expression of the ontology. Triples of rdf:type may declare the
/// names in it. Returns what prevents that: a triple that is no part of the expression, something that OWL 2 cannot
/// express, a literal that is not of its datatype. Adds an axiom with the expression to the ontology, which should
/// hold nothing else.
[[nodiscard]] std::expected<owl::TermId, std::string> map_class_expression(const Graph& graph, NodeId node,
                                                                           owl::Ontology& ontology);

}  // namespace geminga::rdf

#endif
