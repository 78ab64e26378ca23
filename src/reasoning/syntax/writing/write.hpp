// Documents in OWL's own syntaxes: functional-style syntax, Manchester syntax, OWL/XML. WRITING.md says what each
// writes.
#ifndef GEMINGA_REASONING_SYNTAX_WRITING_WRITE_HPP
#define GEMINGA_REASONING_SYNTAX_WRITING_WRITE_HPP

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "reasoning/syntax/syntax.hpp"
#include "reasoning/syntax/writing/document.hpp"
#include "reasoning/syntax/writing/output.hpp"

namespace geminga::writing {

struct Written {
  /// Why there is no document, in one line: a name or text that the syntax cannot have, a limit, or the sink.
  std::optional<std::string> problem;
  /// Annotations of declarations, for which Manchester syntax has no place.
  std::size_t unsaid_annotations = 0;
  /// Names that are nothing but the subject of an annotation. In Manchester syntax their frame makes them individuals.
  std::vector<std::string> declared_subjects = {};
  /// Names that are an object property and a data property at once, which OWL 2 DL forbids and Manchester syntax does
  /// not tell apart: their restrictions may be read as those of the other kind.
  std::vector<std::string> ambiguous_properties = {};
};

/// Writes a document piece by piece. The syntax must be one without triples.
[[nodiscard]] Written write(const Document& document, syntax::Syntax syntax, const Sink& sink,
                            const WritingLimits& limits = {});

}  // namespace geminga::writing

#endif
