#include "ontology/comparison/consequences.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <string_view>

#include "ontology/loading/closure.hpp"
#include "ontology/loading/hierarchy.hpp"
#include "reasoning/explanation/explain.hpp"
#include "reasoning/owl/datatypes.hpp"

namespace geminga::ontology {
namespace {

using taxonomy::ClassNumber;

/// The classes of both ontologies with numbers in the order of their IRIs.
class Classes {
 public:
  Classes(const Hierarchy& before, const Hierarchy& after) {
    std::ranges::merge(before.iris, after.iris, std::back_inserter(iris_));
    iris_.erase(std::ranges::unique(iris_).begin(), iris_.end());
    for (std::uint32_t number = 0; number < iris_.size(); ++number) numbers_.emplace(iris_[number], number);
    is_common_.resize(iris_.size());
    for (const std::string_view iri : before.iris)
      is_common_[numbers_.at(iri)] = std::ranges::binary_search(after.iris, iri);
  }

  [[nodiscard]] const ClassNumbers& numbers() const { return numbers_; }
  [[nodiscard]] std::size_t count() const { return iris_.size(); }
  [[nodiscard]] std::string iri(ClassNumber number) const {
    return std::string(iris_[static_cast<std::size_t>(number)]);
  }
  [[nodiscard]] bool is_common(ClassNumber number) const { return is_common_[static_cast<std::size_t>(number)]; }

 private:
  std::vector<std::string_view> iris_;
  ClassNumbers numbers_;
  std::vector<bool> is_common_;
};

/// Looks for the reasons of subsumptions of one ontology, and marks the axioms that another one lacks.
class Reasons {
 public:
  Reasons(const Compared& ontology, const owl::Ontology& other, std::size_t most, base::Budget& budget)
      : ontology_(ontology.ontology), other_(other), most_(most), budget_(budget) {}

  void find(std::vector<Different>& list) {
    std::size_t found = 0;
    for (Different& one : list) {
      if (!one.is_telling || budget_.is_spent() || found++ == most_) return;
      one.reason = reason_of(one);
    }
  }

 private:
  std::vector<ReasonAxiom> reason_of(const Different& one) {
    const auto sub = ontology_.find_iri(one.sub);
    const auto super = ontology_.find_iri(one.super);
    if (!sub || !super) return {};
    explanation::Explainer explainer(ontology_, *sub, *super, explanation::Patience::of_a_person, &budget_);
    const auto set = explainer.find_one();
    if (!set) return {};
    const owl::Ontology& source = explainer.module().source();
    const Contents contents(source);
    std::vector<ReasonAxiom> reason;
    for (const std::uint32_t axiom : explainer.module().in_order_of_argument(*set, explainer.sub()))
      reason.push_back({explainer.module().explained(axiom), !other_.has(contents, source.axiom(axiom))});
    return reason;
  }

  const compiled::Ontology& ontology_;
  const Axioms other_;
  std::size_t most_;
  base::Budget& budget_;
};

/// The subsumptions between common classes that can have instances in both, which one closure has and the other has
/// not.
std::vector<Different> beyond(const Closure& one, const Closure& other, const Classes& classes) {
  std::vector<Subsumption> different;
  std::ranges::set_difference(one.pairs, other.pairs, std::back_inserter(different));
  std::erase_if(different, [&](const Subsumption& pair) {
    return !classes.is_common(pair.sub) || !classes.is_common(pair.super) ||
           other.is_empty[static_cast<std::size_t>(pair.sub)];
  });
  Closure both;
  std::ranges::set_intersection(one.pairs, other.pairs, std::back_inserter(both.pairs));
  const std::vector<Subsumption> shown = telling(different, both, different.size());
  std::vector<Different> list;
  for (const bool is_telling : {true, false}) {
    for (const Subsumption& pair : different) {
      if (std::ranges::binary_search(shown, pair) == is_telling)
        list.push_back({classes.iri(pair.sub), classes.iri(pair.super), is_telling, {}});
    }
  }
  return list;
}

/// The classes that can have no instance in one ontology and can in the other, or are not in it where `with_new`.
std::vector<Different> emptied(const Closure& in, const Closure& before, const Classes& classes, bool with_new) {
  std::vector<Different> list;
  for (std::uint32_t number = 0; number < classes.count(); ++number) {
    const ClassNumber one{number};
    if (!in.is_empty[number] || before.is_empty[number] || (!with_new && !classes.is_common(one))) continue;
    list.push_back({classes.iri(one), std::string(owl::owl_nothing), true, {}});
  }
  return list;
}

}  // namespace

ChangedConsequences compare_consequences(const Compared& before, const Compared& after, std::size_t reasons,
                                         base::Budget& budget) {
  ChangedConsequences changed;
  const reasoner::Classified& was = before.files.classification;
  const reasoner::Classified& is = after.files.classification;
  changed.may_miss = !was.gaps.empty() || !was.unused.empty() || !is.gaps.empty() || !is.unused.empty();
  changed.is_compared = was.is_consistent && is.is_consistent;
  if (!changed.is_compared) return changed;
  const Hierarchy old_hierarchy = class_hierarchy(before.files.loaded.source, was);
  const Hierarchy new_hierarchy = class_hierarchy(after.files.loaded.source, is);
  const Classes classes(old_hierarchy, new_hierarchy);
  const auto old_closure = closure_of(old_hierarchy, classes.numbers());
  const auto new_closure = closure_of(new_hierarchy, classes.numbers());
  changed.is_compared = old_closure && new_closure;
  if (!changed.is_compared) return changed;
  changed.gained = beyond(*new_closure, *old_closure, classes);
  changed.lost = beyond(*old_closure, *new_closure, classes);
  changed.emptied = emptied(*new_closure, *old_closure, classes, true);
  changed.filled = emptied(*old_closure, *new_closure, classes, false);
  Reasons in_new(after, before.files.loaded.source, reasons, budget);
  Reasons in_old(before, after.files.loaded.source, reasons, budget);
  in_new.find(changed.emptied);
  in_new.find(changed.gained);
  in_old.find(changed.filled);
  in_old.find(changed.lost);
  return changed;
}

}  // namespace geminga::ontology
