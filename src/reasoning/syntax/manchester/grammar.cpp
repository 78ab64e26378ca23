// The grammar of class expressions where no ontology says what the names mean.
#include <optional>
#include <utility>

#include "reasoning/syntax/manchester/parse.hpp"
#include "reasoning/syntax/manchester/text_parser.hpp"
#include "reasoning/syntax/manchester/tokenizer.hpp"

namespace geminga::manchester {
namespace {

bool begins_cardinality(const Token& token) {
  return token.text == "min" || token.text == "max" || token.text == "exactly";
}

/// The parser that takes every name for what stands at its place.
class GrammarParser final : public TextParser {
 public:
  using TextParser::TextParser;

 private:
  std::expected<std::string, std::string> iri_of(owl::TermKind /*kind*/, const Token& token) override {
    return std::string(token.text);
  }
  std::expected<owl::TermKind, std::string> kind_of_property(const Token& /*token*/) override {
    return has_data_next() ? owl::TermKind::data_property : owl::TermKind::object_property;
  }
  Term literal_of(const Token& text, std::string_view datatype, std::string_view language) override {
    return source_.literal(text.value, datatype, language);
  }

  /// Whether the filler of the restriction whose word comes next can only be a data range or a literal. It is one if it
  /// has a literal or a facet before any restriction within it.
  [[nodiscard]] bool has_data_next() const {
    Tokenizer ahead = tokens_;
    const bool has_count = begins_cardinality(ahead.token());
    ahead.advance();
    if (has_count) ahead.advance();
    for (std::size_t depth = 0;; ahead.advance()) {
      const Token& token = ahead.token();
      if (token.kind == TokenKind::string || token.kind == TokenKind::number || token.text == "[") return true;
      if (token.kind == TokenKind::keyword) {
        if (token.text == "true" || token.text == "false") return true;
        if (token.text != "not" && token.text != "and" && token.text != "or") return false;
      }
      if (token.kind == TokenKind::end || token.kind == TokenKind::bad) return false;
      if (token.text == "(" || token.text == "{") ++depth;
      if (token.text == ")" || token.text == "}") {
        if (depth < 2) return false;
        --depth;
      }
      const bool is_name = token.kind == TokenKind::name || token.kind == TokenKind::label;
      if (depth == 0 && is_name) return followed_by_facets(ahead);
    }
  }
  /// Whether a facet follows the name at hand.
  [[nodiscard]] static bool followed_by_facets(Tokenizer ahead) {
    ahead.advance();
    return ahead.token().text == "[";
  }
};

}  // namespace

std::optional<ParseError> check_grammar(std::string_view text, const ExpressionLimits& limits) {
  if (auto error = error_of_octets(text, limits)) return error;
  owl::Ontology source;
  GrammarParser parser(text, limits, source);
  parser.read();
  return parser.problem() ? std::optional(parser.error()) : std::nullopt;
}

}  // namespace geminga::manchester
