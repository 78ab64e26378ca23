// One function a kind of shape. Legend as in saturation.hpp; [C] are the contexts below C.
#include "el/expression_members.hpp"

#include <algorithm>
#include <iterator>

namespace geminga::el {
namespace {

void sort_unique(Contexts& contexts) {
  std::ranges::sort(contexts);
  contexts.erase(std::unique(contexts.begin(), contexts.end()), contexts.end());
}

Contexts common(const Contexts& one, const Contexts& other) {
  Contexts both;
  std::ranges::set_intersection(one, other, std::back_inserter(both));
  return both;
}

}  // namespace

const Contexts& ExpressionMembers::of(ShapeId id) {
  const auto known = known_.find(id);
  if (known != known_.end()) return known->second;
  Contexts found = find(id);
  add_unsatisfiable(found);
  sort_unique(found);
  return known_.emplace(id, std::move(found)).first->second;
}

Contexts ExpressionMembers::all() const {
  Contexts contexts(overlay_.context_count());
  for (std::uint32_t at = 0; at < contexts.size(); ++at) contexts[at] = at;
  return contexts;
}

void ExpressionMembers::add_unsatisfiable(Contexts& contexts) const {
  const Contexts& base = base_.unsatisfiable();
  contexts.insert(contexts.end(), base.begin(), base.end());
  for (std::uint32_t at = overlay_.base_count(); at < overlay_.context_count(); ++at) {
    if (overlay_.is_unsatisfiable(at)) contexts.push_back(at);
  }
}

Contexts ExpressionMembers::below_atom(ExprId atom) {
  if (atom == base_.index().representative(top_expr)) return all();
  Contexts found = base_.contexts_below(atom);
  for (std::uint32_t at = overlay_.base_count(); at < overlay_.context_count(); ++at) {
    const std::size_t own = at - overlay_.base_count();
    if (atoms_above_.size() <= own) atoms_above_.push_back(overlay_.atoms_above(at));
    if (std::ranges::binary_search(atoms_above_[own], atom)) found.push_back(at);
  }
  return found;
}

Contexts ExpressionMembers::find(ShapeId id) {
  const Shape shape = shapes_.shape(id);
  Contexts found;
  switch (shape.kind) {
    case ShapeKind::atom:
      return below_atom(shape.atom);
    case ShapeKind::all_of:
      found = in_all(shape);
      break;
    case ShapeKind::any_of:
      for (const ShapeId part : shape.parts) found.insert(found.end(), of(part).begin(), of(part).end());
      break;
    case ShapeKind::some:
      found = in_some(shape);
      break;
    case ShapeKind::only:
      found = in_only(shape);
      break;
    case ShapeKind::self:
      found = with_self(shape);
      break;
    case ShapeKind::at_least:
      shapes_.add_gap("a minimum cardinality in the expression");
      break;
    case ShapeKind::at_most:
      found = in_at_most(shape);
      break;
    case ShapeKind::negation:
      found = disjoint_from(shape.parts[0], all());
      break;
    case ShapeKind::value:
      for (const ExprId below : shape.below) {
        const Contexts part = below_atom(below);
        found.insert(found.end(), part.begin(), part.end());
      }
      break;
    case ShapeKind::opaque:
      break;  // its gap was noted when it was read
  }
  if (shape.atom != top_expr) {
    const Contexts known = below_atom(shape.atom);
    found.insert(found.end(), known.begin(), known.end());
  }
  return found;
}

//  [C and D] = [C] and [D];  complements last, since each of them is tested context by context
Contexts ExpressionMembers::in_all(const Shape& shape) {
  Contexts found;
  bool is_first = true;
  for (const ShapeId part : shape.parts) {
    if (shapes_.shape(part).kind == ShapeKind::negation) continue;
    found = is_first ? of(part) : common(found, of(part));
    is_first = false;
  }
  if (is_first) found = all();
  for (const ShapeId part : shape.parts) {
    if (shapes_.shape(part).kind == ShapeKind::negation) found = disjoint_from(shapes_.shape(part).parts[0], found);
  }
  return found;
}

//  [R some C] = those with a link of a sub-role of R to one of [C]
Contexts ExpressionMembers::in_some(const Shape& shape) {
  const bool was_inside = is_inside_some_;
  is_inside_some_ = true;
  const Contexts& filler = of(shape.parts[0]);
  is_inside_some_ = was_inside;
  const Roles& roles = base_.index().roles();
  Contexts found;
  for (const std::uint32_t target : filler) {
    if (target >= overlay_.base_count()) break;
    for (const Link link : base_.context(target).backward.items()) {
      if (roles.is_sub_role(link.role, shape.role)) found.push_back(link.context);
    }
  }
  for (std::uint32_t at = overlay_.base_count(); at < overlay_.context_count(); ++at) {
    const auto& links = overlay_.own()[at - overlay_.base_count()].forward.items();
    const bool is_in = std::ranges::any_of(links, [&](const Link& link) {
      return roles.is_sub_role(link.role, shape.role) && std::ranges::binary_search(filler, link.context);
    });
    if (is_in) found.push_back(at);
  }
  return found;
}

//  all are in R only C where C is above the range of R; what else is in it the rules cannot tell
Contexts ExpressionMembers::in_only(const Shape& shape) {
  const ExprId range = base_.index().representative(base_.index().range_of(shape.role));
  const Context* context = base_.find(range);
  if (context != nullptr && std::ranges::binary_search(of(shape.parts[0]), base_.number_of(range))) return all();
  shapes_.add_gap("owl:allValuesFrom in the expression");
  return {};
}

//  all are in R max n C where R is functional, n > 0
Contexts ExpressionMembers::in_at_most(const Shape& shape) {
  const auto is_functional = [&](RoleId role) { return base_.index().is_functional(role); };
  if (std::ranges::any_of(base_.index().roles().supers(shape.role), is_functional)) return all();
  shapes_.add_gap("a maximum cardinality in the expression");
  return {};
}

Contexts ExpressionMembers::with_self(const Shape& shape) {
  const auto has_self = [&](const std::vector<RoleId>& selfs) {
    return std::ranges::any_of(selfs, [&](RoleId role) { return base_.index().roles().is_sub_role(role, shape.role); });
  };
  Contexts found;
  for (std::uint32_t at = 0; at < overlay_.context_count(); ++at) {
    const bool is_own = at >= overlay_.base_count();
    if (has_self(is_own ? overlay_.own()[at - overlay_.base_count()].selfs : base_.context(at).selfs)) {
      found.push_back(at);
    }
  }
  return found;
}

//  C is in [not D] where C and D is below F
Contexts ExpressionMembers::disjoint_from(ShapeId shape, const Contexts& candidates) {
  if (is_inside_some_) shapes_.add_gap("a complement inside of a restriction");
  const std::vector<ShapeId> alternatives = shapes_.alternatives_of(shape);
  Contexts found;
  ExpressionOverlay probe(base_, shapes_);
  for (const std::uint32_t candidate : candidates) {
    if (candidate >= overlay_.base_count()) {
      shapes_.add_gap("a complement inside of a complement");
      continue;
    }
    const bool is_disjoint = std::ranges::all_of(alternatives, [&](ShapeId alternative) {
      const std::uint32_t both = probe.require_with(candidate, alternative);
      if (!probe.run()) shapes_.add_gap("too much work for a complement");
      return probe.is_unsatisfiable(both);
    });
    if (is_disjoint) found.push_back(candidate);
    if (probe.is_conditional()) shapes_.add_gap("individuals in a complement");
    if (probe.work() > base_.limits().work) break;
  }
  return found;
}

}  // namespace geminga::el
