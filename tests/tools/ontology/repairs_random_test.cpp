// Random ontologies: each choice undoes everything that is unwanted, and none of its parts does.
#include <gtest/gtest.h>

#include <algorithm>

#include "base/random.hpp"
#include "ontology/repair/repairs.hpp"
#include "reasoning/explanation/unsatisfiable.hpp"
#include "support/reference.hpp"
#include "support/rounds.hpp"
#include "support/written.hpp"

namespace geminga::ontology {
namespace {

using explanation::AxiomSet;

/// Axioms of each group but one: those of their first choices.
AxiomSet first_of_others(const Repairs& repairs, std::size_t but) {
  AxiomSet axioms;
  for (std::size_t at = 0; at < repairs.groups.size(); ++at) {
    if (at == but) continue;
    const AxiomSet& first = repairs.groups[at].choices.front();
    axioms.insert(axioms.end(), first.begin(), first.end());
  }
  return axioms;
}

bool undoes_all(Unwanted& unwanted, AxiomSet removed, const AxiomSet& more) {
  removed.insert(removed.end(), more.begin(), more.end());
  std::ranges::sort(removed);
  return unwanted.following_without(removed).certain.empty();
}

TEST(RandomRepairs, UndoWhatIsUnwantedAndNoPartOfThemDoes) {
  int repaired = 0;
  for (std::uint64_t seed = 1; seed <= test::rounds(std::uint64_t{300}); ++seed) {
    base::Random random(seed);
    std::string text = owl::random_ontology(random, 12);
    text += "\nDisjointClasses(C0 C1)\nDisjointClasses(C1 C2)\n";
    SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + text);
    const compiled::Ontology ontology = owl::loaded(text);
    std::vector<taxonomy::ClassNumber> subs;
    if (!ontology.is_consistent()) continue;
    for (const auto& one : explanation::find_unsatisfiable(ontology, nullptr)) subs.push_back(one.number);
    if (subs.empty()) continue;
    base::Budget budget;
    Unwanted unwanted(ontology, subs, *ontology.find("owl:Nothing"), budget);
    const Repairs repairs = find_repairs(unwanted, {}, budget);
    ASSERT_FALSE(repairs.groups.empty());
    ++repaired;
    for (std::size_t at = 0; at < repairs.groups.size(); ++at) {
      const AxiomSet others = first_of_others(repairs, at);
      ASSERT_FALSE(repairs.groups[at].choices.empty());
      for (const AxiomSet& choice : repairs.groups[at].choices) {
        EXPECT_TRUE(undoes_all(unwanted, choice, others));
        for (const std::uint32_t axiom : choice) {
          AxiomSet part = choice;
          std::erase(part, axiom);
          EXPECT_FALSE(undoes_all(unwanted, part, others)) << "axiom " << axiom << " need not be taken out";
        }
      }
    }
  }
  EXPECT_GT(repaired, test::rounds(50));
}

}  // namespace
}  // namespace geminga::ontology
