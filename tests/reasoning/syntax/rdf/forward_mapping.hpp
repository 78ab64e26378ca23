// The mapping of OWL 2 to RDF forwards (table 1 of the recommendation), as a test needs it to go there and back.
#ifndef GEMINGA_TESTS_REASONING_SYNTAX_RDF_FORWARD_MAPPING_HPP
#define GEMINGA_TESTS_REASONING_SYNTAX_RDF_FORWARD_MAPPING_HPP

#include <functional>
#include <string>
#include <vector>

#include "reasoning/owl/source.hpp"

namespace geminga::rdf {

/// The axioms of a source as N-Triples, one a line. Those for whose index `is_annotated` says so carry an annotation
/// (section 2.2), which is a reified axiom where the axiom is a triple.
[[nodiscard]] std::vector<std::string> triples_of(const owl::Ontology& source,
                                                  const std::function<bool(std::size_t)>& is_annotated);

}  // namespace geminga::rdf

#endif
