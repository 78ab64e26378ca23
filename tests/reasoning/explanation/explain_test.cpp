// Minimal sets of axioms for entailments.
#include "reasoning/explanation/explain.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/written.hpp"

namespace geminga::explanation {
namespace {

using compiled::Ontology;
using owl::loaded;
using owl::named;
using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> texts(const std::optional<std::vector<ExplainedAxiom>>& steps) {
  std::vector<std::string> result;
  if (steps) {
    for (const ExplainedAxiom& step : *steps) result.push_back(step.text);
  }
  return result;
}

TEST(Explain, NamesFileAndLineInTheOrderOfTheArgument) {
  const Ontology ontology = loaded(owl::robots);
  const auto steps = explain(ontology, named(ontology, "SharedBallInfo"), named(ontology, "TrackedObject"));
  EXPECT_THAT(texts(steps),
              ElementsAre("t:SharedBallInfo SubClassOf t:BallInfo", "t:BallInfo SubClassOf t:TrackedObject"));
  EXPECT_EQ(steps->at(0).line, 2);
  EXPECT_EQ(steps->at(0).file, "written.ofn");
  EXPECT_THAT(texts(explain(ontology, named(ontology, "Impossible"), *ontology.find("owl:Nothing"))),
              ElementsAre("t:Impossible SubClassOf t:Shared", "t:Impossible SubClassOf t:Secret",
                          "t:Secret DisjointWith t:Shared"));
  EXPECT_FALSE(explain(ontology, named(ontology, "Info"), named(ontology, "BallInfo")).has_value());
  // An entailment of every ontology needs no axiom.
  EXPECT_THAT(texts(explain(ontology, named(ontology, "Info"), *ontology.find("owl:Thing"))), IsEmpty());
  EXPECT_TRUE(explain(ontology, named(ontology, "Info"), named(ontology, "Info")).has_value());
}

/// The walk comes to the last axiom after all others.
TEST(Explain, FindsAReasonBehindTheBeginningOfAModule) {
  for (const std::size_t near : {510U, 511U, 512U, 513U}) {
    std::string axioms;
    for (std::size_t at = 0; at < near; ++at) axioms += "SubClassOf(A F" + std::to_string(at) + ")\n";
    axioms += "SubClassOf(F" + std::to_string(near - 1) + " Last)\n";
    const Ontology ontology = loaded(axioms);
    Explainer explainer(ontology, named(ontology, "A"), named(ontology, "Last"));
    const auto found = explainer.find_one();
    ASSERT_TRUE(found.has_value()) << near;
    EXPECT_EQ(found->size(), 2) << near;
    EXPECT_EQ(explainer.find_all().sets.size(), 1) << near;
    EXPECT_EQ(explainer.module().axiom_count(), near + 1) << near;
  }
}

TEST(Explain, WritesAxiomsSoThatOneCanReadThem) {
  const struct {
    const char* axioms;
    const char* sub;
    const char* super;
    std::vector<std::string> steps;
  } cases[] = {
      {"EquivalentClasses(A ObjectIntersectionOf(B ObjectSomeValuesFrom(r ObjectIntersectionOf(C D))))",
       "A",
       "B",
       {"t:A EquivalentTo t:B and (t:r some (t:C and t:D))"}},
      {"SubClassOf(A ObjectHasValue(r i:x))\nClassAssertion(B i:x)\nSubClassOf(ObjectSomeValuesFrom(r B) C)",
       "A",
       "C",
       {"t:A SubClassOf t:r value t:x", "t:x Type t:B", "t:r some t:B SubClassOf t:C"}},
      {"ObjectPropertyDomain(r C)\nSubObjectPropertyOf(ObjectPropertyChain(s s) r)\n"
       "SubClassOf(A ObjectSomeValuesFrom(s ObjectSomeValuesFrom(s B)))",
       "A",
       "C",
       {"t:A SubClassOf t:s some (t:s some t:B)", "t:s o t:s SubPropertyOf t:r", "t:r Domain t:C"}},
      {"SubClassOf(A ObjectMinCardinality(1 r B))\nObjectPropertyDomain(r ObjectIntersectionOf(C D))",
       "A",
       "C",
       {"t:A SubClassOf t:r min 1 t:B", "t:r Domain t:C and t:D"}},
  };
  for (const auto& one : cases) {
    const Ontology ontology = loaded(one.axioms);
    EXPECT_EQ(texts(explain(ontology, named(ontology, one.sub), named(ontology, one.super))), one.steps) << one.axioms;
  }
}

TEST(Explain, FindsTheContradictionFromWhichEverythingFollows) {
  const Ontology ontology = loaded("ClassAssertion(A i:a)\nSubClassOf(A Nothing)\nSubClassOf(B C)");
  EXPECT_FALSE(ontology.is_consistent());
  EXPECT_THAT(texts(explain(ontology, named(ontology, "C"), named(ontology, "B"))),
              ElementsAre("t:a Type t:A", "t:A SubClassOf owl:Nothing"));
}

}  // namespace
}  // namespace geminga::explanation
