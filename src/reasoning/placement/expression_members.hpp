// The contexts that are below an expression, found by evaluating its structure from the inside outwards.
//
// A saturated base is a canonical model: a context is below an EL expression exactly if it is an instance of it there.
// The rules are Horn, so that a context is below a union exactly if it is below one of the parts (Baader, Brandt, Lutz
// 2005).
#ifndef GEMINGA_REASONING_PLACEMENT_EXPRESSION_MEMBERS_HPP
#define GEMINGA_REASONING_PLACEMENT_EXPRESSION_MEMBERS_HPP

#include <cstdint>
#include <map>
#include <vector>

#include "reasoning/placement/expression_overlay.hpp"
#include "reasoning/placement/expression_shape.hpp"

namespace geminga::placement {

/// Contexts of a base and of an overlay that are saturated, ascending.
using Contexts = std::vector<std::uint32_t>;

class ExpressionMembers {
 public:
  enum class Wanted : std::uint8_t {
    every_context,
    named_classes,  ///< contexts_of() may leave out contexts of no named class
  };
  /// Notes gaps in `shapes`.
  ExpressionMembers(const ExpressionOverlay& overlay, ShapeReader& shapes, Wanted wanted)
      : overlay_(overlay), base_(overlay.base()), shapes_(shapes), wanted_(wanted) {}

  [[nodiscard]] const Contexts& contexts_of(ShapeId shape);

 private:
  [[nodiscard]] Contexts find(ShapeId shape);
  [[nodiscard]] Contexts all() const;
  [[nodiscard]] Contexts below_atom(el::ExprId atom);
  [[nodiscard]] Contexts in_all(const Shape& shape);
  [[nodiscard]] Contexts in_some(const Shape& shape);
  [[nodiscard]] Contexts in_only(const Shape& shape);
  [[nodiscard]] Contexts with_self(const Shape& shape);
  /// The candidates that are disjoint from a shape.
  [[nodiscard]] Contexts disjoint_from(ShapeId shape, const Contexts& candidates);
  [[nodiscard]] Contexts to_be_tested(const Contexts& candidates) const;
  void add_unsatisfiable(Contexts& contexts) const;

  const ExpressionOverlay& overlay_;
  const ExpressionBase& base_;
  ShapeReader& shapes_;
  std::map<ShapeId, Contexts> known_;
  std::vector<std::vector<el::ExprId>> atoms_above_;  ///< by context of the overlay
  Wanted wanted_;
  bool is_inside_some_ = false;
};

}  // namespace geminga::placement

#endif
