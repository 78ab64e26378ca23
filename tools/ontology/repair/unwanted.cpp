#include "ontology/repair/unwanted.hpp"

#include <algorithm>
#include <string_view>
#include <unordered_set>
#include <utility>

#include "reasoning/explanation/explain.hpp"
#include "reasoning/reasoner/excerpt.hpp"
#include "reasoning/reasoner/reasoner.hpp"

namespace geminga::ontology {
namespace {

using explanation::AxiomSet;
using reasoner::Verdict;
using taxonomy::ClassNumber;

std::vector<ClassNumber> with(std::vector<ClassNumber> classes, ClassNumber one) {
  classes.push_back(one);
  return classes;
}

}  // namespace

Unwanted::Unwanted(const compiled::Ontology& ontology, std::vector<ClassNumber> subs, ClassNumber super,
                   base::Budget& budget)
    : ontology_(ontology),
      subs_(std::move(subs)),
      super_(super),
      budget_(budget),
      module_(ontology, with(subs_, super)),
      oracle_(module_.source(), explanation::Patience::of_a_person, &budget) {}

AxiomSet Unwanted::left(const AxiomSet& removed) const {
  AxiomSet axioms = module_.all();
  std::erase_if(axioms, [&](std::uint32_t axiom) { return std::ranges::binary_search(removed, axiom); });
  return axioms;
}

Following Unwanted::following_without(const AxiomSet& removed) {
  Following following;
  const AxiomSet axioms = left(removed);
  if (subs_.size() == 1) {
    const Verdict verdict =
        reasoner::entails(module_.source(), axioms, module_.term(subs_.front()), module_.term(super_), &budget_)
            .verdict;
    if (verdict == Verdict::yes) following.certain.push_back({subs_.front(), super_});
    following.may_be_more = verdict == Verdict::unknown;
    return following;
  }
  const reasoner::Excerpt excerpt(module_.source(), axioms);
  const auto classified = reasoner::classify(excerpt.source, {.budget = &budget_});
  if (!classified) return {.certain = {}, .may_be_more = true};
  std::unordered_set<std::string_view> empty;
  for (std::size_t number = 0; number < classified->class_count(); ++number) {
    const bool is_empty =
        !classified->is_consistent ||
        classified->representative[number] == classified->representative[static_cast<std::size_t>(classified->nothing)];
    if (is_empty) empty.insert(excerpt.source.name(classified->classes[number]));
  }
  for (const ClassNumber sub : subs_) {
    if (empty.contains(ontology_.iri(sub))) following.certain.push_back({sub, super_});
  }
  following.may_be_more = !classified->gaps.empty() || !classified->unused.empty();
  return following;
}

std::optional<AxiomSet> Unwanted::reason_without(const Subsumption& one, const AxiomSet& removed) {
  return find_justification(oracle_, left(removed), module_.term(one.sub), module_.term(one.super));
}

}  // namespace geminga::ontology
