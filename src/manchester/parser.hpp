// The productions of the grammar, one function each.
#ifndef GEMINGA_MANCHESTER_PARSER_HPP
#define GEMINGA_MANCHESTER_PARSER_HPP

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "el/source.hpp"
#include "manchester/error.hpp"
#include "manchester/limits.hpp"
#include "manchester/names.hpp"
#include "manchester/tokenizer.hpp"

namespace geminga::manchester {

/// Reads one text into a source. The first problem ends everything: from then on each function gives owl:Thing.
class Parser {
 public:
  Parser(std::string_view text, const Names& names, const Limits& limits, el::OntologySource& source)
      : tokens_(text), names_(names), limits_(limits), source_(source) {}

  /// description, then the end of the text.
  [[nodiscard]] el::TermId read();
  [[nodiscard]] const std::optional<ParseError>& problem() const { return problem_; }

 private:
  using Term = el::TermId;

  Term description();
  Term conjunction();
  Term primary();
  Term negation();
  Term enumeration();
  Term restriction();
  Term object_restriction(Term property);
  Term cardinality(Term property, bool is_data);
  Term individual();

  // Data (parser_data.cpp).
  Term data_restriction(Term property);
  Term data_range();
  Term data_conjunction();
  Term data_primary();
  Term datatype_restriction(Term datatype);
  Term facet();
  Term literal();
  Term number();

  // Names.
  Term property();
  Term entity(el::TermKind kind, const Token& token);
  [[nodiscard]] bool is_restriction_next() const;

  // Tokens.
  [[nodiscard]] bool is(TokenKind kind, std::string_view text) const;
  [[nodiscard]] bool is_keyword(std::string_view word) const { return is(TokenKind::keyword, word); }
  [[nodiscard]] bool is_symbol(std::string_view symbol) const { return is(TokenKind::symbol, symbol); }
  [[nodiscard]] bool is_name() const;
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
  const Names& names_;
  const Limits& limits_;
  el::OntologySource& source_;
  std::size_t depth_ = 0;
  std::size_t parts_ = 0;
  std::optional<ParseError> problem_;
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
