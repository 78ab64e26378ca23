// The rules of el/closure/rules.hpp for each premise that may be new, and the conclusions of shapes.
#include "reasoning/placement/expression_overlay.hpp"

#include <algorithm>

#include "base/sorted.hpp"

namespace geminga::placement {

ExpressionOverlay::ExpressionOverlay(const ExpressionBase& base, const ShapeReader& shapes)
    : Rules(base.index()),
      base_(base),
      shapes_(shapes),
      base_count_(static_cast<std::uint32_t>(base.context_count())),
      size_(static_cast<std::uint32_t>(base.index().size())) {}

bool ExpressionOverlay::is_unsatisfiable(std::uint32_t context) const {
  return is_own(context) ? own_[context - base_count_].is_unsatisfiable : base_.context(context).is_unsatisfiable;
}

Seeds ExpressionOverlay::seeds_of(std::uint32_t context) const {
  if (is_own(context)) return own_[context - base_count_].seeds;
  Seeds seeds;
  for (const el::ExprId atom : base_.together_of(context)) seeds.push_back(number(atom));
  if (seeds.empty()) seeds.push_back(number(base_.context(context).root));
  return seeds;
}

std::span<const el::Link> ExpressionOverlay::forward_of(std::uint32_t context) const {
  if (is_own(context)) return own_[context - base_count_].forward.items();
  return base_.forward_of(context);
}

std::span<const el::ExprId> ExpressionOverlay::propagating_of(std::uint32_t context) const {
  if (is_own(context)) return own_[context - base_count_].propagating;
  return base_.propagating_of(context);
}

void ExpressionOverlay::add_seed(Seeds& seeds, ShapeId id) const {
  const Shape& shape = shapes_.shape(id);
  if (shape.kind == ShapeKind::atom) {
    seeds.push_back(number(shape.atom));
  } else if (shape.kind == ShapeKind::all_of) {
    for (const ShapeId part : shape.parts) add_seed(seeds, part);
  } else {
    seeds.push_back(size_ + id);
  }
}

std::uint32_t ExpressionOverlay::require(std::span<const ShapeId> together) {
  Seeds seeds;
  for (const ShapeId shape : together) add_seed(seeds, shape);
  return context_of(std::move(seeds));
}

std::uint32_t ExpressionOverlay::require_with(Seeds seeds, ShapeId shape) {
  add_seed(seeds, shape);
  return context_of(std::move(seeds));
}

std::uint32_t ExpressionOverlay::context_of_atom(el::ExprId atom) {
  return base_.find(atom) != nullptr ? base_.number_of(atom) : context_of({number(atom)});
}

std::uint32_t ExpressionOverlay::context_of(Seeds seeds) {
  base::sort_unique(seeds);
  const std::uint32_t top = number(index_.representative(el::top_expr));
  if (seeds.size() > 1) std::erase(seeds, top);
  if (seeds.empty()) seeds.push_back(top);
  if (seeds.size() == 1 && seeds.front() < size_ && base_.find(el::ExprId{seeds.front()}) != nullptr) {
    return base_.number_of(el::ExprId{seeds.front()});
  }
  const auto [known, is_new] = context_of_seeds_.try_emplace(seeds, context_count());
  if (!is_new) return known->second;
  const std::uint32_t created = known->second;
  own_.emplace_back().seeds = seeds;
  work_ += seeds.size();
  enqueue(created);

  //  ----- (init)   -----
  //  X < C          X < T
  add_atom(created, el::ExprId{top});
  for (const std::uint32_t seed : seeds) add_member(created, seed);
  return created;
}

void ExpressionOverlay::add_member(std::uint32_t context, std::uint32_t seed) {
  if (seed < size_) {
    add_atom(context, el::ExprId{seed});
  } else {
    assert_shape(context, seed - size_);
  }
}

bool ExpressionOverlay::run() {
  while (!queue_.empty()) {
    const std::uint32_t context = queue_.back();
    queue_.pop_back();
    process(context);
    if (work_ > base_.limits().work) {
      queue_.clear();
      return false;
    }
  }
  return true;
}

void ExpressionOverlay::enqueue(std::uint32_t context) {
  if (queue_.empty() || queue_.back() != context) queue_.push_back(context);
}

void ExpressionOverlay::process(std::uint32_t context) {
  // The vector of contexts grows while rules are applied, so each turn looks its context up again.
  while (work_ <= base_.limits().work && !own(context).is_unsatisfiable) {
    OverlayContext& self = own(context);
    if (self.subsumers_done < self.subsumers.size()) {
      const std::uint32_t subsumer = self.subsumers[self.subsumers_done++];
      if (subsumer < size_) process_subsumer(context, el::ExprId{subsumer});
    } else if (self.forward_done < self.forward.size()) {
      process_link(context, self.forward[self.forward_done++]);
    } else if (self.selfs_done < self.selfs.size()) {
      apply_self(context, self.selfs[self.selfs_done++]);
    } else {
      break;
    }
  }
}

//  X -R-> D   D < F
//  ----------------
//  X < F
void ExpressionOverlay::add_bottom(std::uint32_t context) {
  std::vector<std::uint32_t> stack = {context};
  while (!stack.empty()) {
    OverlayContext& self = own(stack.back());
    stack.pop_back();
    if (self.is_unsatisfiable) continue;
    self.is_unsatisfiable = true;
    ++work_;
    for (const el::Link link : self.backward) stack.push_back(link.context);
  }
}

void ExpressionOverlay::add_subsumer(std::uint32_t context, el::ExprId subsumer) {
  OverlayContext& self = own(context);
  if (self.is_unsatisfiable || !self.subsumers.insert(number(subsumer))) return;
  ++work_;
  enqueue(context);
}

void ExpressionOverlay::add_atom(std::uint32_t context, el::ExprId atom) {
  if (atom == index_.representative(el::bottom_expr)) return add_bottom(context);
  if (own(context).is_unsatisfiable || !own(context).derived.insert(number(atom))) return;
  if (index_.is_active(atom)) return add_subsumer(context, atom);
  for (const el::ExprId above : index_.frontier(atom)) add_subsumer(context, above);
}

void ExpressionOverlay::process_subsumer(std::uint32_t context, el::ExprId subsumer) {
  apply(context, subsumer);
  if (own(context).is_unsatisfiable) return;
  apply_functional(context, subsumer);
  if (index_.is_nominal(subsumer)) process_nominal(context, subsumer);
}

// The second premise of propagate() is new.
void ExpressionOverlay::add_filler(std::uint32_t context, el::ExprId subsumer) {
  own(context).propagating.push_back(subsumer);
  for (std::size_t at = 0; at < own(context).backward.size(); ++at) propagate(own(context).backward[at], subsumer);
}

//  X < {a}   {a} < D
//  ----------------- ; that {a} < X where X is not empty needs a world of its own
//  X < D
void ExpressionOverlay::process_nominal(std::uint32_t context, el::ExprId nominal) {
  is_conditional_ = true;
  if (base_.find(nominal) == nullptr) return;
  const std::uint32_t individual = base_.number_of(nominal);
  if (is_unsatisfiable(individual)) return add_bottom(context);
  for (const std::uint32_t subsumer : base_.subsumers_of(individual)) {
    if (subsumer < size_) add_subsumer(context, el::ExprId{subsumer});
  }
  for (const el::ExprId atom : base_.derived_of(individual)) add_atom(context, atom);
}

void ExpressionOverlay::add_link(std::uint32_t from, el::RoleId role, std::uint32_t to) {
  if (own(from).is_unsatisfiable || !own(from).forward.insert({role, to})) return;
  ++work_;
  enqueue(from);
  if (is_own(to)) own(to).backward.push_back({role, from});
}

void ExpressionOverlay::process_link(std::uint32_t context, el::Link link) {
  if (is_unsatisfiable(link.context)) return add_bottom(context);
  if (!is_own(link.context) && base_.is_conditional(link.context)) is_conditional_ = true;

  // The new premise is the first of propagate(), then the first of compose(), then its second.
  for (const el::ExprId filler : propagating_of(link.context)) propagate({link.role, context}, filler);
  if (!index_.roles().compositions(link.role).empty()) {
    const std::vector<el::Link> next(forward_of(link.context).begin(), forward_of(link.context).end());
    for (const el::Link& further : next) compose(context, link.role, further.role, further.context);
  }
  if (index_.roles().is_second(link.role)) {
    const std::vector<el::Link> before = own(context).backward;
    for (const el::Link& earlier : before) compose(earlier.context, earlier.role, link.role, link.context);
  }
  const std::vector<ShapeId> universals = own(context).universals;
  for (const ShapeId universal : universals) apply_universal(context, universal, link);
  if (index_.may_be_functional(link.role) || !own(context).functional.empty()) functional_link(context, link);
}

//  X < R only C   X -S-> D
//  ----------------------- [S <* R]
//  X -S-> C and D
void ExpressionOverlay::apply_universal(std::uint32_t context, ShapeId universal, el::Link link) {
  const Shape& shape = shapes_.shape(universal);
  if (!index_.roles().is_sub_role(link.role, shape.role)) return;
  const std::uint32_t narrower = require_with(seeds_of(link.context), shape.parts[0]);
  if (narrower != link.context) add_link(context, link.role, narrower);
}

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

std::vector<el::ExprId> ExpressionOverlay::atoms_above(std::uint32_t context) const {
  std::vector<el::ExprId> found;
  std::vector<bool> seen(size_, false);
  const auto reach = [&](el::ExprId atom) {
    if (seen[number(atom)]) return;
    seen[number(atom)] = true;
    found.push_back(atom);
  };
  for (const std::uint32_t seed : seeds_of(context)) {
    if (seed < size_) reach(el::ExprId{seed});
  }
  reach(index_.representative(el::top_expr));
  std::span<const std::uint32_t> subsumers;
  if (is_own(context)) {
    const OverlayContext& self = own_[context - base_count_];
    for (const std::uint32_t atom : self.derived.items()) reach(el::ExprId{atom});
    subsumers = self.subsumers.items();
  } else {
    for (const el::ExprId atom : base_.derived_of(context)) reach(atom);
    subsumers = base_.subsumers_of(context);
  }
  for (const std::uint32_t subsumer : subsumers) {
    if (subsumer < size_ && index_.is_atom(el::ExprId{subsumer})) reach(el::ExprId{subsumer});
  }
  for (std::size_t at = 0; at < found.size(); ++at) {
    const el::ExprId atom = found[at];
    for (const el::ExprId above : index_.told_atoms(atom)) reach(above);
    // The conclusions about an atom without rules stand in its own context, if it has one.
    if (base_.find(atom) != nullptr) {
      for (const el::ExprId above : base_.derived_of(base_.number_of(atom))) reach(above);
    }
  }
  std::ranges::sort(found);
  return found;
}

}  // namespace geminga::placement
