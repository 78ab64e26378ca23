// The rules of a closure by inheritance, each in logic notation beside its code; the legend is in inheritance.hpp.
#include <algorithm>

#include "reasoning/el/inheritance_worker.hpp"

namespace geminga::el {
namespace {

constexpr std::uint8_t bit(RuleBits rules) { return static_cast<std::uint8_t>(rules); }

}  // namespace

void InheritanceWorker::add_item(std::uint32_t node, ExprId item) {
  Node& self = nodes_[node];
  if (self.is_unsatisfiable || !self.items.insert(number(item), arena_)) return;
  ++conclusions_;
  self.todo.push_back(number(item), arena_);
}

void InheritanceWorker::process_item(std::uint32_t node, ExprId item) {
  const std::uint8_t rules = index_.rule_bits(item);
  const auto has = [&](RuleBits kind) { return (rules & bit(kind)) != 0; };

  //  N < D
  //  ----- [D < F is told]
  //  N < F
  if (has(RuleBits::bottom)) return add_bottom(node);

  //  N < D
  //  ----- [D < E is told]; what is told of an atom is above its node from the start
  //  N < E
  if (has(RuleBits::above) && !index_.is_atom(item)) {
    for (const ExprId above : index_.told_atoms(item)) inherit_derived(node, above);
  }

  //  N < D
  //  ------------ [D < R some E is told, M is the node of E]
  //  N < R some M
  if (has(RuleBits::links)) {
    for (const LinkRule& link : index_.links(item)) inherit_existential(node, link.role, require(link.root));
  }
  if (has(RuleBits::conjunctions)) apply_conjunctions(node, item);
  process_inherited(node, number(item));
}

void InheritanceWorker::process_inherited(std::uint32_t node, std::uint32_t item) {
  if (item >= shared_.first_link) return process_propagating(node, item);
  const std::uint8_t rules = index_.rule_bits(ExprId{item});
  const auto has = [&](RuleBits kind) { return (rules & bit(kind)) != 0; };
  if (has(RuleBits::selfs)) {
    for (const RoleId role : index_.selfs(ExprId{item})) add_self(node, role);
  }
  if (has(RuleBits::existentials)) process_propagating(node, item);
  if (has(RuleBits::disjointness)) {
    for (const std::uint32_t axiom : index_.disjointness(ExprId{item})) add_disjointness(node, axiom);
  }
}

//  N < D   N < E
//  ------------- [D and E occurs negatively]; unless one node above has both
//  N < D and E
void InheritanceWorker::apply_conjunctions(std::uint32_t node, ExprId item) {
  // Whichever is shorter is walked, and the other searched: names like "disease" are in thousands of conjunctions.
  Node& self = nodes_[node];
  const std::span<const ConjunctionRule> rules = index_.conjunctions(item);
  work_.add(std::min<std::size_t>(rules.size(), self.items.size()));
  if (rules.size() <= self.items.size() * 2) {
    for (const ConjunctionRule& rule : rules) {
      if (self.items.contains(number(rule.partner))) add_item(node, rule.conjunction);
    }
    return;
  }
  for (std::size_t at = 0; at < self.items.size(); ++at) {
    const ExprId partner{self.items[at]};
    for (auto rule = std::ranges::lower_bound(rules, partner, {}, &ConjunctionRule::partner);
         rule != rules.end() && rule->partner == partner; ++rule) {
      add_item(node, rule->conjunction);
    }
  }
}

//  N < D   N < E
//  ------------- [D and E are different members of one disjointness axiom]
//  N < F
void InheritanceWorker::add_disjointness(std::uint32_t node, std::uint32_t axiom) {
  Node& self = nodes_[node];
  if (self.is_unsatisfiable) return;
  // The axiom's mark among the items says that one member was there before. Each node sets its own: two that are above
  // may have theirs from the same member.
  if (!self.items.insert(static_cast<std::uint32_t>(index_.size()) + axiom, arena_)) add_bottom(node);
}

//  N < D   N is below R Self
//  ------------------------- [S some D occurs negatively, R <* S]; and what a link says, as in compose()
//  N < S some D
void InheritanceWorker::process_propagating(std::uint32_t node, std::uint32_t item) {
  Node& self = nodes_[node];
  for (std::uint32_t at = 0; at < self.selfs.size(); ++at) {
    const RoleId role = self.selfs[at];
    if (item >= shared_.first_link) {
      compose(node, role, item);
      continue;
    }
    std::vector<std::uint32_t> found;
    find_existentials(role, ExprId{item}, found);
    for (const std::uint32_t existential : found) add_item(node, ExprId{existential});
  }
}

//  N < R Self
//  ---------- [R <* S, S Self occurs negatively]; what else R Self says is in the next rules
//  N < S Self
void InheritanceWorker::add_self(std::uint32_t node, RoleId role) {
  Node& self = nodes_[node];
  if (self.is_unsatisfiable || std::ranges::find(self.selfs, role) != self.selfs.end()) return;
  self.selfs.push_back(role, arena_);
  ++conclusions_;
  for (const RoleId super : index_.roles().supers(role)) {
    const ExprId negative = index_.negative_self(super);
    if (negative != bottom_expr) add_item(node, negative);
  }

  //  N < R Self
  //  ---------- [E is the range of R]
  //  N < E
  if (index_.range_of(role) != top_expr) inherit_derived(node, index_.representative(index_.range_of(role)));

  //  N < D   N < R Self
  //  ------------------ [S some D occurs negatively, R <* S]; here the second premise is new
  //  N < S some D
  std::vector<std::uint32_t> found;
  for (std::uint32_t at = 0; at < self.items.size(); ++at) {
    const std::uint32_t item = self.items[at];
    if (item >= shared_.first_link) {
      compose(node, role, item);
    } else if (is_filler(item)) {
      find_existentials(role, ExprId{item}, found);
    }
  }
  for (const std::uint32_t existential : found) add_item(node, ExprId{existential});

  //  N < R Self   N < S Self
  //  ----------------------- [R o S SubPropertyOf R']
  //  N < R' Self
  const auto compose_selfs = [&](RoleId first, RoleId second) {
    for (const Composition& rule : index_.roles().compositions(first)) {
      if (rule.second == second) add_self(node, rule.result);
    }
  };
  for (std::uint32_t at = 0; at < self.selfs.size(); ++at) {
    const RoleId other = self.selfs[at];
    compose_selfs(role, other);
    if (other != role) compose_selfs(other, role);
  }
}

//  N < R Self   N < S some M
//  ------------------------- [R o S SubPropertyOf R']
//  N < R' some M
void InheritanceWorker::compose(std::uint32_t node, RoleId first, std::uint32_t link) {
  const Node& second = nodes_[link - shared_.first_link];
  for (const RoleId result : index_.roles().composed(first, RoleId{second.root})) {
    inherit_existential(node, result, second.filler);
  }
}

void InheritanceWorker::find_existentials(RoleId role, ExprId filler, std::vector<std::uint32_t>& found) const {
  // What a hub is below may be the filler of thousands of existentials, of which one link concerns a handful.
  constexpr std::size_t max_scanned = 8;
  const Roles& roles = index_.roles();
  const auto rules = index_.existentials(filler);
  if (rules.size() <= max_scanned) {
    for (const ExistentialRule& rule : rules) {
      if (roles.is_sub_role(role, rule.role)) found.push_back(number(rule.existential));
    }
    return;
  }
  for (const RoleId super : roles.supers(role)) {
    for (auto rule = std::ranges::lower_bound(rules, super, {}, &ExistentialRule::role);
         rule != rules.end() && rule->role == super; ++rule) {
      found.push_back(number(rule->existential));
    }
  }
}

void InheritanceWorker::tell_sources(std::uint32_t node) {
  Node& self = nodes_[node];
  if (self.sources.empty()) return;
  const auto gather = [&](std::uint32_t from, std::vector<std::uint32_t>& gathered) {
    gathered.clear();
    for (std::uint32_t at = from; at < self.items.size(); ++at) {
      if (self.items[at] >= shared_.first_link || is_filler(self.items[at])) gathered.push_back(self.items[at]);
    }
  };
  if (self.sources_told != 0) gather(self.items_told, new_items_);
  if (self.sources_told < self.sources.size()) gather(0, all_items_);
  for (std::uint32_t at = 0; at < self.sources.size() && !shared_.has_ended(); ++at) {
    const bool is_new = at >= self.sources_told;
    tell_source(node, self.sources[at], is_new, is_new ? all_items_ : new_items_);
  }
  self.sources_told = self.sources.size();
}

void InheritanceWorker::tell_source(std::uint32_t node, std::uint32_t source, bool is_new, Items items) {
  const Node& self = nodes_[node];
  const RoleId role{nodes_[source].root};
  found_.clear();
  work_.add(items.size());
  for (const std::uint32_t item : items) {
    //  N < D
    //  --------------------- [S some D occurs negatively, R <* S]
    //  R some N < S some D
    if (item < shared_.first_link) {
      find_existentials(role, ExprId{item}, found_);
      continue;
    }

    //  N < S some M
    //  ------------------------ [R o S SubPropertyOf R']
    //  R some N < R' some M
    const Node& second = nodes_[item - shared_.first_link];
    for (const RoleId result : index_.roles().composed(role, RoleId{second.root})) {
      tell(source, {NodeMessage::Kind::composed, static_cast<std::uint32_t>(result), second.filler});
    }
  }

  //  N < S Self
  //  ------------------------ [R o S SubPropertyOf R']
  //  R some N < R' some N
  for (std::uint32_t next = is_new ? 0 : self.selfs_told; next < self.selfs.size(); ++next) {
    for (const RoleId result : index_.roles().composed(role, self.selfs[next])) {
      tell(source, {NodeMessage::Kind::composed, static_cast<std::uint32_t>(result), node});
    }
  }
  if (is_new || !found_.empty()) tell(source, {NodeMessage::Kind::found, delivery_of(node, is_new), 0}, found_);
}

std::uint32_t InheritanceWorker::delivery_of(std::uint32_t node, bool is_new) const {
  if (!is_new) return further_delivery;
  return nodes_[node].is_final ? first_delivery | final_delivery : first_delivery;
}

//  M < X
//  ----- [N is a child of M, which is N < M]; only of what may be a premise together with something else
//  N < X
void InheritanceWorker::serve_children(std::uint32_t node) {
  constexpr std::uint8_t with_others =
      bit(RuleBits::selfs) | bit(RuleBits::conjunctions) | bit(RuleBits::existentials) | bit(RuleBits::disjointness);
  Node& self = nodes_[node];
  if (self.children.empty()) return;
  const auto gather = [&](std::uint32_t from, std::vector<std::uint32_t>& gathered) {
    gathered.clear();
    for (std::uint32_t at = from; at < self.items.size(); ++at) {
      const std::uint32_t item = self.items[at];
      const bool is_wanted =
          item < index_.size() ? (index_.rule_bits(ExprId{item}) & with_others) != 0 : item >= shared_.first_link;
      if (is_wanted) gathered.push_back(item);
    }
  };
  if (self.children_served != 0 && self.items_told < self.items.size()) {
    gather(self.items_told, new_items_);
    for (std::uint32_t at = 0; at < self.children_served && !new_items_.empty() && !shared_.has_ended(); ++at) {
      tell(self.children[at], {NodeMessage::Kind::inherited, further_delivery, 0}, new_items_);
    }
  }
  if (self.children_served < self.children.size()) {
    gather(0, all_items_);
    for (std::uint32_t at = self.children_served; at < self.children.size() && !shared_.has_ended(); ++at) {
      tell(self.children[at], {NodeMessage::Kind::inherited, delivery_of(node, true), 0}, all_items_);
    }
  }
  self.children_served = self.children.size();
}

bool InheritanceWorker::has_conjunctions(std::uint32_t item) const {
  return item < index_.size() && (index_.rule_bits(ExprId{item}) & bit(RuleBits::conjunctions)) != 0;
}

bool InheritanceWorker::is_filler(std::uint32_t item) const {
  return item < index_.size() && (index_.rule_bits(ExprId{item}) & bit(RuleBits::existentials)) != 0;
}

void InheritanceWorker::add_inherited(std::uint32_t node, Items items) {
  Node& self = nodes_[node];
  const std::uint32_t begin = self.items.size();
  self.items.reserve(begin + static_cast<std::uint32_t>(items.size()), arena_);
  for (const std::uint32_t item : items) self.items.insert(item, arena_);
  const std::uint32_t end = self.items.size();
  conclusions_ += end - begin;
  work_.add(items.size());
  for (std::uint32_t at = begin; at < end && !self.is_unsatisfiable; ++at) process_inherited(node, self.items[at]);
  // What came together has met above. The few are compared with the many.
  const bool are_old_fewer = begin < end - begin;
  const std::uint32_t first = are_old_fewer ? 0 : begin;
  const std::uint32_t last = are_old_fewer ? begin : end;
  for (std::uint32_t at = first; at < last && begin != 0 && !self.is_unsatisfiable; ++at) {
    if (has_conjunctions(self.items[at])) apply_conjunctions(node, ExprId{self.items[at]});
  }
}

//  M < F
//  ----- [N is a child of M, or R some M]; what is left to do for N < F itself
//  N < F
void InheritanceWorker::add_bottom(std::uint32_t node) {
  Node& self = nodes_[node];
  if (self.is_unsatisfiable) return;
  self.is_unsatisfiable = true;
  ++conclusions_;
  if (self.is_nonempty) shared_.is_inconsistent = true;
  self.items.clear(arena_);
  self.todo.clear(arena_);
  self.above.clear(arena_);
  self.selfs.clear(arena_);
  self.selfs_told = self.items_told = 0;
  enqueue(node);
}

void InheritanceWorker::tell_bottom(std::uint32_t node) {
  Node& self = nodes_[node];
  for (std::uint32_t at = 0; at < self.children.size(); ++at)
    tell(self.children[at], {NodeMessage::Kind::bottom, 0, 0});
  for (std::uint32_t at = 0; at < self.sources.size(); ++at) tell(self.sources[at], {NodeMessage::Kind::bottom, 0, 0});
  self.children.clear(arena_);
  self.sources.clear(arena_);
  self.children_served = self.sources_told = 0;
}

}  // namespace geminga::el
