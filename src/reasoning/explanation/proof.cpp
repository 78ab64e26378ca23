// The conclusions of a search become steps that people read.
#include "reasoning/explanation/proof.hpp"

#include <algorithm>
#include <map>

#include "base/sorted.hpp"
#include "reasoning/explanation/proof_lemmas.hpp"

namespace geminga::explanation {
namespace {

using owl::AxiomKind;
using owl::TermId;

/// Numbers the conclusions that the goal needs, and leaves out trivial ones.
class Writer {
 public:
  Writer(Explainer& explainer, ProofSearch& search, const AxiomSet& axioms)
      : explainer_(explainer), search_(search), axioms_(axioms) {}

  Proof run(std::uint32_t goal) {
    proof_.axioms = axioms_;
    if (conclusion(goal).rule == ProofRule::trivial) return std::move(proof_);
    count_uses(goal);
    write(goal);
    return std::move(proof_);
  }

 private:
  /// A premise: an axiom by its place, or a conclusion that is a step of its own.
  struct Premises {
    std::vector<std::uint32_t> numbers;
    ProofRule rule = ProofRule::subclass;
  };

  [[nodiscard]] const Conclusion& conclusion(std::uint32_t number) const { return search_.conclusions()[number]; }

  void count_uses(std::uint32_t goal) {
    std::vector<std::uint32_t> open = {goal};
    uses_[goal] = 1;
    while (!open.empty()) {
      const std::uint32_t at = open.back();
      open.pop_back();
      for (const std::uint32_t step : conclusion(at).steps) {
        if (uses_[step]++ == 0) open.push_back(step);
      }
    }
  }

  [[nodiscard]] std::uint32_t number_of_axiom(std::uint32_t axiom) const {
    return static_cast<std::uint32_t>(std::ranges::find(axioms_, axiom) - axioms_.begin()) + 1;
  }

  /// True if a conclusion repeats its one axiom.
  [[nodiscard]] bool is_axiom(const Conclusion& one) {
    if (one.rule != ProofRule::subclass || one.axioms.size() != 1 || one.steps.size() > 1) return false;
    if (!one.steps.empty() && conclusion(one.steps[0]).rule != ProofRule::trivial) return false;
    const owl::Axiom axiom = explainer_.module().source().axiom(one.axioms[0]);
    switch (axiom.kind) {
      case AxiomKind::sub_class_of:
        return true;
      case AxiomKind::class_assertion:
      case AxiomKind::object_property_assertion:
      case AxiomKind::data_property_assertion: {
        // The inverse of an assertion follows from the axiom, but does not repeat it.
        const TermId individual = axiom.arguments[1];
        return explainer_.module().source().term(one.sub).arguments[0] == individual;
      }
      default:
        return false;
    }
  }

  [[nodiscard]] static bool is_plain(ProofRule rule) {
    return rule == ProofRule::subclass || rule == ProofRule::conjunct;
  }

  /// True if a plain conclusion comes from one axiom alone. It is repeated where it is needed, and gets no number.
  [[nodiscard]] bool says_one_axiom(std::uint32_t number) const {
    const Conclusion& one = conclusion(number);
    return one.axioms.size() == 1 && std::ranges::all_of(one.steps, [&](std::uint32_t step) {
             return conclusion(step).rule == ProofRule::trivial;
           });
  }

  /// The premises of a conclusion. Plain steps that no other step needs are replaced by their own premises. Recursion
  /// is bounded by the number of earlier conclusions.
  Premises premises_of(std::uint32_t number) {
    const Conclusion one = conclusion(number);
    Premises premises{{}, one.rule};
    for (const std::uint32_t axiom : one.axioms) premises.numbers.push_back(number_of_axiom(axiom));
    for (const std::uint32_t step : one.steps) {
      const Conclusion& before = conclusion(step);
      if (before.rule == ProofRule::trivial) continue;
      const bool may_merge = is_plain(one.rule) && is_plain(before.rule) && !is_axiom(before);
      if (may_merge && (uses_[step] == 1 || says_one_axiom(step))) {
        const Premises inner = premises_of(step);
        premises.numbers.insert(premises.numbers.end(), inner.numbers.begin(), inner.numbers.end());
        if (inner.rule == ProofRule::conjunct) premises.rule = inner.rule;
      } else {
        premises.numbers.push_back(write(step));
      }
    }
    base::sort_unique(premises.numbers);
    return premises;
  }

  /// Writes a conclusion after its premises, and returns its number in the proof.
  std::uint32_t write(std::uint32_t number) {
    if (const auto known = written_.find(number); known != written_.end()) return known->second;
    const Conclusion one = conclusion(number);
    std::uint32_t& place = written_[number];
    if (is_axiom(one)) return place = number_of_axiom(one.axioms[0]);
    Premises premises = premises_of(number);
    const auto shorten = [&](std::string_view iri) { return explainer_.module().ontology().short_name(iri); };
    proof_.steps.push_back({search_.terms().readable(one.sub, one.super, shorten), premises.rule,
                            std::move(premises.numbers), one.sub, one.super});
    return place = static_cast<std::uint32_t>(axioms_.size() + proof_.steps.size());
  }

  Explainer& explainer_;
  ProofSearch& search_;
  const AxiomSet& axioms_;
  Proof proof_;
  std::map<std::uint32_t, std::uint32_t> uses_;
  std::map<std::uint32_t, std::uint32_t> written_;
};

}  // namespace

Proof prove(Explainer& explainer, const AxiomSet& set) {
  const AxiomSet axioms = explainer.module().in_order_of_argument(set, explainer.sub());
  ProofSearch search(explainer.module().source(), axioms, explainer.sub(), explainer.super());
  auto goal = search.run();
  if (!goal) {
    goal =
        ProofLemmas(explainer.module(), explainer.oracle()).bridge(search, axioms, explainer.sub(), explainer.super());
  }
  return Writer(explainer, search, axioms).run(*goal);
}

}  // namespace geminga::explanation
