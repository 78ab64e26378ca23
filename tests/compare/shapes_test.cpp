// The shapes that take every combination where cases are derived: whatever two engines say of one, they agree.
#include "compare/shapes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "compare/functional_syntax.hpp"
#include "compare/genealogies.hpp"
#include "compare/opinions.hpp"
#include "reasoning/reasoner/reasoner.hpp"
#include "support/rounds.hpp"

namespace geminga::compare {
namespace {

using testing::IsEmpty;

constexpr Covering coverings[] = {Covering::disjoint_union, Covering::all_disjoint, Covering::pairwise_disjoint};

void expect_agreement(const owl::Ontology& source) {
  const Opinion tableau = of_the_tableau(source);
  const Opinion models = of_models(source);
  const Opinion whole = of_the_reasoner(source);
  EXPECT_TRUE(whole.is_complete);
  EXPECT_TRUE(models.is_complete);
  EXPECT_THAT(contradictions(models, tableau), IsEmpty()) << functional_syntax(source);
  EXPECT_THAT(contradictions(whole, tableau), IsEmpty()) << functional_syntax(source);
}

TEST(CoveringTree, IsUnderstoodByModelsAsByTheTableau) {
  for (const Covering covering : coverings) {
    for (const std::size_t width : {2U, 3U, 5U}) expect_agreement(covering_tree(covering, 20, width));
  }
}

TEST(CoveringTree, HasTheSubsumptionsOfATreeHoweverLargeItIs) {
  constexpr std::size_t classes = 2000;
  for (const Covering covering : coverings) {
    for (const std::size_t width : {2U, 10U}) {
      const Opinion found = of_the_reasoner(covering_tree(covering, classes, width));
      std::size_t expected = 0;
      for (std::size_t at = 1; at < classes; ++at) {
        for (std::size_t above = at; above != 0; above = (above - 1) / width) ++expected;
      }
      EXPECT_TRUE(found.is_complete);
      EXPECT_EQ(found.closure.size(), expected) << width;
    }
  }
}

TEST(Pigeonhole, IsDecidedOrSaidToBeOpen) {
  const Opinion found = of_the_reasoner(pigeonhole(5));
  EXPECT_TRUE(found.is_complete);
  EXPECT_EQ(found.closure.size(), 1U) << "A is empty, and B is not";
  const Opinion large = of_the_reasoner(pigeonhole(8));
  EXPECT_TRUE(large.closure.size() == 1 || !large.is_complete) << "what is too hard is said to be open";
}

TEST(Enumeration, IsUnderstoodByModelsAsByTheTableau) {
  for (std::uint64_t seed = 1; seed <= test::rounds(20U); ++seed) expect_agreement(enumeration(seed, 3 + seed % 4));
}

TEST(QualifiedNumbers, AreUnderstoodByModelsAsByTheTableau) {
  for (std::uint64_t seed = 1; seed <= test::rounds(60U); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    expect_agreement(qualified_numbers(seed));
    if (testing::Test::HasFailure()) return;
  }
}

// Lemmas 1 and 2 of src/reasoning/dl/hypertableau/README.md.
TEST(LargeNumbers, AreUnderstoodByEachEngineAsByTheTableauThatMakesEveryNeighbour) {
  int compared = 0;
  int complete = 0;
  for (std::uint64_t seed = 1; seed <= test::rounds(80U); ++seed) {
    const owl::Ontology source = large_numbers(seed, static_cast<std::uint32_t>(2 + seed % 6));
    SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + functional_syntax(source));
    const Opinion every = of_the_tableau_without_counting(source);
    const Opinion whole = of_the_reasoner(source);
    compared += static_cast<int>(every.is_complete);
    complete += static_cast<int>(whole.is_complete);
    for (const Opinion& other : {of_consequence(source), of_models(source), whole})
      EXPECT_THAT(contradictions(other, every), IsEmpty());
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GT(compared, test::rounds(50));
  EXPECT_GT(complete, test::rounds(70));
}

TEST(Family, IsUnderstoodByModelsAsByTheTableau) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    expect_agreement(family(seed, 2 + seed % 6));
    if (testing::Test::HasFailure()) return;
  }
}

TEST(Family, IsDecidedWithHundredsOfIndividuals) {
  for (const std::size_t individuals : {400U, 600U}) {
    const Opinion found = of_the_reasoner(family(individuals, individuals));
    EXPECT_TRUE(found.is_complete) << individuals;
  }
}

TEST(Genealogy, IsUnderstoodByModelsAsByTheWholeReasoner) {
  for (std::uint64_t seed = 1; seed <= test::rounds(8U); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const owl::Ontology source = genealogy(seed, 2 + seed % 3);
    const Opinion models = of_models(source);
    const Opinion whole = of_the_reasoner(source);
    EXPECT_TRUE(whole.is_complete);
    EXPECT_THAT(contradictions(models, whole), IsEmpty()) << functional_syntax(source);
    if (testing::Test::HasFailure()) return;
  }
}

TEST(Genealogy, IsDecidedWithHundredsOfPersons) {
  for (const std::uint64_t seed : {8U, 31U}) {
    base::Budget budget(20'000'000);
    const auto found = reasoner::classify(genealogy(seed, 200), {.budget = &budget});
    ASSERT_TRUE(found.has_value());
    EXPECT_THAT(found->gaps, IsEmpty()) << "seed " << seed << ", " << budget.spent() << " steps";
  }
}

TEST(Anatomy, IsUnderstoodByEachEngineAsByTheTableau) {
  int complete = 0;
  int of_el_alone = 0;
  for (std::uint64_t seed = 1; seed <= test::rounds(150U); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const owl::Ontology source = anatomy(seed, 3 + seed % 6);
    const Opinion tableau = of_the_tableau(source);
    const Opinion el = of_el(source);
    const Opinion whole = of_the_reasoner(source);
    complete += static_cast<int>(whole.is_complete);
    of_el_alone += static_cast<int>(el.is_complete);
    for (const Opinion& other : {el, of_consequence(source), of_models(source), whole})
      EXPECT_THAT(contradictions(other, tableau), IsEmpty()) << functional_syntax(source);
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GT(complete, test::rounds(140));
  EXPECT_GT(of_el_alone, test::rounds(30)) << "what inverses say is looked at in copies";
}

TEST(Pairings, AreUnderstoodByEachEngineAsByTheTableau) {
  int complete = 0;
  int by_models = 0;
  for (std::uint64_t seed = 1; seed <= test::rounds(200U); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const owl::Ontology source = pairings(seed, 2 + seed % 4);
    const Opinion tableau = of_the_tableau(source);
    const Opinion derived = of_consequence(source);
    const Opinion models = of_models(source);
    complete += static_cast<int>(derived.is_complete);
    by_models += static_cast<int>(models.is_complete);
    for (const Opinion& other : {derived, models, of_the_reasoner(source)})
      EXPECT_THAT(contradictions(other, tableau), IsEmpty()) << functional_syntax(source);
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GT(complete, test::rounds(50)) << "the closure of clauses is the judge of models";
  EXPECT_GE(by_models, test::rounds(197)) << "an order of nodes that makes wrong guesses dear gives way to another one";
}

TEST(Features, AreUnderstoodByModelsAsByTheTableau) {
  for (std::uint64_t seed = 1; seed <= test::rounds(20U); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    expect_agreement(features(seed, 3 + seed % 4));
    if (testing::Test::HasFailure()) return;
  }
}

TEST(Features, OfManyKindsAreClassifiedInFewSteps) {
  // Where the one value of a property is known before alternatives are chosen, hardly any guess is wrong.
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    base::Budget budget(1'500'000);
    const auto found = reasoner::classify(features(seed, 80), {.budget = &budget});
    ASSERT_TRUE(found.has_value());
    EXPECT_THAT(found->gaps, IsEmpty()) << "seed " << seed;
    EXPECT_FALSE(found->is_cut_off) << "seed " << seed << ", " << budget.spent() << " steps";
    RecordProperty("steps of seed " + std::to_string(seed), std::to_string(budget.spent()));
  }
}

}  // namespace
}  // namespace geminga::compare
