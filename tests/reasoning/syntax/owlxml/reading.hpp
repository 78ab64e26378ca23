// The fixture of this folder: a text read as OWL/XML, its axioms written in functional syntax.
#ifndef GEMINGA_TESTS_REASONING_SYNTAX_OWLXML_READING_HPP
#define GEMINGA_TESTS_REASONING_SYNTAX_OWLXML_READING_HPP

#include <string>
#include <string_view>
#include <vector>

#include "reasoning/syntax/owlxml/read.hpp"

namespace geminga::owlxml {

/// The result of reading one text.
struct Reading {
  owl::Ontology source;
  Document document;
  std::string error;  ///< "t.owx:3: what is wrong"; empty: it was read

  explicit Reading(std::string_view text, const XmlLimits& limits = {}, unsigned threads = 1);

  /// Axioms as the writer of tests/reasoning/syntax/rdf writes them, declarations included; then "left out: CONSTRUCT,
  /// COUNT, line N".
  [[nodiscard]] std::vector<std::string> axioms() const;
  /// "TEXT, COUNT, line N".
  [[nodiscard]] std::vector<std::string> remarks() const;
  /// "IRI text" or "IRI text@en".
  [[nodiscard]] std::vector<std::string> labels() const;
};

/// An ontology without a name around some lines, relative to http://e/; the first of them is line 2.
[[nodiscard]] std::string ontology(std::string_view lines);

}  // namespace geminga::owlxml

#endif
