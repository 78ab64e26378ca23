#include "ontology/repair/loss.hpp"

#include <algorithm>
#include <iterator>
#include <set>

#include "ontology/loading/hierarchy.hpp"
#include "reasoning/reasoner/excerpt.hpp"
#include "reasoning/reasoner/reasoner.hpp"

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

Losses::Losses(const owl::Ontology& source, const compiled::Ontology& ontology, base::Budget& budget)
    : source_(source), budget_(budget) {
  for (std::uint32_t number = 0; number < ontology.class_count(); ++number)
    numbers_.emplace(ontology.iri(ClassNumber{number}), number);
}

std::optional<Closure> Losses::closure_without(std::span<const std::uint32_t> removed) {
  std::vector<std::uint32_t> axioms;
  for (std::uint32_t axiom = 0; axiom < source_.axiom_count(); ++axiom) {
    if (!std::ranges::binary_search(removed, axiom)) axioms.push_back(axiom);
  }
  const reasoner::Excerpt excerpt(source_, axioms);
  const auto classified = reasoner::classify(excerpt.source, {.budget = &budget_});
  if (!classified || budget_.is_spent()) return std::nullopt;
  const Hierarchy hierarchy = class_hierarchy(excerpt.source, *classified);
  std::vector<ClassNumber> number;
  for (const std::string_view iri : hierarchy.iris) number.push_back(ClassNumber{numbers_.at(iri)});
  Closure closure;
  closure.is_empty.resize(numbers_.size(), false);
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

std::vector<std::vector<Subsumption>> lost_in(const Closure& whole, std::span<const Closure> closures) {
  std::set<Subsumption> all;  // what some closures have and the whole has not
  std::vector<Subsumption> difference;
  for (const Closure& one : closures) {
    difference.clear();
    std::ranges::set_difference(one.pairs, whole.pairs, std::back_inserter(difference));
    all.insert(difference.begin(), difference.end());
  }
  std::vector<std::vector<Subsumption>> lost;
  for (const Closure& one : closures) {
    auto& missing = lost.emplace_back();
    std::ranges::set_difference(whole.pairs, one.pairs, std::back_inserter(missing));
    std::ranges::set_difference(all, one.pairs, std::back_inserter(missing));
    std::erase_if(missing, [&](const Subsumption& pair) { return one.is_empty[static_cast<std::size_t>(pair.sub)]; });
    std::ranges::sort(missing);
  }
  return lost;
}

std::vector<Subsumption> telling(const std::vector<Subsumption>& lost, const Closure& kept, std::size_t most) {
  constexpr std::size_t max_compared = 2'000;  // each is compared with each
  std::vector<Subsumption> shown;
  const std::size_t compared = std::min(lost.size(), max_compared);
  for (std::size_t at = 0; at < compared && shown.size() < most; ++at) {
    const Subsumption& pair = lost[at];
    bool follows = false;
    for (std::size_t other = 0; other < compared && !follows; ++other) {
      if (other == at) continue;
      follows = has(kept, pair.sub, lost[other].sub) && has(kept, lost[other].super, pair.super);
    }
    if (!follows) shown.push_back(pair);
  }
  // Lost ones that follow from each other are all told of, up to the limit.
  for (std::size_t at = 0; at < lost.size() && shown.empty(); ++at) shown.push_back(lost[at]);
  return shown;
}

}  // namespace geminga::ontology
