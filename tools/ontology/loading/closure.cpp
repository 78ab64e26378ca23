#include "ontology/loading/closure.hpp"

#include <algorithm>

namespace geminga::ontology {
namespace {

using taxonomy::ClassNumber;

/// Visits every node above a node, itself included, once.
template <typename Visit>
void walk_up(const Hierarchy& hierarchy, std::uint32_t from, std::vector<std::uint32_t>& seen, std::uint32_t mark,
             const Visit& visit) {
  std::vector<std::uint32_t> stack{hierarchy.representative[from]};
  seen[stack.front()] = mark;
  while (!stack.empty()) {
    const std::uint32_t node = stack.back();
    stack.pop_back();
    visit(node);
    for (const std::uint32_t parent : hierarchy.parents_of(node)) {
      if (seen[parent] == mark) continue;
      seen[parent] = mark;
      stack.push_back(parent);
    }
  }
}

bool has(const Closure& closure, ClassNumber sub, ClassNumber super) {
  return sub == super || std::ranges::binary_search(closure.pairs, Subsumption{sub, super});
}

}  // namespace

std::optional<Closure> closure_of(const Hierarchy& hierarchy, const ClassNumbers& numbers) {
  std::vector<ClassNumber> number;
  for (const std::string_view iri : hierarchy.iris) number.push_back(ClassNumber{numbers.at(iri)});
  Closure closure;
  closure.is_empty.resize(numbers.size(), false);
  std::vector<std::uint32_t> seen(hierarchy.iris.size(), 0);
  for (std::uint32_t sub = 0; sub < hierarchy.iris.size(); ++sub) {
    if (hierarchy.is_empty(sub)) {
      closure.is_empty[static_cast<std::size_t>(number[sub])] = true;
      continue;
    }
    walk_up(hierarchy, sub, seen, sub + 1, [&](std::uint32_t node) {
      for (const std::uint32_t super : hierarchy.members[node]) {
        if (super != sub && super != hierarchy.top) closure.pairs.push_back({number[sub], number[super]});
      }
    });
    if (closure.pairs.size() > max_compared_subsumptions) return std::nullopt;
  }
  std::ranges::sort(closure.pairs);
  return closure;
}

std::vector<Subsumption> telling(const std::vector<Subsumption>& different, const Closure& kept, std::size_t most) {
  constexpr std::size_t max_compared = 2'000;  // each is compared with each
  std::vector<Subsumption> shown;
  const std::size_t compared = std::min(different.size(), max_compared);
  for (std::size_t at = 0; at < compared && shown.size() < most; ++at) {
    const Subsumption& pair = different[at];
    bool follows = false;
    for (std::size_t other = 0; other < compared && !follows; ++other) {
      if (other == at) continue;
      follows = has(kept, pair.sub, different[other].sub) && has(kept, different[other].super, pair.super);
    }
    if (!follows) shown.push_back(pair);
  }
  // Those that follow from each other are all told of, up to the limit.
  for (std::size_t at = 0; at < different.size() && shown.empty(); ++at) shown.push_back(different[at]);
  return shown;
}

}  // namespace geminga::ontology
