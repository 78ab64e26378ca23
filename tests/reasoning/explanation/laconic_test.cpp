// Explanations without superfluous parts.
#include "reasoning/explanation/laconic.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reasoning/reasoner/reasoner.hpp"
#include "support/written.hpp"

namespace geminga::explanation {
namespace {

using compiled::Ontology;
using owl::loaded;
using owl::named;
using testing::ElementsAre;
using testing::UnorderedElementsAre;

struct Case {
  const char* axioms;
  const char* sub;
  const char* super;
  std::vector<std::string> parts;
};

/// Explains a subsumption by parts. Each part must follow from its whole, and the conclusion from the parts.
std::vector<std::string> parts_of(const Case& one) {
  const Ontology ontology = loaded(one.axioms);
  const auto super =
      std::string_view(one.super) == "Nothing" ? *ontology.find("owl:Nothing") : named(ontology, one.super);
  Explainer explainer(ontology, named(ontology, one.sub), super);
  const auto set = explainer.find_one();
  if (!set) return {"not entailed"};
  const Laconic laconic = find_laconic(explainer, *set);
  EXPECT_TRUE(laconic.is_laconic);
  std::vector<std::string> texts;
  AxiomSet parts;
  const owl::Ontology& source = explainer.module().source();
  for (const Laconic::PartOf& part : laconic.parts) {
    texts.push_back(explainer.module().explained(part.axiom).text);
    parts.push_back(part.axiom);
    const AxiomSet whole = {part.whole};
    const AxiomSet conclusion = {part.axiom};
    EXPECT_EQ(reasoner::entails_each(source, whole, conclusion).front().verdict, reasoner::Verdict::yes)
        << texts.back() << " does not follow from " << explainer.module().explained(part.whole).text;
    EXPECT_EQ(source.axiom(part.axiom).line, source.axiom(part.whole).line);
  }
  EXPECT_EQ(reasoner::entails(source, parts, explainer.sub(), explainer.super()).verdict, reasoner::Verdict::yes);
  return texts;
}

TEST(Laconic, LeavesOutWhatIsNotNeeded) {
  const Case cases[] = {
      {"SubClassOf(A ObjectIntersectionOf(B C D))\nSubClassOf(B E)",
       "A",
       "E",
       {"t:A SubClassOf t:B", "t:B SubClassOf t:E"}},
      {"EquivalentClasses(A ObjectIntersectionOf(B ObjectSomeValuesFrom(r C)))\nObjectPropertyDomain(r D)",
       "A",
       "D",
       {"t:A SubClassOf t:r some owl:Thing", "ObjectPropertyDomain"}},
      {"SubClassOf(A ObjectSomeValuesFrom(r ObjectIntersectionOf(B C)))\nSubClassOf(ObjectSomeValuesFrom(r B) D)",
       "A",
       "D",
       {"t:A SubClassOf t:r some t:B", "t:r some t:B SubClassOf t:D"}},
      {"SubClassOf(A B)\nSubClassOf(ObjectUnionOf(B C) D)", "A", "D", {"t:A SubClassOf t:B", "t:B SubClassOf t:D"}},
      {"SubClassOf(A ObjectMinCardinality(5 r B))\nSubClassOf(ObjectSomeValuesFrom(r B) C)",
       "A",
       "C",
       {"t:A SubClassOf t:r min 1 t:B", "t:r some t:B SubClassOf t:C"}},
      {"SubClassOf(A B)\nSubClassOf(A C)\nDisjointClasses(D C B E)",
       "A",
       "Nothing",
       {"t:A SubClassOf t:B", "t:A SubClassOf t:C", "t:B DisjointWith t:C"}},
      {"SubClassOf(A B)\nDisjointUnion(C B D)", "A", "C", {"t:A SubClassOf t:B", "t:B SubClassOf t:C"}},
  };
  for (const Case& one : cases) {
    SCOPED_TRACE(one.axioms);
    const std::vector<std::string> parts = parts_of(one);
    if (one.parts.back() == "ObjectPropertyDomain") {
      EXPECT_THAT(parts, UnorderedElementsAre(one.parts.front(), "t:r Domain t:D"));
    } else {
      EXPECT_THAT(parts, testing::UnorderedElementsAreArray(one.parts));
    }
  }
}

TEST(Laconic, AnAxiomThatIsNeededAsAWholeStaysOne) {
  const Case one = {"EquivalentClasses(A ObjectIntersectionOf(B C))\nSubClassOf(D B)\nSubClassOf(D C)", "D", "A", {}};
  EXPECT_THAT(parts_of(one),
              UnorderedElementsAre("t:D SubClassOf t:B", "t:D SubClassOf t:C", "t:B and t:C SubClassOf t:A"));
  const Ontology ontology = loaded(owl::robots);
  Explainer explainer(ontology, named(ontology, "SharedBallInfo"), named(ontology, "TrackedObject"));
  const Laconic laconic = find_laconic(explainer, *explainer.find_one());
  EXPECT_THAT(laconic.parts, ElementsAre(testing::Field(&Laconic::PartOf::is_whole, true),
                                         testing::Field(&Laconic::PartOf::is_whole, true)));
}

TEST(Laconic, AnEmptySetHasNoParts) {
  const Ontology ontology = loaded(owl::robots);
  Explainer explainer(ontology, named(ontology, "Info"), named(ontology, "Info"));
  EXPECT_TRUE(find_laconic(explainer, {}).parts.empty());
}

TEST(Laconic, WhereTheBudgetIsSpentTheSetStaysAsItIs) {
  const Ontology ontology = loaded("SubClassOf(A ObjectIntersectionOf(B C))");
  base::Budget budget(1'000);
  Explainer explainer(ontology, named(ontology, "A"), named(ontology, "B"), Patience::of_a_person, &budget);
  const auto set = explainer.find_one();
  ASSERT_TRUE(set);
  (void)budget.spend(1'000);
  const Laconic laconic = find_laconic(explainer, *set);
  EXPECT_FALSE(laconic.is_laconic);
  ASSERT_EQ(laconic.parts.size(), 1U);
  EXPECT_TRUE(laconic.parts.front().is_whole);
}

}  // namespace
}  // namespace geminga::explanation
