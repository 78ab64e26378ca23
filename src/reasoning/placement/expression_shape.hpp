// The shape of a class expression in terms of a base, for the overlay and for the search of members.
//
// Complements stand where they were written or further inside, and two of them cancel. alternatives_of() splits unions:
// unless one is inside a complement or a universal restriction, an expression is the union of its alternatives, which
// have no unions.
#ifndef GEMINGA_REASONING_PLACEMENT_EXPRESSION_SHAPE_HPP
#define GEMINGA_REASONING_PLACEMENT_EXPRESSION_SHAPE_HPP

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "reasoning/placement/expression_base.hpp"

namespace geminga::placement {

enum class ShapeKind : std::uint8_t {
  atom,      ///< a class, individual, literal or data range that the base knows
  all_of,    ///< parts
  any_of,    ///< parts
  some,      ///< role, one part
  only,      ///< role, one part
  self,      ///< role
  at_least,  ///< role, count of 2 and more, one part
  at_most,   ///< role, count, one part
  negation,  ///< one part
  value,     ///< a literal or datatype that the base does not name: above it `atoms`, below it `below`
  opaque,    ///< beyond the rules: known by `atom` alone, if the ontology has the same expression
};

/// Number of a shape in its ShapeReader.
using ShapeId = std::uint32_t;

struct Shape {
  ShapeKind kind = ShapeKind::opaque;
  /// For an atom: itself. For others: the name of the same expression in the ontology, or T if there is none.
  el::ExprId atom = el::top_expr;
  el::RoleId role{};
  std::uint32_t count = 0;
  std::vector<ShapeId> parts{};
  std::vector<el::ExprId> above{};  ///< of a value: datatypes of the base that hold it
  std::vector<el::ExprId> below{};  ///< of a value: literals and datatypes of the base that are in it
};

/// Reads terms of a query's source. gaps() names everything that it could not express exactly.
class ShapeReader {
 public:
  ShapeReader(const ExpressionBase& base, const owl::Ontology& query) : base_(base), query_(query) {}

  /// The shape of a class expression. Its nesting is bounded by that of terms.
  [[nodiscard]] ShapeId read(owl::TermId term);
  /// The shapes without unions whose union the expression is. If there would be more than the limit, the expression
  /// stays as it is, with a gap.
  [[nodiscard]] std::vector<ShapeId> alternatives_of(ShapeId id);

  [[nodiscard]] const Shape& shape(ShapeId id) const { return shapes_[id]; }
  /// True if the shape is or contains a complement.
  [[nodiscard]] bool has_negation(ShapeId id) const;
  [[nodiscard]] std::size_t count() const { return shapes_.size(); }
  void add_gap(std::string_view words) { gaps_.emplace(words); }
  [[nodiscard]] const std::set<std::string, std::less<>>& gaps() const { return gaps_; }

 private:
  struct Property {
    std::optional<el::RoleId> role;  ///< nothing: inverse, top, or not of the ontology
  };
  ShapeId add(Shape shape);
  ShapeId atom(el::ExprId expr);
  ShapeId negated(ShapeId id);
  ShapeId all_of(const std::vector<ShapeId>& parts);
  ShapeId any_of(const std::vector<ShapeId>& parts);
  ShapeId restriction(ShapeKind kind, owl::TermId term, ShapeId part, std::uint32_t count = 0);
  ShapeId at_least(owl::TermId term, std::uint32_t count, ShapeId part);
  ShapeId at_most(owl::TermId term, std::uint32_t count, ShapeId part);
  ShapeId read_restriction(owl::TermId id, const owl::Term& term);
  ShapeId read_literal(owl::TermId id, const owl::Term& term);
  ShapeId read_datatype(owl::TermId id, const owl::Term& term);
  ShapeId read_facets(owl::TermId id, const owl::Term& term);
  ShapeId unknown(owl::TermId id, std::string_view words);
  [[nodiscard]] std::optional<el::RoleId> role_of(owl::TermId property);
  [[nodiscard]] std::optional<owl::TermId> in_base(owl::TermId term) const;
  [[nodiscard]] el::ExprId known_atom(owl::TermId term) const;
  [[nodiscard]] bool is(ShapeId id, el::ExprId expr) const;

  const ExpressionBase& base_;
  const owl::Ontology& query_;
  std::vector<Shape> shapes_;
  std::set<std::string, std::less<>> gaps_;
};

}  // namespace geminga::placement

#endif
