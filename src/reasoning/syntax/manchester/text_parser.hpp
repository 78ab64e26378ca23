// The parser of a whole text that is one class expression.
#ifndef GEMINGA_REASONING_SYNTAX_MANCHESTER_TEXT_PARSER_HPP
#define GEMINGA_REASONING_SYNTAX_MANCHESTER_TEXT_PARSER_HPP

#include <optional>
#include <string>
#include <string_view>

#include "base/text.hpp"
#include "reasoning/syntax/manchester/limits.hpp"
#include "reasoning/syntax/manchester/parser.hpp"
#include "reasoning/syntax/manchester/tokenizer.hpp"

namespace geminga::manchester {

/// Reads a text into a source; both outlive it. Derived classes say what names mean.
class TextParser : public Parser {
 public:
  TextParser(std::string_view text, const ExpressionLimits& limits, owl::Ontology& source)
      : Parser(Tokenizer(text), limits, source) {}

  /// description, then the end of the text.
  owl::TermId read() {
    const Term term = description();
    if (tokens_.token().kind != TokenKind::end) return expected("'and', 'or' or the end");
    return term;
  }
  /// Requires a problem.
  [[nodiscard]] ParseError error() const {
    return {problem()->kind, tokens_.column_of(problem()->octet), problem()->text};
  }
};

/// The error of a text that is no UTF-8, or too long.
[[nodiscard]] inline std::optional<ParseError> error_of_octets(std::string_view text, const ExpressionLimits& limits) {
  if (text.size() > limits.text_bytes) {
    return ParseError{ParseError::Kind::too_large, 1, "more than " + std::to_string(limits.text_bytes) + " octets"};
  }
  if (!base::is_valid_utf8(text)) return ParseError{ParseError::Kind::malformed, 1, "no UTF-8"};
  return std::nullopt;
}

}  // namespace geminga::manchester

#endif
