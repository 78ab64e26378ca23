// The fixture of this folder: a text read as a document, its axioms written in functional syntax.
#ifndef GEMINGA_TESTS_REASONING_SYNTAX_FRAMES_READING_HPP
#define GEMINGA_TESTS_REASONING_SYNTAX_FRAMES_READING_HPP

#include <string>
#include <string_view>
#include <vector>

#include "reasoning/syntax/frames/read.hpp"

namespace geminga::frames {

/// The result of reading one text.
struct Reading {
  owl::Ontology source;
  Document document;
  std::string error;  ///< "t.omn:3: what is wrong"; empty: it was read

  explicit Reading(std::string_view text, const FrameLimits& limits = {}, Declared declared = {});

  /// Axioms as the writer of tests/reasoning/syntax/rdf writes them, declarations included; then "left out: CONSTRUCT,
  /// COUNT, line N".
  [[nodiscard]] std::vector<std::string> axioms() const;
  /// "IRI text" or "IRI text@en".
  [[nodiscard]] std::vector<std::string> labels() const;
};

/// An ontology without a name around some lines, with `:` for http://e/; the first of them is line 2.
[[nodiscard]] inline std::string ontology(std::string_view lines) {
  return "Prefix: : <http://e/> Ontology:\n" + std::string(lines) + "\n";
}

/// The axioms of these lines but for declarations, or why there are none.
[[nodiscard]] std::vector<std::string> said(std::string_view lines);

}  // namespace geminga::frames

#endif
