// What the relative IRIs of a file are relative to.
#ifndef GEMINGA_REASONING_SYNTAX_RDF_TRIPLES_BASE_IRI_HPP
#define GEMINGA_REASONING_SYNTAX_RDF_TRIPLES_BASE_IRI_HPP

#include <string>

namespace geminga::rdf {

/// `file:///NAME` of a file's name without its folder and without .gz, so that it is the same on every robot.
[[nodiscard]] std::string base_iri(const std::string& path);

}  // namespace geminga::rdf

#endif
