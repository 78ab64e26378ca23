// The fixture of this folder: an ontology is written in one of OWL's own syntaxes and read again.
#ifndef GEMINGA_TESTS_REASONING_SYNTAX_WRITING_READING_AGAIN_HPP
#define GEMINGA_TESTS_REASONING_SYNTAX_WRITING_READING_AGAIN_HPP

#include <string>
#include <string_view>
#include <vector>

#include "reasoning/owl/annotation.hpp"
#include "reasoning/owl/source.hpp"
#include "reasoning/syntax/syntax.hpp"
#include "reasoning/syntax/writing/write.hpp"

namespace geminga::writing {

inline constexpr syntax::Syntax syntaxes[] = {syntax::Syntax::functional, syntax::Syntax::manchester,
                                              syntax::Syntax::owl_xml};

/// An ontology with its annotations, as a reader gives it.
struct Read {
  owl::Ontology source;
  std::vector<owl::Annotation> annotations;
  std::string iri;
  std::string version_iri;
  std::vector<std::string> imports;
  std::string error;  ///< empty: it was read
};

/// Reads a text as one file.
[[nodiscard]] Read read(std::string_view text, syntax::Syntax syntax);
/// The whole of it as a text, or "cannot: " and why not.
[[nodiscard]] std::string written(const Read& ontology, syntax::Syntax syntax, const WritingLimits& limits = {});
/// Axioms without declarations, and annotations with what they are about, each as a line, sorted.
[[nodiscard]] std::vector<std::string> said(const Read& ontology);

}  // namespace geminga::writing

#endif
