// Strongly connected components of a graph of numbers, without recursion (Tarjan 1972).
#ifndef GEMINGA_BASE_COMPONENTS_HPP
#define GEMINGA_BASE_COMPONENTS_HPP

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace geminga::base {

/// The component of each node. Every edge leads to the same or a smaller component number: what is reachable comes
/// first. Linear in nodes and edges.
struct Components {
  std::vector<std::uint32_t> component;
  std::uint32_t count = 0;
};

/// `successors(node)` returns a span of numbers, or of what static_cast converts to numbers.
template <typename Successors>
[[nodiscard]] Components find_components(std::uint32_t node_count, Successors&& successors) {
  constexpr std::uint32_t unseen = std::numeric_limits<std::uint32_t>::max();
  Components result;
  result.component.assign(node_count, unseen);
  std::vector<std::uint32_t> order(node_count, unseen);
  std::vector<std::uint32_t> low(node_count, 0);
  std::vector<std::uint32_t> open;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> path;  // node, next successor
  std::uint32_t next_order = 0;
  for (std::uint32_t root = 0; root < node_count; ++root) {
    if (order[root] != unseen) continue;
    path.emplace_back(root, 0);
    while (!path.empty()) {
      const std::uint32_t node = path.back().first;
      if (path.back().second == 0) {
        order[node] = low[node] = next_order++;
        open.push_back(node);
      }
      const auto next = successors(node);
      bool descended = false;
      while (path.back().second < next.size()) {
        const auto to = static_cast<std::uint32_t>(next[path.back().second++]);
        if (order[to] == unseen) {
          path.emplace_back(to, 0);
          descended = true;
          break;
        }
        if (result.component[to] == unseen) low[node] = std::min(low[node], order[to]);
      }
      if (descended) continue;
      path.pop_back();
      if (!path.empty()) low[path.back().first] = std::min(low[path.back().first], low[node]);
      if (low[node] != order[node]) continue;
      while (true) {
        const std::uint32_t member = open.back();
        open.pop_back();
        result.component[member] = result.count;
        if (member == node) break;
      }
      ++result.count;
    }
  }
  return result;
}

}  // namespace geminga::base

#endif
