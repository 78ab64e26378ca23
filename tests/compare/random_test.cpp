// Random ontologies: whatever two engines say of one, they do not contradict each other.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "compare/functional_syntax.hpp"
#include "compare/opinions.hpp"
#include "reasoning/syntax/functional/read.hpp"
#include "support/random_ontology.hpp"
#include "support/rounds.hpp"

namespace geminga::compare {
namespace {

using testing::IsEmpty;

constexpr std::uint64_t seeds = 400;

class RandomOntologies : public testing::TestWithParam<Profile> {};

std::string told(const owl::Ontology& source) { return functional_syntax(source); }

TEST_P(RandomOntologies, AreUnderstoodByEachEngineAsByTheOthers) {
  std::size_t complete = 0;
  for (std::uint64_t seed = 1; seed <= test::rounds(seeds); ++seed) {
    const owl::Ontology source = random_ontology(GetParam(), seed, 4 + seed % 12);
    SCOPED_TRACE("profile " + std::string(to_string(GetParam())) + ", seed " + std::to_string(seed) + "\n" +
                 told(source));
    const Opinion tableau = of_the_tableau(source);
    const Opinion consequence = of_consequence(source);
    const Opinion models = of_models(source);
    const Opinion whole = of_the_reasoner(source);
    EXPECT_THAT(contradictions(of_el(source), tableau), IsEmpty()) << "el and tableau";
    EXPECT_THAT(contradictions(consequence, tableau), IsEmpty()) << "consequence and tableau";
    EXPECT_THAT(contradictions(models, tableau), IsEmpty()) << "models and tableau";
    EXPECT_THAT(contradictions(models, whole), IsEmpty()) << "models and the reasoner";
    EXPECT_THAT(contradictions(whole, tableau), IsEmpty()) << "the reasoner and tableau";
    EXPECT_THAT(contradictions(whole, consequence), IsEmpty()) << "the reasoner and consequence";
    complete += whole.is_complete ? 1U : 0U;
    if (HasFailure()) return;  // one ontology at a time is enough to look at
  }
  EXPECT_GT(complete, test::rounds(seeds / 2)) << "the comparison says little where most is left open";
}

INSTANTIATE_TEST_SUITE_P(Profile, RandomOntologies, testing::ValuesIn(profiles),
                         [](const auto& param) { return std::string(to_string(param.param)); });

TEST(RangesOfChains, AreUsedByElAloneAsByTheEnginesBeyondIt) {
  for (std::uint64_t seed = 1; seed <= test::rounds(1000U); ++seed) {
    const owl::Ontology source = random_ontology(Profile::ranges, seed, 6 + seed % 14);
    SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + told(source));
    const Opinion el = of_el(source);
    const Opinion consequence = of_consequence(source);
    EXPECT_TRUE(el.is_complete);
    EXPECT_THAT(contradictions(el, consequence), IsEmpty());
    if (!consequence.is_complete) {
      EXPECT_THAT(contradictions(el, of_the_tableau(source)), IsEmpty());
    }
    if (HasFailure()) return;
  }
}

TEST(RandomOntology, IsTheSameForTheSameSeedAndAnotherForAnother) {
  for (const Profile profile : profiles) {
    EXPECT_EQ(told(random_ontology(profile, 7, 12)), told(random_ontology(profile, 7, 12)));
    EXPECT_NE(told(random_ontology(profile, 7, 12)), told(random_ontology(profile, 8, 12)));
  }
}

TEST(FunctionalSyntax, IsReadBackAsTheSameAxioms) {
  for (const Profile profile : profiles) {
    for (std::uint64_t seed = 1; seed <= test::rounds(20U); ++seed) {
      const std::string text = told(random_ontology(profile, seed, 20));
      owl::Ontology again;
      const auto read = functional::read(text, again.add_file("again.ofn"), again, {.wrong_axioms = 0});
      ASSERT_TRUE(read) << read.error().text << "\n" << text;
      EXPECT_THAT(again.omissions(), IsEmpty());
      const std::string second = told(again);
      owl::Ontology third;
      ASSERT_TRUE(functional::read(second, third.add_file("third.ofn"), third, {.wrong_axioms = 0}));
      EXPECT_EQ(told(third), second) << "seed " << seed;
    }
  }
}

TEST(Contradictions, AreWhatOnlyOneOfTwoCompleteOpinionsHas) {
  const Opinion small{{"A < B"}, true, {}};
  const Opinion large{{"A < B", "A < C"}, true, {}};
  EXPECT_THAT(contradictions(small, large), testing::ElementsAre("only the second: A < C"));
  EXPECT_THAT(contradictions(large, small), testing::ElementsAre("only the first: A < C"));
  EXPECT_THAT(contradictions({small.closure, false, {}}, large), IsEmpty());
  EXPECT_THAT(contradictions({{"inconsistent"}, true, {}}, small),
              testing::ElementsAre("only the first: inconsistent"));
}

}  // namespace
}  // namespace geminga::compare
