// Sharing by hashing of list cells.
#include "reasoning/dl/hypertableau/graph/dependency.hpp"

#include <utility>

namespace geminga::hypertableau {

void DependencySets::clear() {
  cells_.assign(1, {0, no_dependency});
  table_ = {};
  known_.fill({});
}

DependencySet DependencySets::cons(std::uint32_t branch, DependencySet rest) {
  const Cell cell{branch, rest};
  const std::uint64_t hash = hash_of(cell);
  const std::uint32_t found =
      table_.find(hash, [&](std::uint32_t at) { return cells_[at].branch == branch && cells_[at].rest == rest; });
  if (found != base::NumberTable::none) return found;
  const auto number = static_cast<DependencySet>(cells_.size());
  cells_.push_back(cell);
  table_.insert(hash, number);
  return number;
}

DependencySet DependencySets::unite(DependencySet first, DependencySet second) {
  if (first == second || second == no_dependency) return first;
  if (first == no_dependency) return second;
  if (first > second) std::swap(first, second);
  Known& known =
      known_[((std::uint64_t{first} * 0x9e3779b97f4a7c15U) ^ (std::uint64_t{second} * 0xc2b2ae3d27d4eb4fU)) >> 52];
  if (known.first == first && known.second == second) return known.both;
  DependencySet a = first;
  DependencySet b = second;
  open_.clear();
  while (a != b && a != no_dependency && b != no_dependency) {
    const Cell& above_a = cells_[a];
    const Cell& above_b = cells_[b];
    if (above_a.branch >= above_b.branch) {
      open_.push_back(above_a.branch);
      if (above_a.branch == above_b.branch) b = above_b.rest;
      a = above_a.rest;
    } else {
      open_.push_back(above_b.branch);
      b = above_b.rest;
    }
  }
  DependencySet both = a == no_dependency ? b : a;
  while (!open_.empty()) {
    both = cons(open_.back(), both);
    open_.pop_back();
  }
  known = {first, second, both};
  return both;
}

}  // namespace geminga::hypertableau
