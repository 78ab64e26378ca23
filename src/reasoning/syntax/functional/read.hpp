// From the bytes of one file in the functional-style syntax of OWL 2 to the axioms of an Ontology.
//
//   const el::FileId file = source.add_file(path);
//   const auto document = functional::read(bytes, file, source);
//   if (!document) return refuse(to_string(document.error()));    // "soma.owl:17: expected a class expression, found
//   ')'" for (const auto& import : document->imports) ...              // the caller's business: none is fetched here
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

/// Whether a file is in this syntax by its content: its first word behind white space and comments is `Prefix` or
/// `Ontology`, and a bracket follows. Looks no further.
[[nodiscard]] bool is_functional(std::string_view bytes);

/// Reads a whole file into the source. Sets the ontology IRI of `file` there, adds every axiom with its line, and the
/// texts of rdfs:label and skos:prefLabel as labels. Declared prefixes are not added: which file's meaning of a prefix
/// counts is settled among all files. What no axiom kind can express is left out there by name; annotations have no
/// meaning for a reasoner, and are only counted.
///
/// Annotations of names and of the ontology are put where they are wanted.
///
/// On an error the source holds an unknown part of the file: the caller drops it. Linear in the file.
[[nodiscard]] std::expected<Document, ReadError> read(std::string_view bytes, owl::FileId file, owl::Ontology& source,
                                                      const Limits& limits = {},
                                                      std::vector<owl::Annotation>* annotations = nullptr);

}  // namespace geminga::functional

#endif
