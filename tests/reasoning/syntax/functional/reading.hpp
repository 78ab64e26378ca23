// The fixture of this folder: a text read as an ontology, its axioms written out again.
#ifndef GEMINGA_TESTS_REASONING_SYNTAX_FUNCTIONAL_READING_HPP
#define GEMINGA_TESTS_REASONING_SYNTAX_FUNCTIONAL_READING_HPP

#include <string>
#include <string_view>
#include <vector>

#include "reasoning/syntax/functional/read.hpp"

namespace geminga::functional {

/// The result of reading one text.
struct Reading {
  owl::Ontology source;
  Document document;
  std::string error;  ///< "t.ofn:3: what is wrong"; empty: it was read

  /// Unless told, a wrong axiom refuses the text, so that its error is seen.
  explicit Reading(std::string_view text, const FunctionalLimits& limits = {.wrong_axioms = 0}) {
    const owl::FileId file = source.add_file("t.ofn");
    auto result = read(text, file, source, limits);
    if (result) {
      document = std::move(*result);
    } else {
      error = to_string(result.error());
    }
  }

  /// Axioms as the writer of tests/reasoning/syntax/rdf writes them, declarations included; then "left out: CONSTRUCT,
  /// COUNT, line N".
  [[nodiscard]] std::vector<std::string> axioms() const;
  /// "IRI text" or "IRI text@en".
  [[nodiscard]] std::vector<std::string> labels() const;
};

/// An ontology without a name around some lines, with `:` for http://e/; the first of them is line 2.
[[nodiscard]] inline std::string ontology(std::string_view lines) {
  return "Prefix(:=<http://e/>) Ontology(\n" + std::string(lines) + "\n)\n";
}

}  // namespace geminga::functional

#endif
