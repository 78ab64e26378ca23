#include "reasoning/signature/hierarchy.hpp"

#include <algorithm>
#include <cmath>

#include "base/assert.hpp"
#include "base/components.hpp"
#include "reasoning/taxonomy/interval_index.hpp"

namespace geminga::signature {
namespace {

using taxonomy::Interval;
using Intervals = std::vector<Interval>;

/// The ranks of all nodes below a node, itself included: ascending and disjoint.
Intervals ranks_below(const taxonomy::IntervalIndex& index, std::uint32_t node) {
  Intervals ranks(index.further(node).begin(), index.further(node).end());
  ranks.insert(std::ranges::upper_bound(ranks, index.own(node)), index.own(node));
  return ranks;
}

Intervals common(const Intervals& a, const Intervals& b) {
  Intervals both;
  for (std::size_t x = 0, y = 0; x < a.size() && y < b.size();) {
    const Interval shared{std::max(a[x].first, b[y].first), std::min(a[x].last, b[y].last)};
    if (shared.first <= shared.last) both.push_back(shared);
    ++(a[x].last < b[y].last ? x : y);
  }
  return both;
}

double count_of(const Intervals& ranks) {
  double count = 0;
  for (const Interval& interval : ranks) count += static_cast<double>(interval.last - interval.first) + 1;
  return count;
}

}  // namespace

Hierarchy::Hierarchy(std::uint32_t concept_count, std::span<const Inclusion> inclusions, std::optional<Concept> top,
                     std::uint32_t foreign_count) {
  GEMINGA_ASSERT(foreign_count <= concept_count);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  edges.reserve(inclusions.size());
  for (const auto& [sub, super] : inclusions) {
    if (sub != super && top != sub && top != super)
      edges.emplace_back(static_cast<std::uint32_t>(sub), static_cast<std::uint32_t>(super));
  }
  const base::Rows<std::uint32_t> above(concept_count, edges);
  base::Components components =
      base::find_components(concept_count, [&](std::uint32_t number) { return above[number]; });
  node_of_ = std::move(components.component);
  if (top) top_ = node_of_[static_cast<std::size_t>(*top)];

  for (auto& [sub, super] : edges) {
    sub = node_of_[sub];
    super = node_of_[super];
  }
  std::erase_if(edges, [](const auto& edge) { return edge.first == edge.second; });
  parents_ = base::Rows<std::uint32_t>(components.count, edges);
  parents_.sort_unique();

  const taxonomy::IntervalIndex index(parents_);
  const double world = 2.0 * std::max(components.count - foreign_count, 1U);
  added_.resize(components.count);
  for (std::uint32_t node = 0; node < components.count; ++node) {
    double among = world;
    if (const auto parents = parents_[node]; !parents.empty()) {
      Intervals ranks = ranks_below(index, parents.front());
      for (const std::uint32_t parent : parents.subspan(1)) ranks = common(ranks, ranks_below(index, parent));
      among = count_of(ranks);
    }
    added_[node] = std::log2(among / count_of(ranks_below(index, node)));
  }
}

Meaning Hierarchy::meaning(Concept of) const {
  Meaning meaning;
  meaning.node = node_of_[static_cast<std::size_t>(of)];
  if (meaning.node == top_) return meaning;
  std::vector<std::uint32_t>& found = meaning.ancestors;
  std::vector<bool> is_found(parents_.row_count());
  const auto take = [&](std::uint32_t node) {
    if (is_found[node] || found.size() >= max_ancestors) return;
    is_found[node] = true;
    found.push_back(node);
  };
  take(meaning.node);
  for (std::size_t at = 0; at < found.size(); ++at) {
    for (const std::uint32_t parent : parents_[found[at]]) take(parent);
  }
  std::ranges::sort(found);
  for (const std::uint32_t node : found) meaning.bits += added_[node];
  return meaning;
}

double Hierarchy::shared_bits(const Meaning& a, const Meaning& b) const {
  double bits = 0;
  for (auto x = a.ancestors.begin(), y = b.ancestors.begin(); x != a.ancestors.end() && y != b.ancestors.end();) {
    if (*x == *y) {
      bits += added_[*x];
      ++x;
      ++y;
    } else {
      ++(*x < *y ? x : y);
    }
  }
  return bits;
}

bool is_under(const Meaning& sub, const Meaning& super) {
  return super.ancestors.empty() || std::ranges::binary_search(sub.ancestors, super.node);
}

}  // namespace geminga::signature
