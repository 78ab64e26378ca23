// One function for each kind of shape. Legend as in saturation.hpp; [C] are the contexts below C.
#include "reasoning/placement/expression_members.hpp"

#include <algorithm>
#include <iterator>
#include <ranges>

#include "base/sorted.hpp"
#include "reasoning/placement/expression_meeting.hpp"

namespace geminga::placement {
namespace {

Contexts common(const Contexts& one, const Contexts& other) {
  Contexts both;
  std::ranges::set_intersection(one, other, std::back_inserter(both));
  return both;
}

/// The number of subsumers that take as long to look at as one conclusion.
constexpr std::size_t looked_at_per_conclusion = 16;

/// Makes a context for each alternative. None if that takes too much work or an alternative is impossible.
std::vector<MeetingPoint> points_of(std::span<const ShapeId> alternatives, ExpressionOverlay& alone) {
  std::vector<MeetingPoint> points;
  std::vector<std::uint32_t> contexts;
  for (const ShapeId& alternative : alternatives) contexts.push_back(alone.require(std::span(&alternative, 1)));
  const auto is_impossible = [&](std::uint32_t context) { return alone.is_unsatisfiable(context); };
  if (!alone.run() || std::ranges::any_of(contexts, is_impossible)) return points;
  for (const std::uint32_t context : contexts) points.emplace_back(alone, context);
  return points;
}

}  // namespace

const Contexts& ExpressionMembers::contexts_of(ShapeId id) {
  const auto known = known_.find(id);
  if (known != known_.end()) return known->second;
  Contexts found = find(id);
  add_unsatisfiable(found);
  base::sort_unique(found);
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

Contexts ExpressionMembers::below_atom(el::ExprId atom) {
  if (atom == base_.index().representative(el::top_expr)) return all();
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
      for (const ShapeId part : shape.parts)
        found.insert(found.end(), contexts_of(part).begin(), contexts_of(part).end());
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
      shapes_.add_gap("a maximum cardinality in the expression");
      break;
    case ShapeKind::negation:
      found = disjoint_from(shape.parts[0], all());
      break;
    case ShapeKind::value:
      for (const el::ExprId below : shape.below) {
        const Contexts part = below_atom(below);
        found.insert(found.end(), part.begin(), part.end());
      }
      break;
    case ShapeKind::opaque:
      break;  // its gap was noted when it was read
  }
  if (shape.atom != el::top_expr) {
    const Contexts known = below_atom(shape.atom);
    found.insert(found.end(), known.begin(), known.end());
  }
  return found;
}

// [C and D] = [C] and [D]. Complements come last, because each is tested context by context.
Contexts ExpressionMembers::in_all(const Shape& shape) {
  Contexts found;
  bool is_first = true;
  for (const ShapeId part : shape.parts) {
    if (shapes_.shape(part).kind == ShapeKind::negation) continue;
    found = is_first ? contexts_of(part) : common(found, contexts_of(part));
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
  const Contexts& filler = contexts_of(shape.parts[0]);
  is_inside_some_ = was_inside;
  const el::Roles& roles = base_.index().roles();
  Contexts found;
  for (const std::uint32_t target : filler) {
    if (target >= overlay_.base_count()) break;
    for (const el::Link link : base_.backward_of(target)) {
      if (roles.is_sub_role(link.role, shape.role)) found.push_back(link.context);
    }
  }
  for (std::uint32_t at = overlay_.base_count(); at < overlay_.context_count(); ++at) {
    const auto& links = overlay_.own()[at - overlay_.base_count()].forward.items();
    const bool is_in = std::ranges::any_of(links, [&](const el::Link& link) {
      return roles.is_sub_role(link.role, shape.role) && std::ranges::binary_search(filler, link.context);
    });
    if (is_in) found.push_back(at);
  }
  return found;
}

// Every context is in R only C if C is above the range of R. The rules cannot tell which others are.
Contexts ExpressionMembers::in_only(const Shape& shape) {
  const el::ExprId range = base_.index().representative(base_.index().range_of(shape.role));
  const el::Context* context = base_.find(range);
  if (context != nullptr && std::ranges::binary_search(contexts_of(shape.parts[0]), base_.number_of(range)))
    return all();
  shapes_.add_gap("owl:allValuesFrom in the expression");
  return {};
}

Contexts ExpressionMembers::with_self(const Shape& shape) {
  const auto has_self = [&](std::span<const el::RoleId> selfs) {
    return std::ranges::any_of(selfs,
                               [&](el::RoleId role) { return base_.index().roles().is_sub_role(role, shape.role); });
  };
  Contexts found;
  for (std::uint32_t at = 0; at < overlay_.context_count(); ++at) {
    const bool is_own = at >= overlay_.base_count();
    if (has_self(is_own ? std::span<const el::RoleId>(overlay_.own()[at - overlay_.base_count()].selfs)
                        : base_.selfs_of(at))) {
      found.push_back(at);
    }
  }
  return found;
}

/// The candidates that matter, the highest first: a context above another has no more subsumers than that.
Contexts ExpressionMembers::to_be_tested(const Contexts& candidates) const {
  std::vector<std::pair<std::size_t, std::uint32_t>> ordered;
  const bool are_classes_enough = wanted_ == Wanted::named_classes && !is_inside_some_;
  for (const std::uint32_t candidate : candidates) {
    const bool is_own = candidate >= overlay_.base_count();
    if (overlay_.is_unsatisfiable(candidate)) continue;
    if (are_classes_enough && (is_own || base_.classes_of(base_.context(candidate).root).empty())) continue;
    ordered.emplace_back(is_own ? overlay_.context_count() : base_.subsumers_of(candidate).size(), candidate);
  }
  std::ranges::sort(ordered);
  Contexts contexts;
  for (const auto& [subsumers, candidate] : ordered) contexts.push_back(candidate);
  return contexts;
}

// C is in [not D] if C and D is below F. Then the contexts below C are, too.
Contexts ExpressionMembers::disjoint_from(ShapeId shape, const Contexts& candidates) {
  if (is_inside_some_) shapes_.add_gap("a complement inside of a restriction");
  const std::vector<ShapeId> alternatives = shapes_.alternatives_of(shape);
  Contexts found;
  std::vector<bool> is_found(overlay_.context_count(), false);
  ExpressionOverlay probe(base_, shapes_);
  ExpressionOverlay alone(base_, shapes_);
  std::vector<MeetingPoint> points = points_of(alternatives, alone);
  std::size_t looked_at = 0;  // subsumers of meetings
  for (const std::uint32_t candidate : to_be_tested(candidates)) {
    if (is_found[candidate]) continue;
    const bool is_own = candidate >= overlay_.base_count();
    if (is_own && !overlay_.own()[candidate - overlay_.base_count()].negations.empty()) {
      shapes_.add_gap("a complement inside of a complement");
    }
    const auto is_impossible = [&](std::size_t alternative) {
      if (!is_own && alternative < points.size()) {
        looked_at += base_.subsumers_of(candidate).size();
        const Meeting meeting = points[alternative].with(candidate);
        if (meeting != Meeting::unknown) return meeting == Meeting::impossible;
      }
      const std::uint32_t both = probe.require_with(overlay_.seeds_of(candidate), alternatives[alternative]);
      return probe.run() && probe.is_unsatisfiable(both);
    };
    const bool is_disjoint = std::ranges::all_of(std::views::iota(std::size_t{0}, alternatives.size()), is_impossible);
    if (probe.work() + looked_at / looked_at_per_conclusion > base_.limits().work) {
      shapes_.add_gap("too much work for a complement");
      break;
    }
    if (!is_disjoint) continue;
    is_found[candidate] = true;
    if (is_own || !base_.together_of(candidate).empty()) continue;
    for (const std::uint32_t below : base_.contexts_below(base_.context(candidate).root)) is_found[below] = true;
  }
  if (probe.is_conditional()) shapes_.add_gap("individuals in a complement");
  for (const std::uint32_t candidate : candidates) {
    if (is_found[candidate]) found.push_back(candidate);
  }
  return found;
}

}  // namespace geminga::placement
