// The tree is built breadth first, so that smaller sets are found before larger ones.
#include "reasoning/explanation/hitting_sets.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace geminga::explanation {
namespace {

bool is_hit(const AxiomSet& set, const AxiomSet& by) {
  return std::ranges::any_of(set, [&](std::uint32_t axiom) { return std::ranges::binary_search(by, axiom); });
}

}  // namespace

std::vector<std::vector<AxiomSet>> groups_of(const std::vector<AxiomSet>& sets) {
  std::vector<std::size_t> group(sets.size());
  for (std::size_t at = 0; at < sets.size(); ++at) {
    group[at] = at;
    for (std::size_t before = 0; before < at; ++before) {
      if (group[before] == group[at] || !is_hit(sets[before], sets[at])) continue;
      const std::size_t joined = std::max(group[before], group[at]);
      const std::size_t kept = std::min(group[before], group[at]);
      std::replace(group.begin(), group.begin() + static_cast<std::ptrdiff_t>(at) + 1, joined, kept);
    }
  }
  std::vector<std::vector<AxiomSet>> groups;
  for (std::size_t first = 0; first < sets.size(); ++first) {
    if (group[first] != first) continue;
    auto& members = groups.emplace_back();
    for (std::size_t at = first; at < sets.size(); ++at) {
      if (group[at] == first) members.push_back(sets[at]);
    }
  }
  return groups;
}

AllSets find_hitting_sets(const std::vector<AxiomSet>& sets, const ExplanationLimits& limits) {
  AllSets result;
  std::vector<AxiomSet> level{{}};
  std::size_t nodes = 0;
  while (!level.empty() && !result.may_have_more) {
    std::ranges::sort(level);
    std::set<AxiomSet> next;
    for (const AxiomSet& chosen : level) {
      // A set that holds a hitting set of an earlier level is not minimal.
      const auto holds = [&](const AxiomSet& less) { return std::ranges::includes(chosen, less); };
      if (std::ranges::any_of(result.sets, holds)) continue;
      const auto open = std::ranges::find_if(sets, [&](const AxiomSet& set) { return !is_hit(set, chosen); });
      if (open == sets.end()) {
        if (result.sets.size() == limits.sets) {
          result.may_have_more = true;
          break;
        }
        result.sets.push_back(chosen);
        continue;
      }
      if (nodes + open->size() > limits.nodes) {
        result.may_have_more = true;
        break;
      }
      nodes += open->size();
      for (const std::uint32_t axiom : *open) {
        AxiomSet more = chosen;
        more.insert(std::ranges::lower_bound(more, axiom), axiom);
        next.insert(std::move(more));
      }
    }
    level.assign(next.begin(), next.end());
  }
  return result;
}

}  // namespace geminga::explanation
