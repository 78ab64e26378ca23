// From the bytes of one file in OWL/XML to the axioms of an Ontology.
//
//   const owl::FileId file = source.add_file(path);
//   const auto document = owlxml::read(bytes, file, source);
//   if (!document) return refuse(document.error());     // "team.owx", 17, "expected a class expression, found
//   <Literal>"
//
// The syntax is that of https://www.w3.org/TR/owl2-xml-serialization/; OWLXML.md says what is read beyond it, and what
// is not. The XML is libxml2's work: nothing is opened and nothing is fetched, whatever the file asks for.
#ifndef GEMINGA_REASONING_SYNTAX_OWLXML_READ_HPP
#define GEMINGA_REASONING_SYNTAX_OWLXML_READ_HPP

#include <expected>
#include <string_view>
#include <vector>

#include "reasoning/owl/annotation.hpp"
#include "reasoning/owl/document.hpp"
#include "reasoning/owl/source.hpp"
#include "reasoning/syntax/owlxml/limits.hpp"

namespace geminga::owlxml {

using owl::Document;
using owl::ReadError;

/// Reads a whole file into the source: sets the ontology IRI of `file`, adds every axiom with the line in which its
/// element's start tag ends, and adds the texts of rdfs:label and skos:prefLabel as labels. Declared prefixes are not
/// added, because the loader chooses among those of all files. What no axiom kind can express is left out by name.
/// Annotations are kept if the caller wants them.
///
/// With several threads, one walks over a large file while the caller's builds. The result is the same.
///
/// After an error the source holds some part of the file, and the caller must drop it. Linear in the file.
[[nodiscard]] std::expected<Document, ReadError> read(std::string_view bytes, owl::FileId file, owl::Ontology& source,
                                                      const XmlLimits& limits = {},
                                                      std::vector<owl::Annotation>* annotations = nullptr,
                                                      unsigned threads = 1);

}  // namespace geminga::owlxml

#endif
