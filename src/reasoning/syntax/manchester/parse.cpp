// Parses a whole text.
#include "reasoning/syntax/manchester/parse.hpp"

#include <utility>

#include "base/text.hpp"
#include "reasoning/syntax/manchester/text_parser.hpp"
#include "reasoning/syntax/manchester/tokenizer.hpp"

namespace geminga::manchester {
namespace {

/// The parser for an expression over a loaded ontology, which resolves the names.
class ExpressionParser final : public TextParser {
 public:
  ExpressionParser(std::string_view text, const owl::Names& names, const ExpressionLimits& limits,
                   owl::Ontology& source)
      : TextParser(text, limits, source), names_(names) {}

 private:
  std::expected<std::string, std::string> iri_of(owl::TermKind kind, const Token& token) override {
    return names_.find(kind, token.kind == TokenKind::label ? std::string_view(token.value) : token.text);
  }
  std::expected<owl::TermKind, std::string> kind_of_property(const Token& token) override {
    const bool is_object = names_.find(owl::TermKind::object_property, token.text).has_value();
    const bool is_data = names_.find(owl::TermKind::data_property, token.text).has_value();
    if (is_object && is_data)
      return std::unexpected("'" + base::printable(token.text) +
                             "' is an object property and a data property: say which by its IRI");
    return is_data ? owl::TermKind::data_property : owl::TermKind::object_property;
  }
  Term literal_of(const Token& text, std::string_view datatype, std::string_view language) override {
    const Term made = source_.literal(text.value, datatype, language);
    if (source_.is_well_typed(made)) return made;
    return fail(ParseError::Kind::malformed, text.begin, "a literal that is not of its datatype");
  }

  const owl::Names& names_;
};

}  // namespace

std::expected<Expression, ParseError> parse(std::string_view text, const owl::Names& names,
                                            const ExpressionLimits& limits) {
  if (auto error = error_of_octets(text, limits)) return std::unexpected(std::move(*error));
  Expression expression;
  ExpressionParser parser(text, names, limits, expression.source);
  expression.term = parser.read();
  if (parser.problem()) return std::unexpected(parser.error());
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
