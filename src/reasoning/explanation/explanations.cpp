// The tree is built breadth first; labels are reused, and no node is visited twice.
#include "reasoning/explanation/explanations.hpp"

#include <algorithm>
#include <deque>
#include <set>
#include <utility>

namespace geminga::explanation {
namespace {

/// True if all numbers of one ascending list are in the other.
bool is_part(const AxiomSet& part, const AxiomSet& whole) { return std::ranges::includes(whole, part); }

bool is_disjoint(const AxiomSet& one, const AxiomSet& other) {
  return std::ranges::none_of(one, [&](std::uint32_t axiom) { return std::ranges::binary_search(other, axiom); });
}

class Tree {
 public:
  Tree(const AxiomSet& candidates, const FindOne& find_one, const IsSpent& is_spent, const ExplanationLimits& limits)
      : candidates_(candidates), find_one_(find_one), is_spent_(is_spent), limits_(limits) {}

  AllSets run() {
    AllSets result;
    push({});
    while (!open_.empty()) {
      // One more set is looked for, to know whether there are others.
      const bool is_over = sets_.size() > limits_.sets;
      if (is_over) sets_.pop_back();
      if (is_over || seen_.size() > limits_.nodes || (!sets_.empty() && is_spent_())) {
        result.may_have_more = true;
        break;
      }
      const AxiomSet removed = std::move(open_.front());
      open_.pop_front();
      expand(removed);
    }
    result.sets = std::move(sets_);
    std::ranges::sort(result.sets, [](const AxiomSet& one, const AxiomSet& other) {
      return one.size() != other.size() ? one.size() < other.size() : one < other;
    });
    return result;
  }

 private:
  void push(AxiomSet removed) {
    // If the question did not hold when fewer axioms were taken away, it does not hold here.
    if (std::ranges::any_of(closed_, [&](const AxiomSet& less) { return is_part(less, removed); })) return;
    if (seen_.insert(removed).second) open_.push_back(std::move(removed));
  }

  void expand(const AxiomSet& removed) {
    const auto known = std::ranges::find_if(sets_, [&](const AxiomSet& set) { return is_disjoint(set, removed); });
    AxiomSet label;
    if (known != sets_.end()) {
      label = *known;
    } else {
      AxiomSet left;
      std::ranges::copy_if(candidates_, std::back_inserter(left),
                           [&](std::uint32_t axiom) { return !std::ranges::binary_search(removed, axiom); });
      auto found = find_one_(left);
      if (!found) {
        closed_.push_back(removed);
        return;
      }
      label = std::move(*found);
      sets_.push_back(label);
    }
    for (const std::uint32_t axiom : label) {
      AxiomSet more = removed;
      more.insert(std::ranges::lower_bound(more, axiom), axiom);
      push(std::move(more));
    }
  }

  const AxiomSet& candidates_;
  const FindOne& find_one_;
  const IsSpent& is_spent_;
  const ExplanationLimits& limits_;
  std::deque<AxiomSet> open_;
  std::set<AxiomSet> seen_;
  std::vector<AxiomSet> closed_;
  std::vector<AxiomSet> sets_;
};

}  // namespace

AllSets find_all_minimal(const AxiomSet& candidates, const FindOne& find_one, const IsSpent& is_spent,
                         const ExplanationLimits& limits) {
  return Tree(candidates, find_one, is_spent, limits).run();
}

}  // namespace geminga::explanation
