// Classification by all engines together: what it finds beyond EL, and what it says where it is not sure.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "reasoning/compiled/compile.hpp"
#include "reasoning/dl/clauses/clausify.hpp"
#include "reasoning/reasoner/completion.hpp"
#include "reasoning/reasoner/reasoner.hpp"
#include "reasoning/reasoner/taxonomy.hpp"
#include "support/written.hpp"

namespace geminga::reasoner {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Classified by_all_engines(const owl::Ontology& source) {
  auto result = classify(source);
  if (!result) ADD_FAILURE() << result.error().text;
  return std::move(result).value();
}

std::vector<std::string> closure(const owl::Ontology& source, const taxonomy::Classification& classification) {
  auto ontology = compiled::Ontology::from_bytes(compiled::compile(source, classification));
  if (!ontology) ADD_FAILURE() << ontology.error().text;
  return owl::closure(*ontology);
}

std::vector<std::string> closure(std::string_view text) {
  const owl::Ontology source = owl::written(text);
  const Classified found = by_all_engines(source);
  EXPECT_THAT(found.unused, IsEmpty()) << text;
  EXPECT_THAT(found.gaps, IsEmpty()) << text;
  return closure(source, found);
}

TEST(Classification, FindsWhatFollowsByCases) {
  EXPECT_THAT(closure("SubClassOf(A ObjectUnionOf(B C))\nSubClassOf(B D)\nSubClassOf(C D)"),
              ElementsAre("A < D", "B < D", "C < D"));
}

TEST(Classification, FindsWhatInversesCarryBack) {
  EXPECT_THAT(closure("SubClassOf(A ObjectSomeValuesFrom(r B))\nInverseObjectProperties(r s)\n"
                      "SubClassOf(B ObjectAllValuesFrom(s C))"),
              ElementsAre("A < C"));
}

// {a} and B are one, and who is not B has two neighbours in B: so everything is a.
TEST(Classification, FindsWhatNominalsMakeEverythingBe) {
  EXPECT_THAT(
      closure("SubClassOf(ObjectMaxCardinality(1 r B) B)\nSubClassOf(A Thing)\n"
              "EquivalentClasses(B ObjectIntersectionOf(ObjectOneOf(i:a) ObjectHasValue(ObjectInverseOf(r) i:a)))"),
      ElementsAre("A < B", "Thing < B"));
}

TEST(Classification, FindsWhatCannotBe) {
  EXPECT_THAT(closure("SubClassOf(A ObjectMinCardinality(2 r B))\nSubClassOf(A ObjectMaxCardinality(1 r))"),
              ElementsAre("A < Nothing"));
  EXPECT_THAT(closure("SubClassOf(Thing ObjectUnionOf(A B))\nSubClassOf(A Nothing)\nSubClassOf(B Nothing)"),
              ElementsAre("inconsistent"));
}

TEST(Classification, FindsContradictionsOfFactsBeyondEl) {
  EXPECT_THAT(closure("ClassAssertion(ObjectUnionOf(A B) i:a)\nClassAssertion(ObjectComplementOf(A) i:a)\n"
                      "ClassAssertion(ObjectComplementOf(B) i:a)"),
              ElementsAre("inconsistent"));
}

TEST(Classification, KeepsWhatElFoundAndReducesItAgain) {
  const owl::Ontology source =
      owl::written("SubClassOf(A C)\nSubClassOf(B C)\nSubClassOf(A ObjectUnionOf(B B2))\nSubClassOf(B2 B)");
  const Classified found = by_all_engines(source);
  EXPECT_THAT(closure(source, found), ElementsAre("A < B", "A < C", "B < C", "B2 < B", "B2 < C"));
  std::size_t parents = 0;
  for (std::uint32_t of = 0; of < found.class_count(); ++of)
    parents += found.parents_of(taxonomy::ClassNumber{of}).size();
  EXPECT_EQ(parents, 4U) << "A < B, B2 < B, B < C, C < Thing and no more";
}

TEST(Classification, OfAnElOntologyIsThatOfElToTheLastNumber) {
  const owl::Ontology source = owl::written(
      "SubClassOf(A ObjectSomeValuesFrom(r B))\nSubClassOf(B C)\n"
      "SubClassOf(ObjectSomeValuesFrom(r C) D)\nEquivalentClasses(C E)");
  const Classified all = by_all_engines(source);
  const taxonomy::Classification el_only = owl::classified(source);
  EXPECT_EQ(all.parents, el_only.parents);
  EXPECT_EQ(all.representative, el_only.representative);
  EXPECT_EQ(all.counts.contexts, el_only.counts.contexts);
  EXPECT_THAT(all.gaps, IsEmpty());
}

TEST(Classification, NamesWhatOwlForbidsAndUsesTheRest) {
  const owl::Ontology source = owl::written(
      "TransitiveObjectProperty(r)\nSubClassOf(A ObjectMaxCardinality(1 r))\nSubClassOf(A ObjectUnionOf(B C))\n"
      "SubClassOf(B C)");
  const Classified found = by_all_engines(source);
  EXPECT_THAT(found.unused, ElementsAre(testing::Field(&taxonomy::UnusedAxiom::axiom, 1U)));
  EXPECT_THAT(closure(source, found), ElementsAre("A < C", "B < C"));
  EXPECT_EQ(found.counts.axioms, 4U);
  EXPECT_EQ(found.counts.used_axioms, 3U);
}

TEST(Classification, TellsWhatItIsDoing) {
  std::vector<std::string> phases;
  const owl::Ontology source = owl::written("SubClassOf(ObjectAllValuesFrom(r A) B)");
  const auto note = [&](std::string_view phase, double done) {
    EXPECT_GE(done, 0);
    EXPECT_LE(done, 1);
    phases.emplace_back(phase);
  };
  ASSERT_TRUE(classify(source, {.progress = note}));
  EXPECT_THAT(phases, Contains("classifying"));
  EXPECT_THAT(phases, Contains("deriving consequences"));
}

/// The completion of the taxonomy that EL derives.
Completion completed(const owl::Ontology& source, const CompletionLimits& limits = {}) {
  const taxonomy::Classification known = owl::classified(source);
  const auto clauses = clauses::clausify(source, std::nullopt, {});
  if (!clauses) ADD_FAILURE() << clauses.error().text;
  const std::vector<bool> none(known.class_count(), false);
  return complete(source, {known, *clauses, none, none}, {}, limits);
}

constexpr const char* by_cases =
    "SubClassOf(A ObjectUnionOf(B C))\nSubClassOf(B D)\nSubClassOf(C D)\n"
    "SubClassOf(E ObjectIntersectionOf(ObjectUnionOf(B C) ObjectComplementOf(D)))\nSubClassOf(F A)";

TEST(Completion, FindsWhatIsAboveEverything) {
  // There are two things at most, and each has two neighbours in B.
  EXPECT_THAT(closure("SubClassOf(Thing ObjectOneOf(i:a i:b))\nSubClassOf(Thing ObjectMinCardinality(2 r B))\n"
                      "SubClassOf(A C)"),
              Contains("Thing < B"));
}

TEST(Completion, FindsByModelsAloneWhatElLeavesOpen) {
  const owl::Ontology source = owl::written(by_cases);
  taxonomy::Classification found = owl::classified(source);
  const Completion completion = completed(source);
  EXPECT_TRUE(completion.is_consistent);
  EXPECT_THAT(completion.gaps, IsEmpty());
  extend(found, completion.found);
  EXPECT_THAT(closure(source, found), ElementsAre("A < D", "B < D", "C < D", "E < Nothing", "F < A", "F < D"));
}

TEST(Completion, FindsAContradiction) {
  const owl::Ontology source = owl::written(
      "SubClassOf(Thing ObjectUnionOf(A B))\nSubClassOf(A Nothing)\n"
      "SubClassOf(B ObjectSomeValuesFrom(r A))");
  EXPECT_FALSE(completed(source).is_consistent);
}

TEST(Completion, SaysWhereItStopped) {
  const owl::Ontology source = owl::written(by_cases);
  const std::size_t classes = owl::classified(source).class_count();
  EXPECT_THAT(completed(source, {.classes = classes}).gaps, IsEmpty());
  EXPECT_THAT(completed(source, {.classes = classes - 1}).gaps,
              ElementsAre(HasSubstr("more than " + std::to_string(classes - 1) + " classes")));
  EXPECT_THAT(completed(source, {.questions = 1}).gaps, ElementsAre("more than 1 questions to the tableau"));
  EXPECT_THAT(completed(source, {.unanswered = 1, .question = {.nodes = 1, .steps = 1}}).gaps,
              Contains("1 questions were too hard for the tableau"));
}

TEST(Completion, RefutesManyPairsByOneQuestion) {
  // A model has chosen the first of each two. That none of these follows is one question; that one of two unions does
  // is found all the same.
  constexpr std::size_t unions = 40;
  std::string text = "SubClassOf(B1 D)\nSubClassOf(C1 D)\n";
  for (std::size_t at = 0; at < unions; ++at) {
    const std::string number = std::to_string(at);
    text += "SubClassOf(A ObjectUnionOf(B" + number + " C" + number + "))\n";
  }
  const owl::Ontology source = owl::written(text);
  taxonomy::Classification found = owl::classified(source);
  const std::size_t one_for_each_class = found.class_count();
  const Completion completion = completed(source, {.questions = one_for_each_class + unions / 2});
  EXPECT_THAT(completion.gaps, IsEmpty());
  extend(found, completion.found);
  EXPECT_THAT(closure(source, found), ElementsAre("A < D", "B1 < D", "C1 < D"));
}

TEST(Completion, FindsNothingThatDoesNotFollowHoweverEarlyItStops) {
  const owl::Ontology source = owl::written(by_cases);
  for (std::size_t questions = 0; questions < 12; ++questions) {
    taxonomy::Classification found = owl::classified(source);
    extend(found, completed(source, {.questions = questions}).found);
    const std::vector<std::string> all{"A < D", "B < D", "C < D", "E < Nothing", "F < A", "F < D"};
    for (const std::string& line : closure(source, found)) {
      EXPECT_THAT(all, Contains(line)) << questions << " questions";
    }
  }
}

TEST(Taxonomy, LearnsSubsumptionsEquivalencesAndEmptyClasses) {
  const owl::Ontology source = owl::written("SubClassOf(A B)\nSubClassOf(B C)\nSubClassOf(D C)\nSubClassOf(E D)");
  taxonomy::Classification found = owl::classified(source);
  const auto number = [&](const std::string& name) {
    for (std::uint32_t of = 0; of < found.class_count(); ++of) {
      if (source.name(found.classes[of]) == "https://t.example/#" + name) return of;
    }
    ADD_FAILURE() << name;
    return 0U;
  };
  extend(found, {{number("C"), number("A")}, {number("E"), static_cast<std::uint32_t>(found.nothing)}});
  EXPECT_THAT(closure(source, found), ElementsAre("A < B", "A < C", "B < A", "B < C", "C < A", "C < B", "D < A",
                                                  "D < B", "D < C", "E < Nothing"));
}

TEST(Taxonomy, KnowsTheAncestorsOfEveryNode) {
  const owl::Ontology source = owl::written("SubClassOf(A B)\nSubClassOf(B C)\nSubClassOf(A D)\nSubClassOf(D C)");
  const taxonomy::Classification found = owl::classified(source);
  std::vector<std::size_t> sizes;
  for (const auto& above : find_ancestors(found)) sizes.push_back(above.size());
  std::ranges::sort(sizes);
  EXPECT_THAT(sizes, ElementsAre(0U, 0U, 0U, 1U, 1U, 3U)) << "C, Thing, Nothing; B, D; A";
}

TEST(Taxonomy, OfAContradictionIsOneNode) {
  const owl::Ontology source = owl::written("SubClassOf(A B)\nSubObjectPropertyOf(r s)");
  taxonomy::Classification found = owl::classified(source);
  contradict(found, source);
  EXPECT_FALSE(found.is_consistent);
  for (const taxonomy::ClassNumber representative : found.representative)
    EXPECT_EQ(representative, found.representative[0]);
}

}  // namespace
}  // namespace geminga::reasoner
