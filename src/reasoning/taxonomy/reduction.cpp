// Equivalents are merged, and edges that a longer way implies are left out.
#include "reasoning/taxonomy/reduction.hpp"

#include <algorithm>
#include <span>

#include "base/components.hpp"
#include "base/interner.hpp"
#include "base/rows.hpp"
#include "reasoning/taxonomy/interval_index.hpp"

namespace geminga::taxonomy {
namespace {

constexpr std::uint32_t none = base::NumberTable::none;

/// The steps of one reduction.
class Reduction {
 public:
  explicit Reduction(Inclusions&& graph) : graph_(std::move(graph)) {}

  Reduced run() {
    result_.is_consistent = graph_.is_consistent;
    close_top();
    find_nodes();
    find_candidates();
    keep_direct();
    return std::move(result_);
  }

 private:
  using Edges = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

  void close_top();
  void find_nodes();
  void find_candidates();
  void keep_direct();
  [[nodiscard]] std::uint32_t entity_count() const { return static_cast<std::uint32_t>(graph_.node_of.size()); }

  Inclusions graph_;
  Reduced result_;
  std::vector<std::uint32_t> component_;  ///< by node
  std::uint32_t component_count_ = 0;
  std::vector<std::uint32_t> entity_of_component_;  ///< the representative, or none
  Edges candidates_;                                ///< entity, entity right above or higher
};

void Reduction::close_top() {
  // A node above the top is equivalent to the top. Mostly there is none.
  if (std::ranges::find(graph_.edges, graph_.top, &Edges::value_type::first) == graph_.edges.end()) return;
  const base::Rows<std::uint32_t> up(graph_.node_count, graph_.edges);
  std::vector<bool> seen(graph_.node_count, false);
  std::vector<std::uint32_t> stack = {graph_.top};
  seen[graph_.top] = true;
  while (!stack.empty()) {
    const std::uint32_t node = stack.back();
    stack.pop_back();
    for (const std::uint32_t above : up[node]) {
      if (seen[above]) continue;
      seen[above] = true;
      graph_.edges.emplace_back(above, graph_.top);
      stack.push_back(above);
    }
  }
}

void Reduction::find_nodes() {
  const base::Rows<std::uint32_t> up(graph_.node_count, graph_.edges);
  base::Components found = base::find_components(graph_.node_count, [&](std::uint32_t id) { return up[id]; });
  component_ = std::move(found.component);
  component_count_ = found.count;

  // Components are numbered from the top, so that one pass in this order carries emptiness down.
  Edges members;
  members.reserve(component_.size());
  for (std::uint32_t id = 0; id < component_.size(); ++id) members.emplace_back(component_[id], id);
  const base::Rows<std::uint32_t> members_of(component_count_, members);
  std::vector<bool> is_empty(component_count_, false);
  for (std::uint32_t component = 0; component < component_count_; ++component) {
    for (const std::uint32_t id : members_of[component]) {
      if (graph_.is_empty[id]) is_empty[component] = true;
      for (const std::uint32_t above : up[id]) {
        if (is_empty[component_[above]]) is_empty[component] = true;
      }
    }
  }
  if (is_empty[component_[graph_.top]]) result_.is_consistent = false;
  if (!result_.is_consistent) is_empty.assign(component_count_, true);

  entity_of_component_.assign(component_count_, none);
  std::uint32_t first_empty = none;
  result_.representative.resize(entity_count());
  for (std::uint32_t entity = 0; entity < entity_count(); ++entity) {
    const std::uint32_t component = component_[graph_.node_of[entity]];
    std::uint32_t& first = is_empty[component] ? first_empty : entity_of_component_[component];
    if (first == none) first = entity;
    result_.representative[entity] = first;
  }
  std::erase_if(graph_.edges, [&](const auto& edge) {
    return component_[edge.first] == component_[edge.second] || is_empty[component_[edge.first]];
  });
}

void Reduction::find_candidates() {
  for (auto& [sub, super] : graph_.edges) {
    sub = component_[sub];
    super = component_[super];
  }
  base::Rows<std::uint32_t> up(component_count_, graph_.edges);
  graph_.edges = {};
  up.sort_unique();
  const std::uint32_t top = result_.representative[graph_.top_entity];
  const std::uint32_t bottom = result_.representative[graph_.bottom_entity];

  // A node without an entity stands between entities: the entities above it are above those below it.
  std::vector<std::vector<std::uint32_t>> above_unnamed(component_count_);
  std::vector<std::uint32_t> seen_from(entity_count(), none);
  std::vector<std::uint32_t> gathered;
  for (std::uint32_t component = 0; component < component_count_; ++component) {
    gathered.clear();
    const auto reach = [&](std::uint32_t above) {
      if (seen_from[above] == component) return;
      seen_from[above] = component;
      gathered.push_back(above);
    };
    for (const std::uint32_t above : up[component]) {
      if (entity_of_component_[above] != none) {
        reach(entity_of_component_[above]);
      } else {
        for (const std::uint32_t higher : above_unnamed[above]) reach(higher);
      }
    }
    const std::uint32_t own = entity_of_component_[component];
    if (own == none) {
      above_unnamed[component] = gathered;
      continue;
    }
    if (own == top || own == bottom) continue;
    if (gathered.size() > 1) std::erase(gathered, top);
    if (gathered.empty()) gathered.push_back(top);
    for (const std::uint32_t above : gathered) candidates_.emplace_back(own, above);
  }
}

void Reduction::keep_direct() {
  const base::Rows<std::uint32_t> candidates(entity_count(), candidates_);
  candidates_ = {};
  const IntervalIndex index(candidates);
  result_.parent_begin.assign(1, 0);
  std::vector<std::uint32_t> deepest_first;
  for (std::uint32_t node = 0; node < entity_count(); ++node) {
    deepest_first.assign(candidates[node].begin(), candidates[node].end());
    std::ranges::sort(deepest_first, [&](std::uint32_t a, std::uint32_t b) {
      return std::pair(index.depth(b), a) < std::pair(index.depth(a), b);
    });
    const std::size_t begin = result_.parents.size();
    for (const std::uint32_t above : deepest_first) {
      const auto accepted = std::span(result_.parents).subspan(begin);
      const bool is_direct =
          std::ranges::none_of(accepted, [&](std::uint32_t parent) { return index.is_under(parent, above); });
      if (is_direct) result_.parents.push_back(above);
    }
    std::sort(result_.parents.begin() + static_cast<std::ptrdiff_t>(begin), result_.parents.end());
    result_.parent_begin.push_back(static_cast<std::uint32_t>(result_.parents.size()));
  }
}

}  // namespace

Reduced reduce(Inclusions&& inclusions) { return Reduction(std::move(inclusions)).run(); }

}  // namespace geminga::taxonomy
