// Finds common superclasses in the taxonomy, and requirements in the axioms about the broader class.
#include "reasoning/explanation/why_not.hpp"

#include <algorithm>
#include <array>

#include "reasoning/explanation/proof_lemmas.hpp"
#include "reasoning/modules/module.hpp"
#include "reasoning/owl/left_out.hpp"

namespace geminga::explanation {
namespace {

using owl::AxiomKind;
using owl::TermId;
using owl::TermKind;
using taxonomy::ClassNumber;

constexpr std::size_t max_ways = 8;
constexpr std::size_t max_requirements = 24;  ///< of one axiom; each is a question to the engines

std::vector<ClassNumber> most_specific_common(const compiled::Ontology& ontology, ClassNumber sub, ClassNumber super) {
  const std::vector<ClassNumber> one = ontology.subsumers(sub);
  const std::vector<ClassNumber> other = ontology.subsumers(super);
  std::vector<ClassNumber> common;
  std::ranges::set_intersection(one, other, std::back_inserter(common));
  // Superclasses of a common superclass are common, too. So the parents of a common superclass are not the most
  // specific ones.
  std::vector<ClassNumber> above;
  for (const ClassNumber number : common) {
    for (const ClassNumber parent : ontology.parents(number)) above.push_back(parent);
  }
  std::ranges::sort(above);
  std::vector<ClassNumber> lowest;
  for (const ClassNumber number : common) {
    const auto is_same = [&](ClassNumber known) { return ontology.is_equivalent(known, number); };
    const bool is_above =
        std::ranges::any_of(above, [&](ClassNumber parent) { return ontology.is_equivalent(parent, number); });
    if (!is_above && std::ranges::none_of(lowest, is_same)) lowest.push_back(number);
  }
  return lowest;
}

/// An axiom of the compiled form that says what a class is, and the side of the axiom that is not the class.
struct Found {
  std::uint32_t axiom = 0;
  std::uint32_t side = 0;
  bool is_sufficient = false;
};

/// Definitions first, then expressions that are included in the class, then expressions that include it.
std::vector<Found> find_axioms(const taxonomy::ClassifiedView& view, std::uint32_t term) {
  std::vector<Found> definitions;
  std::vector<Found> inclusions;
  std::vector<Found> necessary;
  for (std::uint32_t axiom = 0; axiom < view.axiom_count(); ++axiom) {
    const AxiomKind kind = view.kind_of_axiom(axiom);
    if (kind != AxiomKind::sub_class_of && kind != AxiomKind::equivalent_classes) continue;
    const auto arguments = view.arguments_of_axiom(axiom);
    if (kind == AxiomKind::sub_class_of) {
      const bool is_named = view.kind_of_term(arguments[0]) == TermKind::named_class;
      if (arguments[1] == term && !is_named) inclusions.push_back({axiom, arguments[0], true});
      if (arguments[0] == term) necessary.push_back({axiom, arguments[1], false});
    } else if (std::ranges::find(arguments, term) != arguments.end()) {
      for (const std::uint32_t side : arguments) {
        if (side != term) definitions.push_back({axiom, side, true});
      }
    }
  }
  definitions.insert(definitions.end(), inclusions.begin(), inclusions.end());
  definitions.insert(definitions.end(), necessary.begin(), necessary.end());
  return definitions;
}

/// Asks the engines which part of a requirement is met.
class Judge {
 public:
  Judge(Module& module, TermId sub, Patience patience)
      : module_(module), oracle_(module.source(), patience), engines_(module, oracle_), sub_(sub) {}

  Requirement judge(TermId required) {
    Requirement requirement{module_.print(required), follows(required), {}};
    if (requirement.is_met) return requirement;
    const owl::Term term = module_.source().term(required);
    if (term.kind == TermKind::object_some_values_from && term.arguments[1] != owl::thing_term) {
      const TermId role = term.arguments[0];
      const TermId filler = term.arguments[1];
      const TermId any = module_.source().term(TermKind::object_some_values_from, {role, owl::thing_term});
      if (follows(any)) {
        requirement.remark = "it has " + module_.print(role) + ", but to nothing that is known to be " + nested(filler);
      }
    }
    return requirement;
  }

  /// The conjuncts, or the class itself.
  std::vector<TermId> conjuncts(TermId side) {
    const owl::Term term = module_.source().term(side);
    if (term.kind != TermKind::object_intersection_of) return {side};
    return {term.arguments.begin(), term.arguments.end()};
  }

  /// Axioms by which the two classes are disjoint.
  std::optional<AxiomSet> find_exclusion(TermId super) {
    const TermId both = module_.source().term(TermKind::object_intersection_of, {sub_, super});
    return engines_.find(module_.all(), both, owl::nothing_term);
  }

 private:
  bool follows(TermId super) { return engines_.holds(module_.all(), sub_, super); }
  std::string nested(TermId term) {
    const std::string text = module_.print(term);
    return text.find(' ') == std::string::npos ? text : "(" + text + ")";
  }

  Module& module_;
  Oracle oracle_;
  ProofLemmas engines_;
  TermId sub_;
};

}  // namespace

std::size_t Way::missing_count() const {
  return static_cast<std::size_t>(std::ranges::count(requirements, false, &Requirement::is_met));
}

WhyNot why_not(const compiled::Ontology& ontology, ClassNumber sub, ClassNumber super, Patience patience) {
  WhyNot result;
  result.common = most_specific_common(ontology, sub, super);
  result.may_be_incomplete = !ontology.left_out().empty() || !ontology.gaps().empty();
  std::vector<Found> found;
  if (const auto term = ontology.module_index().term_of(super)) found = find_axioms(ontology.axioms(), *term);
  if (found.size() > max_ways) {
    found.resize(max_ways);
    result.has_more_ways = true;
  }
  std::vector<std::uint32_t> sides;
  for (const Found& one : found) sides.push_back(one.side);
  Module module(ontology, std::array{sub, super}, sides);
  Judge judge(module, module.term(sub), patience);
  for (const Found& one : found) {
    Way way{module.explained_original(one.axiom), one.is_sufficient, {}};
    std::vector<TermId> conjuncts = judge.conjuncts(module.copy_term(one.side));
    conjuncts.resize(std::min(conjuncts.size(), max_requirements));
    for (const TermId conjunct : conjuncts) way.requirements.push_back(judge.judge(conjunct));
    result.ways.push_back(std::move(way));
  }
  std::ranges::stable_sort(result.ways, {}, [](const Way& way) {
    return std::pair(!way.is_sufficient, way.is_sufficient ? way.missing_count() : 0);
  });
  if (ontology.is_satisfiable(super)) {
    if (const auto axioms = judge.find_exclusion(module.term(super))) {
      result.is_excluded = true;
      for (const std::uint32_t axiom : module.in_order_of_argument(*axioms, module.term(sub))) {
        result.exclusion.push_back(module.explained(axiom));
      }
    }
  }
  return result;
}

}  // namespace geminga::explanation
