// The whole of one text.
#include "manchester/parse.hpp"

#include "base/text.hpp"
#include "manchester/parser.hpp"
#include "manchester/tokenizer.hpp"

namespace geminga::manchester {

std::expected<Expression, ParseError> parse(std::string_view text, const Names& names, const Limits& limits) {
  if (text.size() > limits.text_bytes) {
    return std::unexpected(
        ParseError{ParseError::Kind::too_large, 1, "more than " + std::to_string(limits.text_bytes) + " octets"});
  }
  if (!base::is_valid_utf8(text)) return std::unexpected(ParseError{ParseError::Kind::malformed, 1, "no UTF-8"});
  Expression expression;
  Parser parser(text, names, limits, expression.source);
  expression.term = parser.read();
  if (parser.problem()) return std::unexpected(*parser.problem());
  if (expression.source.problem()) {
    return std::unexpected(ParseError{ParseError::Kind::too_large, 1, *expression.source.problem()});
  }
  return expression;
}

bool is_compound(std::string_view text) {
  if (!base::is_valid_utf8(text)) return false;
  Tokenizer tokens(text);
  for (; tokens.token().kind != TokenKind::end; tokens.advance()) {
    const TokenKind kind = tokens.token().kind;
    if (kind == TokenKind::keyword || kind == TokenKind::symbol || kind == TokenKind::label) return true;
    if (kind == TokenKind::bad) return false;
  }
  return false;
}

}  // namespace geminga::manchester
