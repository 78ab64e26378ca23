// The `where` filter of a subscription: a small expression over a publication's attributes and fields (WHERE.md).
#ifndef GEMINGA_MATCHING_WHERE_HPP
#define GEMINGA_MATCHING_WHERE_HPP

#include <cstddef>
#include <cstdint>
#include <expected>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geminga/error.hpp"
#include "registry/entry.hpp"

namespace geminga::matching {

/// The longest expression; a longer one is refused with 413.
inline constexpr std::size_t max_where_octets = 4096;
/// How deep parentheses and `not` may nest; deeper is refused with 422, so that reading needs little stack.
inline constexpr std::size_t max_where_depth = 32;

/// A parsed expression. A value: copies and moves.
class Where {
 public:
  /// Reads an expression; the empty one accepts everything. The error names the octet, counted from 1. O(length).
  [[nodiscard]] static std::expected<Where, Error> parse(std::string_view expression);

  /// Whether the publication passes. Allocates only for fields that are not texts. O(length of the expression).
  [[nodiscard]] bool accepts(const registry::PublicationEntry& publication) const;

  enum class Operator : std::uint8_t { equal, different, less, at_most, greater, at_least };

  /// What a comparison compares with: a text, and a number where it was written as one.
  struct Literal {
    std::string text;
    bool is_number = false;
  };

  /// One node; children are named by their place in `nodes_`, always before their parent.
  struct Node {
    enum class Kind : std::uint8_t { all_of, any_of, negation, has, comparison } kind = Kind::has;
    std::vector<std::uint32_t> children;  ///< all_of, any_of: two or more; negation: one
    std::string key;                      ///< has, comparison
    Operator operation = Operator::equal;
    Literal literal;
  };

 private:
  explicit Where(std::vector<Node> nodes) : nodes_(std::move(nodes)) {}
  [[nodiscard]] bool holds(std::uint32_t number, const registry::PublicationEntry& publication) const;

  std::vector<Node> nodes_;  ///< the root is the last; empty: accepts everything
};

/// Reads a `where` expression and says what is wrong with it at which octet; used to refuse a bad one with 422.
[[nodiscard]] std::optional<Error> check_where(std::string_view expression);

}  // namespace geminga::matching

#endif
