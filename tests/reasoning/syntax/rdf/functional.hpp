// Axioms of a source written in functional-style syntax, one a line, so that a test can say what it expects.
#ifndef GEMINGA_TESTS_REASONING_SYNTAX_RDF_FUNCTIONAL_HPP
#define GEMINGA_TESTS_REASONING_SYNTAX_RDF_FUNCTIONAL_HPP

#include <string>
#include <vector>

#include "reasoning/owl/source.hpp"

namespace geminga::rdf {

/// `SubClassOf(:A ObjectSomeValuesFrom(:p :B))`. IRIs below http://e/ are written with a bare colon, those of OWL, RDF,
/// RDFS and XSD with their prefixes, others in angle brackets; blank nodes `_:1`, `_:2` in the order of their
/// appearance. Declarations are left out unless they are asked for.
[[nodiscard]] std::vector<std::string> functional(const owl::Ontology& source, bool with_declarations = false);
/// The same with declarations; then "left out: CONSTRUCT, COUNT, line N".
[[nodiscard]] std::vector<std::string> functional_with_left_out(const owl::Ontology& source);
/// "IRI text" or "IRI text@en".
[[nodiscard]] std::vector<std::string> labels(const owl::Ontology& source);
/// "IRI > IRI COST, line N"
[[nodiscard]] std::vector<std::string> conversions(const owl::Ontology& source);
/// "NAME FACTOR" of each name of a unit.
[[nodiscard]] std::vector<std::string> unit_names(const owl::Ontology& source);

}  // namespace geminga::rdf

#endif
