// What shapes assert, and the rules for R Self and for functional properties; the legend is in saturation.hpp, X stands
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
        process_functional_self(context, shape.role);
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

void ExpressionOverlay::process_self(std::uint32_t context, el::RoleId role) {
  //  X < R Self
  //  ---------- [R <* S, S Self occurs negatively]
  //  X < S Self
  for (const el::RoleId super : index_.roles().supers(role)) {
    const el::ExprId negative = index_.negative_self(super);
    if (negative != el::bottom_expr) add_subsumer(context, negative);
  }

  //  X < R Self    X < R Self
  //  ----------    ---------- [E is the range of R]
  //  X -R-> X      X < E
  add_link(context, role, context);
  for (const el::RoleId super : index_.roles().supers(role)) process_functional_self(context, super);
  if (index_.range_of(role) != el::top_expr) add_atom(context, index_.representative(index_.range_of(role)));

  //  X < R Self   X < S Self
  //  ----------------------- [R o S SubPropertyOf R']
  //  X < R' Self
  const auto compose_selfs = [&](el::RoleId first, el::RoleId second) {
    for (const el::Composition& rule : index_.roles().compositions(first)) {
      if (rule.second == second) add_self(context, rule.result);
    }
  };
  const std::uint32_t done = own(context).selfs_done;
  for (std::uint32_t at = 0; at < done; ++at) {
    const el::RoleId other = own(context).selfs[at];
    compose_selfs(role, other);
    if (other != role) compose_selfs(other, role);
  }
}

void ExpressionOverlay::process_functional(std::uint32_t context, el::Link link) {
  if (!index_.may_be_functional(link.role) && own(context).functional.empty()) return;
  for (const el::RoleId super : index_.roles().supers(link.role)) {
    const auto holds_here = [&](el::ExprId id) { return own(context).subsumers.contains(number(id)); };
    const bool is_local = std::ranges::find(own(context).functional, super) != own(context).functional.end();
    if (is_local || index_.is_functional(super) || std::ranges::any_of(index_.functional_in(super), holds_here)) {
      group_successor(context, super, link);
      process_functional_self(context, super);
    }
  }
}

//  X -R1-> D1   X -R2-> D2
//  ------------------------------------- [S is functional in X, R1 <* S, R2 <* S]
//  X -R1-> D1 and D2   X -R2-> D1 and D2
void ExpressionOverlay::group_successor(std::uint32_t context, el::RoleId functional, el::Link link) {
  if (!index_.roles().is_sub_role(link.role, functional)) return;
  std::vector<el::FunctionalGroup>& groups = own(context).groups;
  auto group = std::ranges::find(groups, functional, &el::FunctionalGroup::functional);
  if (group == groups.end()) {
    groups.push_back({functional, link.context, {link.role}});
    return;
  }
  const bool is_new_role = std::ranges::find(group->roles, link.role) == group->roles.end();
  if (is_new_role) group->roles.push_back(link.role);
  const auto at = static_cast<std::size_t>(group - groups.begin());
  const std::vector<el::RoleId> roles = group->roles;
  Seeds together = seeds_of(group->successor);
  const std::size_t known = together.size();
  for (const std::uint32_t seed : seeds_of(link.context)) together.push_back(seed);
  std::ranges::sort(together);
  together.erase(std::unique(together.begin(), together.end()), together.end());
  if (together.size() == known && !is_new_role) return;
  const std::uint32_t successor = context_of(std::move(together));
  own(context).groups[at].successor = successor;
  for (const el::RoleId role : roles) add_link(context, role, successor);
}

//  X < R Self   X -R'-> D
//  ---------------------- [S is functional in X, R <* S, R' <* S]
//  X < D
void ExpressionOverlay::process_functional_self(std::uint32_t context, el::RoleId functional) {
  const OverlayContext& self = own(context);
  const bool has_self =
      std::ranges::any_of(self.selfs, [&](el::RoleId role) { return index_.roles().is_sub_role(role, functional); });
  const auto group = std::ranges::find(self.groups, functional, &el::FunctionalGroup::functional);
  if (!has_self || group == self.groups.end()) return;
  const Seeds seeds = seeds_of(group->successor);
  for (const std::uint32_t seed : seeds) {
    if (seed < size_) {
      add_atom(context, el::ExprId{seed});
    } else {
      assert_shape(context, seed - size_);
    }
  }
}

}  // namespace geminga::placement
