// The text of a query: what of it is quoted, and the parts that rasqal reads and does not give out.
#ifndef GEMINGA_REASONING_SYNTAX_GRAPH_QUERY_TEXT_HPP
#define GEMINGA_REASONING_SYNTAX_GRAPH_QUERY_TEXT_HPP

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reasoning/syntax/graph/graph.hpp"

namespace geminga::graph {

/// The query with blanks in the place of each text, comment and IRI. As long as the query.
[[nodiscard]] std::string masked(std::string_view query);

/// The characters between words of a query.
inline constexpr std::string_view space = " \t\r\n";

/// Whether a keyword, in small letters, stands here in a mask in small letters.
[[nodiscard]] bool is_keyword(std::string_view mask, std::size_t at, std::string_view keyword);
/// The place of the brace that closes the one that stands here, or the end.
[[nodiscard]] std::size_t closing(std::string_view mask, std::size_t open);

/// The query with those prefixes that it does not declare itself, on its first line, so that the lines in errors stay
/// right; behind BASE, if it begins with that.
[[nodiscard]] std::string with_prefixes(const std::string& query, const Prefixes& prefixes);

/// The query with a blank behind each + and - between two operands: rasqal reads `3-1` and `?a -1` as sums, and `1+1*2`
/// as four.
[[nodiscard]] std::string with_spaced_signs(const std::string& query);

/// The query with `COALESCE(LITERAL, RAND())` for each literal of an expression: rasqal works out what is made of
/// constants while it reads, in 32 bits, and takes 2147483647 + 1 for a negative number, but never what has RAND.
[[nodiscard]] std::string with_opaque_constants(const std::string& query);

/// How deep the braces, or other brackets, of a masked query nest.
[[nodiscard]] std::size_t levels_of(std::string_view mask, std::string_view opening = "{",
                                    std::string_view closing = "}");

/// Whether the query is DESCRIBE *, over which rasqal complains on standard error.
[[nodiscard]] bool describes_all(const std::string& query);
/// The part of a query before its verb: its own prefixes and base.
[[nodiscard]] std::string prologue_of(const std::string& query);

/// The values of VALUES as they are written. Nothing for UNDEF.
struct WrittenValues {
  std::vector<std::string> variables;  ///< without ? or $
  std::vector<std::vector<std::optional<std::string>>> rows;
};

/// The queries within a query, and its blocks of values, each in the order of the text. Those of inner queries belong
/// to them.
struct InnerTexts {
  std::vector<std::string> queries;
  std::vector<WrittenValues> values;
  std::optional<WrittenValues> last;  ///< VALUES behind the pattern
};
/// Requires a query that rasqal can read. Nothing if a block of values is not understood.
[[nodiscard]] std::optional<InnerTexts> inner_texts(const std::string& query);

}  // namespace geminga::graph

#endif
