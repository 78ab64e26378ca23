// From the bytes of one document in the Manchester syntax of OWL 2 to the axioms of an Ontology.
//
//   frames::Declared declared;
//   frames::look_ahead(bytes, declared);                     // of every file, before the first is read
//   const owl::FileId file = source.add_file(path);
//   const auto document = frames::read(bytes, file, source, declared);
//   if (!document) return refuse(document.error());          // "oeo.omn", 17, "expected a class, found ','"
//
// The syntax is that of https://www.w3.org/TR/owl2-manchester-syntax/; FRAMES.md says what is read beyond it, and what
// is not.
#ifndef GEMINGA_REASONING_SYNTAX_FRAMES_READ_HPP
#define GEMINGA_REASONING_SYNTAX_FRAMES_READ_HPP

#include <expected>
#include <string_view>
#include <vector>

#include "reasoning/owl/annotation.hpp"
#include "reasoning/owl/document.hpp"
#include "reasoning/owl/source.hpp"
#include "reasoning/syntax/frames/declared.hpp"
#include "reasoning/syntax/frames/limits.hpp"

namespace geminga::frames {

using owl::Document;
using owl::ReadError;

/// Notes the properties and datatypes that a file has frames of. Errors of the file are left to read(). Linear.
void look_ahead(std::string_view bytes, Declared& declared, const FrameLimits& limits = {});

/// Reads a whole file into the source: sets the ontology IRI of `file`, adds every axiom with its line, and adds the
/// texts of rdfs:label and skos:prefLabel as labels. Declared prefixes are not added, because the loader chooses among
/// those of all files. An undeclared property is a data property if a literal or a datatype follows it, and otherwise
/// an object property.
///
/// Annotations of frames and of the ontology are kept if the caller wants them.
///
/// After an error the source holds some part of the file, and the caller must drop it. Linear in the file.
[[nodiscard]] std::expected<Document, ReadError> read(std::string_view bytes, owl::FileId file, owl::Ontology& source,
                                                      const Declared& declared, const FrameLimits& limits = {},
                                                      std::vector<owl::Annotation>* annotations = nullptr);

}  // namespace geminga::frames

#endif
