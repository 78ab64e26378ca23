// Reads conditions by recursive descent, one function for each line of the grammar in WHERE.md.
#ifndef GEMINGA_DISCOVERY_MATCHING_CONDITIONS_WHERE_PARSER_HPP
#define GEMINGA_DISCOVERY_MATCHING_CONDITIONS_WHERE_PARSER_HPP

#include <cstddef>
#include <cstdint>
#include <expected>
#include <optional>
#include <string>
#include <string_view>

#include "discovery/matching/conditions/where.hpp"
#include "geminga/error.hpp"

namespace geminga::matching {

/// The beginning of every error of the reader.
inline constexpr std::string_view parse_error_prefix = "where: ";

class WhereParser {
 public:
  /// Borrows the expression and the units that are known beside the table. Where `declared` is null, any unit is
  /// accepted. `suggests`: an error names the unit that may have been meant. Requires at most max_where_octets of the
  /// expression.
  WhereParser(std::string_view expression, const vocabulary::Units* declared, bool suggests = false)
      : text_(expression), declared_(declared), suggests_(suggests) {}

  [[nodiscard]] std::expected<Where::Parsed, Error> parse();

 private:
  using Result = std::expected<void, Error>;  ///< without error, the last node is the one that was read

  /// The right side of a comparison.
  struct Literal {
    Where::Slice text;
    Where::Wanted wanted = Where::Wanted::text;
  };

  Result any_of(std::size_t depth);
  Result all_of(std::size_t depth);
  Result unary(std::size_t depth);
  Result has();
  Result comparison();
  /// `in`, `not in` or `like`, with the values behind it; nothing where none of them stands here.
  std::optional<Result> set_or_pattern(Where::Slice key);
  /// `(` value `,` value `)`: a comparison with each value, one of which holds; where `is_none_of`, none of which does.
  Result set(Where::Slice key, bool is_none_of);
  Result compare(Where::Slice key, Where::Operator operation, const Literal& value);
  /// One or more operands joined by a word or its sign.
  Result chain(Where::Node::Kind kind, std::string_view word, std::string_view sign, std::size_t depth);

  std::expected<Where::Slice, Error> key(std::string_view wanted);
  std::expected<Where::Operator, Error> operation();
  /// `is_ordered`: the comparison asks for less or greater.
  std::expected<Literal, Error> literal(bool is_ordered = false);
  std::expected<Literal, Error> quoted();
  /// A number, perhaps with blanks and a unit behind it. `digits` is the number.
  std::expected<Literal, Error> numeric(std::string_view digits);

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

  /// The run of octets that may be a unit at the current place, not consumed.
  [[nodiscard]] std::string_view unit_word() const;
  [[nodiscard]] std::unexpected<Error> wrong_unit(std::string_view sign) const;

  std::string_view text_;
  const vocabulary::Units* declared_;
  bool suggests_;
  std::size_t at_ = 0;
  Where::Parsed parsed_;
};

}  // namespace geminga::matching

#endif
