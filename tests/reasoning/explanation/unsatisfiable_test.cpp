// Root and derived classes among those that can have no instance.
#include "reasoning/explanation/unsatisfiable.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/written.hpp"

namespace geminga::explanation {
namespace {

using owl::loaded;
using testing::ElementsAre;
using testing::IsEmpty;

/// `A` of a root, `A < B` of a class that depends on B.
std::vector<std::string> found_in(std::string_view text) {
  const compiled::Ontology ontology = loaded(text);
  std::vector<std::string> lines;
  for (const Unsatisfiable& one : find_unsatisfiable(ontology, nullptr)) {
    std::string line = ontology.short_name(one.number).substr(2);
    if (one.root) line += " < " + ontology.short_name(*one.root).substr(2);
    lines.push_back(std::move(line));
    EXPECT_FALSE(one.reason.empty()) << lines.back();
  }
  return lines;
}

TEST(Unsatisfiable, ARootHasAMinimalSetAndADerivedClassTheAxiomThatLeadsToIt) {
  const std::string text =
      "SubClassOf(A B)\nSubClassOf(A C)\nDisjointClasses(B C)\nSubClassOf(D A)\n"
      "SubClassOf(E ObjectSomeValuesFrom(r ObjectIntersectionOf(D X)))\nEquivalentClasses(F ObjectUnionOf(A E))\n"
      "SubClassOf(G ObjectMinCardinality(2 r A))\nSubClassOf(H ObjectUnionOf(A X))\n";
  EXPECT_THAT(found_in(text), ElementsAre("A", "D < A", "E < A", "F < A", "G < A"));
  const compiled::Ontology ontology = loaded(text);
  const auto found = find_unsatisfiable(ontology, nullptr);
  EXPECT_EQ(found[0].reason.size(), 3U);
  ASSERT_EQ(found[2].reason.size(), 1U);
  EXPECT_EQ(found[2].reason.front().line, 5U);
}

TEST(Unsatisfiable, AClassThatDependsThroughADomainIsDerivedToo) {
  EXPECT_THAT(found_in("SubClassOf(Z B)\nSubClassOf(Z C)\nDisjointClasses(B C)\n"
                       "SubClassOf(A ObjectSomeValuesFrom(r X))\nObjectPropertyDomain(r Z)\n"),
              ElementsAre("Z", "A < Z"));
}

TEST(Unsatisfiable, InACircleTheOneThatCanHaveNoneByItselfIsTheRoot) {
  EXPECT_THAT(found_in("SubClassOf(A ObjectSomeValuesFrom(r Z))\nSubClassOf(Z ObjectSomeValuesFrom(r A))\n"
                       "SubClassOf(Z B)\nSubClassOf(Z C)\nDisjointClasses(B C)\n"),
              ElementsAre("Z", "A < Z"));
  EXPECT_THAT(found_in("EquivalentClasses(A Z)\nSubClassOf(Z B)\nSubClassOf(Z C)\nDisjointClasses(B C)\n"),
              ElementsAre("Z", "A < Z"));
}

TEST(Unsatisfiable, ClassesWithReasonsOfTheirOwnAreAllRoots) {
  EXPECT_THAT(found_in("SubClassOf(A B)\nSubClassOf(A C)\nSubClassOf(Z B)\nSubClassOf(Z C)\nDisjointClasses(B C)\n"),
              ElementsAre("A", "Z"));
  EXPECT_THAT(found_in(owl::robots), ElementsAre("Impossible"));
  EXPECT_THAT(found_in("SubClassOf(A B)\n"), IsEmpty());
}

TEST(Unsatisfiable, WhereTheBudgetIsSpentTheClassesAreNamedStill) {
  const compiled::Ontology ontology =
      loaded("SubClassOf(A B)\nSubClassOf(A C)\nDisjointClasses(B C)\nSubClassOf(D A)\n");
  base::Budget budget(1);
  while (budget.spend(1)) {
  }
  const auto found = find_unsatisfiable(ontology, &budget);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_THAT(found[0].reason, IsEmpty());
  EXPECT_TRUE(found[1].root);
}

TEST(Unsatisfiable, ReasonsAreLookedForUpToALimit) {
  for (const std::size_t count : {max_explained_classes - 1, max_explained_classes, max_explained_classes + 1}) {
    std::string text = "DisjointClasses(B C)\n";
    for (std::size_t number = 0; number < count; ++number) {
      const std::string name = "A" + std::to_string(number);
      text += "SubClassOf(" + name + " B)\nSubClassOf(" + name + " C)\n";
    }
    const compiled::Ontology ontology = loaded(text);
    std::size_t explained = 0;
    const auto found = find_unsatisfiable(ontology, nullptr);
    for (const Unsatisfiable& one : found) explained += one.reason.empty() ? 0 : 1;
    EXPECT_EQ(found.size(), count);
    EXPECT_EQ(explained, std::min(count, max_explained_classes));
  }
}

}  // namespace
}  // namespace geminga::explanation
