// What shapes assert, reflexive restrictions, and functional properties. The legend is in el/saturation.hpp; X stands
// for a context of the overlay.
#include <algorithm>

#include "reasoning/placement/expression_overlay.hpp"

namespace geminga::placement {

void ExpressionOverlay::assert_shape(std::uint32_t context, ShapeId id) {
  const Shape shape = shapes_.shape(id);
  if (shape.atom != el::top_expr) add_atom(context, shape.atom);
  switch (shape.kind) {
    case ShapeKind::atom:
    case ShapeKind::opaque:
    case ShapeKind::any_of:  // too many alternatives, or inside a universal restriction: not used, and named
      break;
    case ShapeKind::all_of:
      for (const ShapeId part : shape.parts) assert_shape(context, part);
      break;
    case ShapeKind::some:
      add_successor(context, shape.role, shape.parts[0]);
      break;
    case ShapeKind::only: {
      own(context).universals.push_back(id);
      const std::vector<el::Link> links = own(context).forward.items();
      for (const el::Link link : links) apply_universal(context, id, link);
      break;
    }
    case ShapeKind::self:
      add_self(context, shape.role);
      break;
    case ShapeKind::at_least: {
      //  X < at least 2 R C
      //  ------------------ [R is functional]
      //  X < F
      const auto is_functional = [&](el::RoleId role) { return index_.is_functional(role); };
      if (std::ranges::any_of(index_.roles().supers(shape.role), is_functional)) return add_bottom(context);
      add_successor(context, shape.role, shape.parts[0]);
      break;
    }
    case ShapeKind::at_most:
      if (shape.count == 1 && shapes_.shape(shape.parts[0]).atom == index_.representative(el::top_expr) &&
          shapes_.shape(shape.parts[0]).kind == ShapeKind::atom) {
        own(context).functional.push_back(shape.role);
        const std::vector<el::Link> links = own(context).forward.items();
        for (const el::Link link : links) group_successor(context, shape.role, link);
        functional_self(context, shape.role);
      }
      break;
    case ShapeKind::negation:
      own(context).negations.push_back(shape.parts[0]);
      break;
    case ShapeKind::value:
      for (const el::ExprId above : shape.above) add_atom(context, above);
      break;
  }
}

//  X < R some C
//  ------------------ [E is the range of R]
//  X -R-> C and E
void ExpressionOverlay::add_successor(std::uint32_t context, el::RoleId role, ShapeId filler) {
  Seeds seeds;
  add_seed(seeds, filler);
  seeds.push_back(number(index_.representative(index_.range_of(role))));
  add_link(context, role, context_of(std::move(seeds)));
}

void ExpressionOverlay::add_self(std::uint32_t context, el::RoleId role) {
  OverlayContext& self = own(context);
  if (self.is_unsatisfiable || std::ranges::find(self.selfs, role) != self.selfs.end()) return;
  self.selfs.push_back(role);
  ++work_;
  enqueue(context);
}

void ExpressionOverlay::add_loop(std::uint32_t context, el::RoleId role) {
  add_link(context, role, context);
  for (const el::RoleId super : index_.roles().supers(role)) functional_self(context, super);
}

bool ExpressionOverlay::is_functional_in(std::uint32_t context, el::RoleId role) {
  const std::vector<el::RoleId>& by_shape = own(context).functional;
  return std::ranges::find(by_shape, role) != by_shape.end() || Rules::is_functional_in(context, role);
}

}  // namespace geminga::placement
