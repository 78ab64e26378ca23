// Transitive reduction of the subsumption graph.
#include "el/taxonomy.hpp"

#include <algorithm>

#include "el/components.hpp"
#include "el/interval_index.hpp"
#include "el/rows.hpp"

namespace geminga::el {
namespace {

constexpr std::uint32_t none = NumberTable::none;

}  // namespace

void SubsumptionGraph::add_told_edges() {
  for (std::uint32_t id = 0; id < index_.size(); ++id) {
    if (!index_.is_atom(ExprId{id}) || index_.representative(ExprId{id}) != ExprId{id}) continue;
    for (const ExprId above : index_.told_atoms(ExprId{id})) edges_.emplace_back(id, number(above));
    if (index_.is_told_bottom(ExprId{id})) is_unsatisfiable_[id] = true;
  }
}

void SubsumptionGraph::close_top() {
  // What T is below is equivalent to it.
  const Rows<std::uint32_t> up(index_.size(), edges_);
  std::vector<bool> seen(index_.size(), false);
  const std::uint32_t top = number(index_.representative(top_expr));
  std::vector<std::uint32_t> stack = {top};
  seen[top] = true;
  while (!stack.empty()) {
    const std::uint32_t node = stack.back();
    stack.pop_back();
    for (const std::uint32_t above : up[node]) {
      if (seen[above]) continue;
      seen[above] = true;
      edges_.emplace_back(above, top);
      stack.push_back(above);
    }
  }
}

void SubsumptionGraph::find_nodes(std::span<const ExprId> exprs, Classification& classification) {
  const Rows<std::uint32_t> up(index_.size(), edges_);
  Components found =
      find_components(static_cast<std::uint32_t>(index_.size()), [&](std::uint32_t id) { return up[id]; });
  component_ = std::move(found.component);
  component_count_ = found.count;

  // Supers have smaller components, so one pass in their order carries F down.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> members;
  members.reserve(component_.size());
  for (std::uint32_t id = 0; id < component_.size(); ++id) members.emplace_back(component_[id], id);
  const Rows<std::uint32_t> members_of(component_count_, members);
  std::vector<bool> is_empty(component_count_, false);
  for (std::uint32_t component = 0; component < component_count_; ++component) {
    for (const std::uint32_t id : members_of[component]) {
      if (is_unsatisfiable_[id]) is_empty[component] = true;
      for (const std::uint32_t above : up[id]) {
        if (is_empty[component_[above]]) is_empty[component] = true;
      }
    }
  }
  if (is_empty[component_[number(index_.representative(top_expr))]]) classification.is_consistent = false;
  if (!classification.is_consistent) is_empty.assign(component_count_, true);

  const auto class_count = static_cast<std::uint32_t>(exprs.size());
  class_of_component_.assign(component_count_, none);
  std::uint32_t first_empty = none;
  classification.representative.resize(class_count);
  for (std::uint32_t number_of_class = 0; number_of_class < class_count; ++number_of_class) {
    const std::uint32_t component = component_[number(exprs[number_of_class])];
    std::uint32_t& first = is_empty[component] ? first_empty : class_of_component_[component];
    if (first == none) first = number_of_class;
    classification.representative[number_of_class] = ClassNumber{first};
  }
  std::erase_if(edges_, [&](const auto& edge) {
    return component_[edge.first] == component_[edge.second] || is_empty[component_[edge.first]];
  });
}

void SubsumptionGraph::find_candidates(std::span<const ExprId> exprs, const Classification& classification) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> component_edges;
  component_edges.reserve(edges_.size());
  for (const auto& [sub, super] : edges_) component_edges.emplace_back(component_[sub], component_[super]);
  edges_.clear();
  edges_.shrink_to_fit();
  Rows<std::uint32_t> up(component_count_, component_edges);
  up.sort_unique();
  const std::uint32_t top =
      static_cast<std::uint32_t>(classification.representative[static_cast<std::size_t>(classification.thing)]);
  const std::uint32_t nothing =
      static_cast<std::uint32_t>(classification.representative[static_cast<std::size_t>(classification.nothing)]);

  // Atoms that no class is equivalent to stand between classes: what is above them is above those below them.
  std::vector<std::vector<std::uint32_t>> above_unnamed(component_count_);
  std::vector<std::uint32_t> seen_from(exprs.size(), none);
  std::vector<std::uint32_t> gathered;
  for (std::uint32_t component = 0; component < component_count_; ++component) {
    gathered.clear();
    const auto reach = [&](std::uint32_t above) {
      if (seen_from[above] == component) return;
      seen_from[above] = component;
      gathered.push_back(above);
    };
    for (const std::uint32_t above : up[component]) {
      if (class_of_component_[above] != none) {
        reach(class_of_component_[above]);
      } else {
        for (const std::uint32_t higher : above_unnamed[above]) reach(higher);
      }
    }
    const std::uint32_t own = class_of_component_[component];
    if (own == none) {
      above_unnamed[component] = gathered;
      continue;
    }
    if (own == top || own == nothing) continue;
    if (gathered.size() > 1) std::erase(gathered, top);
    if (gathered.empty()) gathered.push_back(top);
    for (const std::uint32_t above : gathered) candidates_.emplace_back(own, above);
  }
}

void SubsumptionGraph::reduce(std::span<const ExprId> exprs, Classification& classification) && {
  add_told_edges();
  close_top();
  find_nodes(exprs, classification);
  find_candidates(exprs, classification);

  Rows<std::uint32_t> candidates(exprs.size(), candidates_);
  candidates_.clear();
  candidates_.shrink_to_fit();
  const IntervalIndex index(candidates);
  classification.parent_begin.assign(1, 0);
  std::vector<std::uint32_t> deepest_first;
  for (std::uint32_t node = 0; node < exprs.size(); ++node) {
    deepest_first.assign(candidates[node].begin(), candidates[node].end());
    std::ranges::sort(deepest_first, [&](std::uint32_t a, std::uint32_t b) {
      return std::pair(index.depth(b), a) < std::pair(index.depth(a), b);
    });
    const std::size_t begin = classification.parents.size();
    for (const std::uint32_t above : deepest_first) {
      const auto accepted = std::span(classification.parents).subspan(begin);
      const bool is_direct = std::ranges::none_of(
          accepted, [&](ClassNumber parent) { return index.is_under(static_cast<std::uint32_t>(parent), above); });
      if (is_direct) classification.parents.push_back(ClassNumber{above});
    }
    std::sort(classification.parents.begin() + static_cast<std::ptrdiff_t>(begin), classification.parents.end());
    classification.parent_begin.push_back(static_cast<std::uint32_t>(classification.parents.size()));
  }
}

}  // namespace geminga::el
