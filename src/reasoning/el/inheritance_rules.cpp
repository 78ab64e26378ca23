// Where the conclusions of a closure by inheritance are noted, and what nodes tell each other because of the rules of
// rules.hpp; the legend is in inheritance.hpp.
#include <algorithm>

#include "reasoning/el/inheritance_worker.hpp"

namespace geminga::el {
namespace {

constexpr std::uint8_t bit(RuleBits rules) { return static_cast<std::uint8_t>(rules); }

}  // namespace

void InheritanceWorker::add_subsumer(std::uint32_t node, ExprId item) {
  Node& self = nodes_[node];
  if (self.is_unsatisfiable || !self.items.insert(number(item), arena_)) return;
  ++conclusions_;
  self.todo.push_back(number(item), arena_);
}

void InheritanceWorker::process_inherited(std::uint32_t node, std::uint32_t item) {
  if (item >= shared_.first_link) {
    const Node& self = nodes_[node];
    for (std::uint32_t at = 0; at < self.selfs.size(); ++at) compose_with_link(node, self.selfs[at], item);
  } else {
    apply_to_inherited(node, ExprId{item}, index_.rule_bits(ExprId{item}));
  }
}

// Here only what R Self says: all other links are nodes, which tell_sources() tells of fillers.
void InheritanceWorker::add_filler(std::uint32_t node, ExprId item) {
  const Node& self = nodes_[node];
  for (std::uint32_t at = 0; at < self.selfs.size(); ++at) propagate({self.selfs[at], node}, item);
}

void InheritanceWorker::add_self(std::uint32_t node, RoleId role) {
  Node& self = nodes_[node];
  if (self.is_unsatisfiable || std::ranges::find(self.selfs, role) != self.selfs.end()) return;
  self.selfs.push_back(role, arena_);
  ++conclusions_;
  apply_self(node, role);
}

// The node of R some N could tell N only what follows from the items of N itself. So it is not made, and these are read
// here.
void InheritanceWorker::add_loop(std::uint32_t node, RoleId role) {
  const Node& self = nodes_[node];
  std::vector<ExprId> found;
  for (std::uint32_t at = 0; at < self.items.size(); ++at) {
    const std::uint32_t item = self.items[at];
    if (item >= shared_.first_link) {
      compose_with_link(node, role, item);
    } else if (is_filler(item)) {
      for_each_existential(role, ExprId{item}, [&](ExprId existential) { found.push_back(existential); });
    }
  }
  for (const ExprId existential : found) add_subsumer(node, existential);
}

//  N < R Self   N < S some M
//  ------------------------- [R o S SubPropertyOf R']
//  N < R' some M
void InheritanceWorker::compose_with_link(std::uint32_t node, RoleId first, std::uint32_t item) {
  const Node& link = nodes_[item - shared_.first_link];
  compose(node, first, RoleId{link.root}, link.filler);
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
      for_each_existential(role, ExprId{item}, [&](ExprId existential) { found_.push_back(number(existential)); });
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
