#include "ontology/repair/loss.hpp"

#include <algorithm>
#include <iterator>
#include <set>

#include "ontology/loading/hierarchy.hpp"
#include "reasoning/reasoner/excerpt.hpp"
#include "reasoning/reasoner/reasoner.hpp"

namespace geminga::ontology {

using taxonomy::ClassNumber;

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
  return closure_of(class_hierarchy(excerpt.source, *classified), numbers_);
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

}  // namespace geminga::ontology
