// Conditions of one side on the other (`where`, `for`): expressions over attributes and fields, as in WHERE.md.
#ifndef GEMINGA_DISCOVERY_MATCHING_CONDITIONS_WHERE_HPP
#define GEMINGA_DISCOVERY_MATCHING_CONDITIONS_WHERE_HPP

#include <cstddef>
#include <cstdint>
#include <expected>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "discovery/matching/conditions/stated.hpp"
#include "geminga/error.hpp"
#include "reasoning/vocabulary/units.hpp"

namespace geminga::matching {

/// The longest expression; a longer one is refused with 413.
inline constexpr std::size_t max_where_octets = 4096;
/// How deep parentheses and `not` may nest. Deeper nesting is refused with 422, so that reading needs little stack.
inline constexpr std::size_t max_where_depth = 32;
/// How many keys misses() names.
inline constexpr std::size_t max_missed_keys = 8;

/// A parsed expression. A value: copies and moves. Thousands may come from the air, so it takes at most about nine
/// octets for each octet of its text.
class Where {
 public:
  /// Accepts everything.
  Where() = default;
  /// Reads an expression. The empty one accepts everything. `declared` are the units that are known beside the table of
  /// WHERE.md. The error names the octet, counted from 1. O(length).
  [[nodiscard]] static std::expected<Where, Error> parse(std::string_view expression,
                                                         const vocabulary::Units& declared = {});
  /// The error of parse(), with the unit that may have been meant; nothing where the expression can be read. Looks at
  /// all declared units.
  [[nodiscard]] static std::optional<Error> problem(std::string_view expression, const vocabulary::Units& declared);
  /// Reads an expression in which any unit may stand. While one of them is unknown, the condition accepts nobody.
  [[nodiscard]] static std::expected<Where, Error> parse_with_any_unit(std::string_view expression);

  /// Whether it accepts everything because nothing is stated.
  [[nodiscard]] bool is_empty() const { return parsed_.nodes.empty(); }
  /// Whether the other side passes. Allocates nothing for attributes. O(length of the expression).
  [[nodiscard]] bool accepts(const Stated& stated, const vocabulary::Units& declared = {}) const {
    return parsed_.nodes.empty() || ((!parsed_.has_declared_unit || unknown_unit(declared).empty()) &&
                                     holds(static_cast<std::uint16_t>(parsed_.nodes.size() - 1), stated, declared));
  }
  /// The values of the keys that keep the other side from passing: "rate is 33, camera is absent". At most
  /// max_missed_keys of them. Empty where it passes.
  [[nodiscard]] std::string misses(const Stated& stated, const vocabulary::Units& declared = {}) const;
  /// The first number with a unit that cannot be converted, or empty.
  [[nodiscard]] std::string_view unknown_unit(const vocabulary::Units& declared) const;

  enum class Operator : std::uint8_t { equal, different, less, at_most, greater, at_least };

  /// How a value is compared: octet by octet, as a number, as a number with a unit, or with a pattern in which each `*`
  /// stands for any octets.
  enum class Wanted : std::uint8_t { text, number, quantity, pattern };

  /// A part of Parsed::texts.
  struct Slice {
    std::uint16_t at = 0;
    std::uint16_t size = 0;
  };
  static_assert(max_where_octets <= UINT16_MAX);

  /// A node of the expression. The nodes of its operands stand before it: the last operand right before it, each other
  /// operand right before the first node of the next one.
  struct Node {
    enum class Kind : std::uint8_t { all_of, any_of, negation, has, comparison } kind = Kind::has;
    Operator operation = Operator::equal;
    Wanted wanted = Wanted::text;  ///< comparison; a pattern is compared with equal and different only
    std::uint16_t first = 0;       ///< the first node of its first operand; its own place where it has none
    std::uint16_t operands = 0;    ///< all_of, any_of: two or more; negation: one
    Slice key{};                   ///< has, comparison
    Slice value{};                 ///< comparison
  };

  /// An expression as the parser gives it.
  struct Parsed {
    std::vector<Node> nodes;         ///< the root is the last
    std::string texts;               ///< keys and values, without escapes
    bool has_declared_unit = false;  ///< a unit is not in the table: only the ontology can tell what it means
  };

 private:
  explicit Where(Parsed parsed) : parsed_(std::move(parsed)) {}
  [[nodiscard]] std::string_view text(Slice slice) const {
    return std::string_view(parsed_.texts).substr(slice.at, slice.size);
  }
  [[nodiscard]] std::vector<std::uint16_t> operands(std::uint16_t number) const;
  [[nodiscard]] bool holds(std::uint16_t number, const Stated& stated, const vocabulary::Units& declared) const;
  [[nodiscard]] bool leaf_holds(const Node& node, const Stated& stated, const vocabulary::Units& declared) const;
  /// Collects the leaves that decide whether this node holds, each key once, in the order of the text.
  void blame(std::uint16_t number, const Stated& stated, const vocabulary::Units& declared,
             std::vector<const Node*>& leaves) const;
  [[nodiscard]] std::string said(const Node& leaf, const Stated& stated, const vocabulary::Units& declared) const;
  [[nodiscard]] static std::expected<Where, Error> read(std::string_view expression, const vocabulary::Units* declared,
                                                        bool suggests = false);

  Parsed parsed_;  ///< no nodes: accepts everything
};

/// The error of an expression, with its octet, to refuse it with 422. `key` is the key of the statement: where or for.
[[nodiscard]] std::optional<Error> check_where(std::string_view expression, std::string_view key = "where",
                                               const vocabulary::Units& declared = {});

/// The error of an expression that could be read with another unit: "expected ... or a unit that is known at octet 9:
/// did you mean pitch?". Empty where the unit is not the error.
[[nodiscard]] std::string unit_problem(std::string_view expression, const vocabulary::Units& declared);

}  // namespace geminga::matching

#endif
