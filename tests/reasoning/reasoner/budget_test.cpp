// The result when a budget is spent: everything that is certain, and the class that was being worked on.
#include "base/budget.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "reasoning/compiled/compile.hpp"
#include "reasoning/reasoner/reasoner.hpp"
#include "support/written.hpp"

namespace geminga::reasoner {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Not;

/// X is everywhere in a hole with nobody else, of n holes for n + 1: that it is empty takes n! cases to see.
std::string pigeonhole(int holes) {
  std::string text;
  const auto place = [](int pigeon, int hole) { return "P" + std::to_string(pigeon) + "x" + std::to_string(hole); };
  for (int pigeon = 0; pigeon <= holes; ++pigeon) {
    text += "SubClassOf(X ObjectUnionOf(";
    for (int hole = 0; hole < holes; ++hole) text += place(pigeon, hole) + " ";
    text += "))\n";
    for (int hole = 0; hole < holes; ++hole) {
      for (int other = 0; other < pigeon; ++other)
        text += "DisjointClasses(" + place(pigeon, hole) + " " + place(other, hole) + ")\n";
    }
  }
  return text;
}

/// Wholes that are defined by what all their parts are paired with, some of them by the kinds of both.
std::string pairings() {
  std::string text = "FunctionalObjectProperty(pairs)\n";
  const auto define = [&text](const std::string& name, const std::string& part) {
    text += "EquivalentClasses(" + name + " ObjectAllValuesFrom(part " + part + "))\n";
  };
  const auto pair = [](const std::string& one, const std::string& pairing, const std::string& other) {
    return "ObjectIntersectionOf(" + one + " ObjectSomeValuesFrom(" + pairing + " " + other + "))";
  };
  for (const std::string kinds : {"AG", "AU", "CG", "GC", "GU"})
    define("Of" + kinds, pair(kinds.substr(0, 1), "p0", kinds.substr(1)));
  define("Usual", "ObjectUnionOf(" + pair("A", "p0", "U") + pair("C", "p0", "G") + pair("G", "p0", "C") +
                      pair("U", "p0", "A") + ")");
  define("Any", pair("Base", "pairs", "Base"));
  for (const std::string pairing : {"p0", "p1", "p2", "p3"}) define("All" + pairing, pair("Base", pairing, "Base"));
  define("Either",
         "ObjectIntersectionOf(Base ObjectUnionOf(ObjectSomeValuesFrom(p4 Base) ObjectSomeValuesFrom(p5 Base)))");
  for (int at = 0; at < 6; ++at) text += "SubObjectPropertyOf(p" + std::to_string(at) + " pairs)\n";
  return text;
}

constexpr std::string_view easy =
    "SubClassOf(A ObjectUnionOf(B C))\nSubClassOf(B D)\nSubClassOf(C D)\nSubClassOf(D E)\n";

Classified classify_within(const owl::Ontology& source, base::Budget& budget) {
  auto result = classify(source, {.threads = 1, .budget = &budget, .progress = {}});
  if (!result) ADD_FAILURE() << result.error().text;
  return std::move(result).value();
}

std::vector<std::string> names(const owl::Ontology& source, const Classified& found) {
  std::vector<std::string> result;
  for (const taxonomy::ClassNumber of : found.undecided.classes) {
    const std::string_view iri = source.name(found.classes[static_cast<std::size_t>(of)]);
    result.emplace_back(iri.substr(iri.find_last_of("/#:") + 1));
  }
  return result;
}

std::string name(const owl::Ontology& source, const Classified& found, taxonomy::ClassNumber of) {
  const std::string_view iri = source.name(found.classes[static_cast<std::size_t>(of)]);
  return std::string(iri.substr(iri.find_last_of("/#:") + 1));
}

TEST(ABudget, ThatIsEnoughLeavesNothingUndecided) {
  const owl::Ontology source = owl::written(easy);
  base::Budget budget(10'000'000);
  const Classified found = classify_within(source, budget);
  EXPECT_FALSE(found.is_cut_off);
  EXPECT_THAT(found.undecided.classes, IsEmpty());
  EXPECT_FALSE(found.undecided.consistency);
  EXPECT_FALSE(found.undecided.held_up_by);
  EXPECT_THAT(found.gaps, IsEmpty());
}

TEST(ABudget, OfAHardClassLeavesTheOthersDecided) {
  const owl::Ontology source = owl::written(pigeonhole(9) + std::string(easy));
  base::Budget budget(200'000'000);
  const Classified found = classify_within(source, budget);
  EXPECT_THAT(names(source, found), ElementsAre("X"));
  EXPECT_FALSE(found.undecided.consistency);
  ASSERT_TRUE(found.undecided.held_up_by);
  EXPECT_EQ(name(source, found, *found.undecided.held_up_by), "X");
  const auto ontology = compiled::Ontology::from_bytes(compiled::compile(source, found));
  ASSERT_TRUE(ontology);
  EXPECT_THAT(owl::closure(*ontology), ElementsAre("A < D", "A < E", "B < D", "B < E", "C < D", "C < E", "D < E"));
}

TEST(ABudget, ThatIsSpentSaysSoAndKeepsWhatTheELPartSays) {
  const owl::Ontology source = owl::written(pigeonhole(9) + std::string(easy));
  base::Budget budget(1000);
  const Classified found = classify_within(source, budget);
  EXPECT_TRUE(found.is_cut_off);
  EXPECT_THAT(found.gaps, Contains("the limit of 1000 steps was reached"));
  EXPECT_THAT(names(source, found), Contains("X"));
  const auto ontology = compiled::Ontology::from_bytes(compiled::compile(source, found));
  ASSERT_TRUE(ontology);
  EXPECT_THAT(owl::closure(*ontology), Contains("B < E"));
  EXPECT_THAT(owl::closure(*ontology), Not(Contains("X < Nothing")));
}

/// Each part is within all that follow in the line: what follows grows with its square, and all of it is EL.
std::string line_of_parts(int length) {
  std::string text = "TransitiveObjectProperty(p)\n";
  for (int at = 0; at < length; ++at) {
    const std::string name = "L" + std::to_string(at);
    text += "SubClassOf(" + name + " ObjectSomeValuesFrom(p L" + std::to_string(at + 1) + "))\n";
    text += "EquivalentClasses(In" + std::to_string(at) + " ObjectSomeValuesFrom(p " + name + "))\n";
  }
  return text;
}

TEST(ABudget, ThatIsSpentInTheELPartLeavesWhatWasDerivedAndIsNeverComplete) {
  const owl::Ontology source = owl::written(line_of_parts(150) + "SubClassOf(B C)\nSubClassOf(C D)\n");
  base::Budget enough(100'000'000);
  EXPECT_FALSE(classify_within(source, enough).is_cut_off);
  for (const std::uint64_t steps : {std::uint64_t{1}, enough.spent() / 2, enough.spent() - 1}) {
    base::Budget budget(steps);
    const Classified found = classify_within(source, budget);
    EXPECT_TRUE(found.is_cut_off);
    EXPECT_THAT(found.unused, IsEmpty());
    EXPECT_THAT(found.gaps, ElementsAre("the limit of " + std::to_string(steps) + " steps was reached"));
    EXPECT_TRUE(found.undecided.consistency);
    EXPECT_THAT(found.undecided.classes, Not(IsEmpty()));
    const auto ontology = compiled::Ontology::from_bytes(compiled::compile(source, found));
    ASSERT_TRUE(ontology);
    EXPECT_THAT(owl::closure(*ontology), Contains("B < D"));
  }
}

TEST(ABudget, ThatIsSpentInTheELPartLeavesConsistencyUnknown) {
  const owl::Ontology source = owl::written(line_of_parts(150));
  EXPECT_EQ(is_consistent(source).verdict, Verdict::yes);
  base::Budget budget(100);
  const Answer answer = is_consistent(source, &budget);
  EXPECT_EQ(answer.verdict, Verdict::unknown);
  EXPECT_EQ(answer.reason, "the limit of 100 steps was reached");
}

TEST(ABudget, ThatIsSpentInTheELPartNeverShowsThatSomethingDoesNotFollow) {
  owl::Ontology asked = owl::written(line_of_parts(150));
  const owl::TermId sub = asked.named_class("https://t.example/#L0");
  const owl::TermId super = asked.named_class("https://t.example/#In149");
  for (const std::uint64_t steps : {1U, 1'000U, 2'000U}) {
    base::Budget budget(steps);
    EXPECT_NE(entails(asked, std::nullopt, sub, super, &budget).verdict, Verdict::no) << steps;
  }
}

TEST(ABudget, OfTimeThatIsOverEndsEveryEngine) {
  const owl::Ontology source = owl::written(pigeonhole(9));
  base::Budget budget(base::Budget::unlimited, [] { return true; });
  const Classified found = classify_within(source, budget);
  EXPECT_TRUE(found.is_cut_off);
  EXPECT_THAT(found.gaps, Contains("the time limit was reached"));
  EXPECT_LT(budget.spent(), 100'000U) << "nobody works on behind the end";
}

TEST(ABudget, OfThreadsIsOne) {
  const owl::Ontology source = owl::written(pigeonhole(8));
  base::Budget budget(50'000);
  auto found = classify(source, {.threads = 3, .budget = &budget, .progress = {}});
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->is_cut_off);
  EXPECT_LT(budget.spent(), 200'000U);
}

TEST(ABudget, OfAQuestionMakesItUnknownAndNeverWrong) {
  owl::Ontology asked = owl::written(pigeonhole(9));
  const owl::TermId sub = asked.named_class("https://t.example/#X");
  int unknown = 0;
  for (const std::uint64_t steps : {5'000U, 50'000U}) {
    base::Budget budget(steps);
    const Answer answer = entails(asked, std::nullopt, sub, owl::nothing_term, &budget);
    EXPECT_NE(answer.verdict, Verdict::no);
    if (answer.verdict == Verdict::unknown) {
      ++unknown;
      EXPECT_EQ(answer.reason, "the limit of " + std::to_string(steps) + " steps was reached");
    }
  }
  EXPECT_EQ(unknown, 2);
}

// Where a thing has a part, what it says of all its parts mostly fails. That is no reason for parts to have parts.
TEST(ABudget, SufficesWhereAlternativesFailBesideANeighbourOnly) {
  const owl::Ontology source = owl::written(pairings());
  base::Budget budget(100'000);
  const Classified found = classify_within(source, budget);
  EXPECT_FALSE(found.is_cut_off) << budget.spent() << " steps";
  EXPECT_THAT(found.gaps, IsEmpty());
}

}  // namespace
}  // namespace geminga::reasoner
