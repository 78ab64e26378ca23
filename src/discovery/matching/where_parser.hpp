// Reads `where` expressions by recursive descent, one function a line of the grammar in WHERE.md.
#ifndef GEMINGA_DISCOVERY_MATCHING_WHERE_PARSER_HPP
#define GEMINGA_DISCOVERY_MATCHING_WHERE_PARSER_HPP

#include <cstddef>
#include <cstdint>
#include <expected>
#include <string>
#include <string_view>

#include "discovery/matching/where.hpp"
#include "geminga/error.hpp"

namespace geminga::matching {

class WhereParser {
 public:
  /// Borrows the expression. Requires at most max_where_octets of it.
  explicit WhereParser(std::string_view expression) : text_(expression) {}

  [[nodiscard]] std::expected<Where::Parsed, Error> parse();

 private:
  using Result = std::expected<void, Error>;  ///< its node is the last one then

  /// What a comparison compares with: a text, and a number where it was written as one.
  struct Literal {
    Where::Slice text;
    bool is_number = false;
  };

  Result any_of(std::size_t depth);
  Result all_of(std::size_t depth);
  Result unary(std::size_t depth);
  Result has();
  Result comparison();
  /// One or more operands joined by a word or its sign.
  Result chain(Where::Node::Kind kind, std::string_view word, std::string_view sign, std::size_t depth);

  std::expected<Where::Slice, Error> key(std::string_view wanted);
  std::expected<Where::Operator, Error> operation();
  std::expected<Literal, Error> literal();
  std::expected<Literal, Error> quoted();

  /// Adds a node whose operands are the nodes from `first` on.
  Result add(Where::Node node, std::size_t first);
  Where::Slice keep(std::string_view text);
  void skip_blanks();
  /// The run of word octets at the current place, not consumed.
  [[nodiscard]] std::string_view word() const;
  [[nodiscard]] bool take_word(std::string_view wanted);
  [[nodiscard]] bool take_sign(std::string_view wanted);
  [[nodiscard]] std::unexpected<Error> wrong(std::string_view what) const { return wrong(what, at_); }
  [[nodiscard]] std::unexpected<Error> wrong(std::string_view what, std::size_t at) const;

  std::string_view text_;
  std::size_t at_ = 0;
  Where::Parsed parsed_;
};

/// Whether the text is a number as WHERE.md defines it: decimal, finite, perhaps with sign, fraction and exponent.
[[nodiscard]] bool is_number(std::string_view text);

}  // namespace geminga::matching

#endif
