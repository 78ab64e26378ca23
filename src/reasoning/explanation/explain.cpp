// A module is extracted, as far as the rules of EL need it; then a sufficient prefix of it, then a minimal set; last
// comes the order of the argument.
#include "reasoning/explanation/explain.hpp"

#include <array>

namespace geminga::explanation {
namespace {

/// The axioms of a module that are asked about by the rules of EL before it is extracted as a whole. Most reasons are
/// among them, and a module may have tens of thousands.
constexpr std::size_t near_axioms = 512;

/// The minimal subset; or the whole set, if an engine gives up on the subset although it answered for the set. So the
/// result always entails the conclusion.
AxiomSet minimal_of(const AxiomSet& enough, const Holds& holds) {
  AxiomSet minimal = find_minimal(enough, holds);
  return minimal.size() == enough.size() || holds(minimal) ? minimal : enough;
}

}  // namespace

Explainer::Explainer(const compiled::Ontology& ontology, taxonomy::ClassNumber sub, taxonomy::ClassNumber super,
                     Patience patience, base::Budget* budget)
    : module_(ontology, std::array{sub, super}, {}, near_axioms),
      oracle_(module_.source(), patience, budget),
      sub_(module_.term(sub)),
      super_(module_.term(super)) {}

std::optional<AxiomSet> Explainer::find_one() {
  if (module_.is_begun()) {
    // The smallest prefix of the beginning is that of the whole module.
    if (oracle_.find_by_rules(module_.all(), sub_, super_) == el::Entailed::yes) return find_one_of(module_.all());
    module_.complete();
  }
  if (auto found = find_one_of(module_.all())) return found;
  const std::uint32_t known = module_.axiom_count();
  module_.add_rest();
  if (module_.axiom_count() == known) return std::nullopt;
  return find_one_of(module_.all());
}

std::optional<AxiomSet> Explainer::find_one_of(const AxiomSet& candidates) {
  return find_justification(oracle_, candidates, sub_, super_);
}

std::optional<AxiomSet> find_justification(Oracle& oracle, const AxiomSet& candidates, owl::TermId sub,
                                           owl::TermId super) {
  const auto holds = [&](std::span<const std::uint32_t> axioms) { return oracle.holds(axioms, sub, super); };
  const auto follows_by_rules = [&](std::span<const std::uint32_t> axioms) {
    return oracle.find_by_rules(axioms, sub, super) == el::Entailed::yes;
  };
  switch (oracle.find_by_rules(candidates, sub, super)) {
    case el::Entailed::no:
      return std::nullopt;
    case el::Entailed::yes: {
      // It is minimal for the rules. Whether the other engines need even less is asked only of few axioms.
      const auto enough = find_sufficient_prefix(candidates, follows_by_rules);
      if (!enough) return std::nullopt;  // the budget was spent
      return minimal_of(minimal_of(*enough, follows_by_rules), holds);
    }
    case el::Entailed::not_found:
      break;
  }
  const auto enough = find_sufficient_prefix(candidates, holds);
  if (!enough) return std::nullopt;
  return minimal_of(*enough, holds);
}

AllSets Explainer::find_all(const ExplanationLimits& limits, std::size_t max_work) {
  // The first set decides whether the module is enough.
  if (!find_one()) return {};
  module_.complete();
  const std::size_t end = oracle_.work() + max_work;
  return find_all_minimal(
      module_.all(), [this](const AxiomSet& candidates) { return find_one_of(candidates); },
      [this, end] { return oracle_.work() > end || oracle_.is_spent(); }, limits);
}

std::vector<ExplainedAxiom> Explainer::explained(const AxiomSet& axioms) const {
  std::vector<ExplainedAxiom> list;
  for (const std::uint32_t axiom : module_.in_order_of_argument(axioms, sub_)) {
    list.push_back(module_.explained(axiom));
  }
  return list;
}

std::optional<std::vector<ExplainedAxiom>> explain(const compiled::Ontology& ontology, taxonomy::ClassNumber sub,
                                                   taxonomy::ClassNumber super, Patience patience) {
  if (!ontology.is_subsumed(sub, super)) return std::nullopt;
  Explainer explainer(ontology, sub, super, patience);
  const auto found = explainer.find_one();
  if (!found) return std::nullopt;
  return explainer.explained(*found);
}

}  // namespace geminga::explanation
