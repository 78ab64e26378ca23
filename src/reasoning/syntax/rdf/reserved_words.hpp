// The names in the reserved vocabularies of the W3C. Any other name in them is a mistake.
#ifndef GEMINGA_REASONING_SYNTAX_RDF_RESERVED_WORDS_HPP
#define GEMINGA_REASONING_SYNTAX_RDF_RESERVED_WORDS_HPP

#include <string>
#include <string_view>
#include <vector>

namespace geminga::rdf {

/// Whether an IRI is in the namespace of RDF, RDFS, OWL or XSD (OWL 2, section 2.4).
[[nodiscard]] bool is_reserved(std::string_view iri);

/// Whether a reserved IRI is a name of RDF 1.1, RDF Schema 1.1, OWL 1 or 2, or XSD 1.1.
[[nodiscard]] bool is_reserved_word(std::string_view iri);

/// The reserved words, as `rdfs:subClassOf`, that are a few letters away from a reserved IRI: nearest first, at most
/// three.
[[nodiscard]] std::vector<std::string> similar_words(std::string_view iri);

}  // namespace geminga::rdf

#endif
