// The grammar of class expressions, one function a production. Derived classes resolve names.
#ifndef GEMINGA_REASONING_SYNTAX_MANCHESTER_PARSER_HPP
#define GEMINGA_REASONING_SYNTAX_MANCHESTER_PARSER_HPP

#include <cstddef>
#include <expected>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "reasoning/owl/source.hpp"
#include "reasoning/syntax/manchester/error.hpp"
#include "reasoning/syntax/manchester/limits.hpp"
#include "reasoning/syntax/manchester/tokenizer.hpp"

namespace geminga::manchester {

/// An error, and its octet in the text.
struct Problem {
  ParseError::Kind kind = ParseError::Kind::malformed;
  std::size_t octet = 0;
  std::string text;
};

/// Reads a text into a source. Derived classes say what names mean. After the first problem nothing more is read, and
/// each function returns owl:Thing.
class Parser {
 public:
  Parser(Tokenizer tokens, const ExpressionLimits& limits, owl::Ontology& source)
      : tokens_(std::move(tokens)), limits_(limits), source_(source) {}
  Parser(const Parser&) = delete;
  Parser& operator=(const Parser&) = delete;
  virtual ~Parser() = default;

  [[nodiscard]] const std::optional<Problem>& problem() const { return problem_; }

 protected:
  using Term = owl::TermId;

  Term description();
  Term conjunction();
  Term primary();
  Term negation();
  Term enumeration();
  Term restriction();
  Term cardinality(Term property, bool is_data);
  virtual Term individual();

  // Data (parser_data.cpp).
  Term data_range();
  Term data_conjunction();
  Term data_primary();
  Term datatype_restriction(Term datatype);
  Term facet();
  Term literal();
  Term number();

  // Names.
  Term property();
  Term entity(owl::TermKind kind, const Token& token);
  /// The IRI of an entity, or why there is none.
  [[nodiscard]] virtual std::expected<std::string, std::string> iri_of(owl::TermKind kind, const Token& token) = 0;
  /// Whether the property that was just read is an object or a data property, or why it is neither.
  [[nodiscard]] virtual std::expected<owl::TermKind, std::string> kind_of_property(const Token& token) = 0;
  /// A literal with a datatype, a language, or neither.
  virtual Term literal_of(const Token& text, std::string_view datatype, std::string_view language) = 0;
  [[nodiscard]] bool is_restriction_next() const;

  /// Something that OWL 2 does not allow and that has a meaning.
  virtual void remark(std::string_view /*text*/) {}

  // Tokens.
  [[nodiscard]] bool is(TokenKind kind, std::string_view text) const;
  [[nodiscard]] bool is_keyword(std::string_view word) const { return is(TokenKind::keyword, word); }
  [[nodiscard]] bool is_symbol(std::string_view symbol) const { return is(TokenKind::symbol, symbol); }
  [[nodiscard]] bool is_name() const;
  [[nodiscard]] bool is_literal() const;
  [[nodiscard]] bool has_filler() const;
  bool take_keyword(std::string_view word);
  bool take_symbol(std::string_view symbol);
  void expect_symbol(std::string_view symbol, std::string_view expected);
  Token take();
  Term expected(std::string_view what);
  Term fail(ParseError::Kind kind, std::size_t octet, std::string text);
  [[nodiscard]] bool failed() const { return problem_.has_value(); }
  /// Counts one part, and descends one level while it lives.
  class Level;

  Tokenizer tokens_;
  const ExpressionLimits& limits_;
  owl::Ontology& source_;
  std::size_t depth_ = 0;
  std::size_t parts_ = 0;
  std::optional<Problem> problem_;
};

/// One level of nesting.
class Parser::Level {
 public:
  explicit Level(Parser& parser);
  ~Level() { --parser_.depth_; }
  Level(const Level&) = delete;
  Level& operator=(const Level&) = delete;

 private:
  Parser& parser_;
};

}  // namespace geminga::manchester

#endif
