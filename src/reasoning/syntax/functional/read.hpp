// From the bytes of one file in the functional-style syntax of OWL 2 to the axioms of an Ontology.
//
//   const owl::FileId file = source.add_file(path);
//   const auto document = functional::read(bytes, file, source);
//   if (!document) return refuse(to_string(document.error()));  // "soma.owl:17: expected a class expression, found
//   ')'" for (const auto& import : document->imports) ...            // the caller's business: none is fetched here
//
// The syntax is that of https://www.w3.org/TR/owl2-syntax/; FUNCTIONAL.md says what is read beyond it, and what is not.
#ifndef GEMINGA_REASONING_SYNTAX_FUNCTIONAL_READ_HPP
#define GEMINGA_REASONING_SYNTAX_FUNCTIONAL_READ_HPP

#include <expected>
#include <string_view>
#include <vector>

#include "reasoning/owl/annotation.hpp"
#include "reasoning/owl/document.hpp"
#include "reasoning/owl/source.hpp"
#include "reasoning/syntax/functional/limits.hpp"

namespace geminga::functional {

using owl::Document;
using owl::ReadError;

/// Reads a whole file into the source: sets the ontology IRI of `file`, adds every axiom with its line, and adds the
/// texts of rdfs:label and skos:prefLabel as labels. Declared prefixes are not added, because the loader chooses among
/// those of all files. What no axiom kind can express is left out by name. Annotations mean nothing to a reasoner: they
/// are counted, and kept if the caller wants them.
///
/// After an error the source holds some part of the file, and the caller must drop it. Linear in the file.
[[nodiscard]] std::expected<Document, ReadError> read(std::string_view bytes, owl::FileId file, owl::Ontology& source,
                                                      const FunctionalLimits& limits = {},
                                                      std::vector<owl::Annotation>* annotations = nullptr);

}  // namespace geminga::functional

#endif
