// Minimal hitting sets against all subsets, and their limits.
#include "reasoning/explanation/hitting_sets.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "base/random.hpp"

namespace geminga::explanation {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

using Sets = std::vector<AxiomSet>;

bool hits(const AxiomSet& set, std::size_t mask) {
  return std::ranges::any_of(set, [&](std::uint32_t axiom) { return ((mask >> axiom) & 1) != 0; });
}

TEST(HittingSets, AreTheSmallestFirst) {
  EXPECT_THAT(find_hitting_sets({{1, 2}, {2, 3}}).sets, ElementsAre(AxiomSet{2}, AxiomSet{1, 3}));
  EXPECT_THAT(find_hitting_sets({{1}, {2}}).sets, ElementsAre(AxiomSet{1, 2}));
  EXPECT_THAT(find_hitting_sets({}).sets, ElementsAre(IsEmpty()));
  EXPECT_THAT(find_hitting_sets({{}}).sets, IsEmpty());
}

TEST(HittingSets, AreAllThatThereAre) {
  constexpr std::uint32_t axioms = 8;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    base::Random random(seed);
    Sets sets;
    for (std::uint64_t count = 1 + random.below(5); count > 0; --count) {
      AxiomSet set;
      for (std::uint32_t axiom = 0; axiom < axioms; ++axiom) {
        if (random.below(3) == 0) set.push_back(axiom);
      }
      if (!set.empty()) sets.push_back(std::move(set));
    }
    const auto is_hit = [&](std::size_t mask) {
      return std::ranges::all_of(sets, [&](const AxiomSet& set) { return hits(set, mask); });
    };
    Sets expected;
    for (std::size_t mask = 0; mask < (std::size_t{1} << axioms); ++mask) {
      if (!is_hit(mask)) continue;
      AxiomSet set;
      bool is_minimal = true;
      for (std::uint32_t axiom = 0; axiom < axioms; ++axiom) {
        if (((mask >> axiom) & 1) == 0) continue;
        set.push_back(axiom);
        if (is_hit(mask ^ (std::size_t{1} << axiom))) is_minimal = false;
      }
      if (is_minimal) expected.push_back(std::move(set));
    }
    std::ranges::sort(expected, {}, [](const AxiomSet& set) { return std::pair(set.size(), set); });
    const AllSets found = find_hitting_sets(sets, {.sets = 1000});
    EXPECT_EQ(found.sets, expected) << "seed " << seed;
    EXPECT_FALSE(found.may_have_more);
  }
}

TEST(HittingSets, EndAtTheLimitOfSets) {
  const Sets sets = {{1, 2, 3}};
  EXPECT_TRUE(find_hitting_sets(sets, {.sets = 2}).may_have_more);
  EXPECT_FALSE(find_hitting_sets(sets, {.sets = 3}).may_have_more);
  EXPECT_FALSE(find_hitting_sets(sets, {.sets = 4}).may_have_more);
  EXPECT_THAT(find_hitting_sets(sets, {.sets = 2}).sets, ElementsAre(AxiomSet{1}, AxiomSet{2}));
}

TEST(HittingSets, EndAtTheLimitOfNodes) {
  const Sets sets = {{1, 2, 3}};
  EXPECT_TRUE(find_hitting_sets(sets, {.nodes = 2}).may_have_more);
  EXPECT_THAT(find_hitting_sets(sets, {.nodes = 2}).sets, IsEmpty());
  EXPECT_FALSE(find_hitting_sets(sets, {.nodes = 3}).may_have_more);
  EXPECT_FALSE(find_hitting_sets(sets, {.nodes = 4}).may_have_more);
}

TEST(HittingSets, SetsThatShareAxiomsAreOneGroup) {
  EXPECT_THAT(groups_of({{1, 2}, {3}, {2, 4}, {5, 6}, {4, 5}}),
              ElementsAre(Sets{{1, 2}, {2, 4}, {5, 6}, {4, 5}}, Sets{{3}}));
  EXPECT_THAT(groups_of({{1}, {2}, {1, 2}}), ElementsAre(Sets{{1}, {2}, {1, 2}}));
  EXPECT_THAT(groups_of({}), IsEmpty());
}

}  // namespace
}  // namespace geminga::explanation
