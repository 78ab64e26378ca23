// The clauses that the store keeps, and those that it finds redundant.
#include "reasoning/dl/consequence/clause_store.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "base/random.hpp"
#include "support/rounds.hpp"

namespace geminga::consequence {
namespace {

/// Stores take their memory from the arena of the thread.
class StoreOfClauses : public testing::Test {
 protected:
  static constexpr Literal a = unary(1, x_term);
  static constexpr Literal b = unary(2, x_term);
  static constexpr Literal c = unary(3, x_term);

 private:
  base::Arena arena_;
  ArenaUse use_{arena_};
};

TEST_F(StoreOfClauses, KeepsAUnitOnceAndDropsWhatItMakesRedundant) {
  ClauseStore store;
  const ClauseNumber clause = store.insert({}, std::vector{c, a}, 1);
  const ClauseNumber other = store.insert(std::vector{a}, std::vector{c, b}, 1);
  EXPECT_TRUE(store.insert_unit(a));
  EXPECT_FALSE(store.insert_unit(a));
  EXPECT_TRUE(store.has(a, ClauseStore::unit));
  EXPECT_FALSE(store.has(b, ClauseStore::unit));
  EXPECT_FALSE(store.is_live(clause));
  EXPECT_TRUE(store.is_live(other));
}

TEST_F(StoreOfClauses, SeesThatAClauseFollowsFromOneThatIsThere) {
  ClauseStore store;
  static_cast<void>(store.insert(std::vector{a}, std::vector{b}, 1));
  EXPECT_TRUE(store.is_redundant(std::vector{a}, std::vector{b}));
  EXPECT_TRUE(store.is_redundant(std::vector{a}, std::vector{c, b}));
  EXPECT_TRUE(store.is_redundant(std::vector{a, c}, std::vector{b}));
  EXPECT_FALSE(store.is_redundant({}, std::vector{c, b}));
  EXPECT_FALSE(store.is_redundant(std::vector{a}, std::vector{c}));
}

TEST_F(StoreOfClauses, SeesThatAClauseFollowsFromOneWithAnEmptyHead) {
  ClauseStore store;
  static_cast<void>(store.insert(std::vector{a}, {}, 0));
  EXPECT_TRUE(store.is_redundant(std::vector{a, b}, std::vector{c}));
  EXPECT_FALSE(store.is_redundant(std::vector{b}, std::vector{c}));
}

TEST_F(StoreOfClauses, DropsClausesThatANewOneImplies) {
  ClauseStore store;
  const ClauseNumber wide = store.insert(std::vector{a}, std::vector{c, b}, 1);
  const ClauseNumber kept = store.insert(std::vector{b}, std::vector{c}, 1);
  static_cast<void>(store.insert(std::vector{a}, std::vector{b}, 1));
  EXPECT_FALSE(store.is_live(wide));
  EXPECT_TRUE(store.is_live(kept));
  static_cast<void>(store.insert(std::vector{b}, {}, 0));
  EXPECT_FALSE(store.is_live(kept));
}

/// Against a list that is looked through from its start.
TEST_F(StoreOfClauses, AgreesWithAPlainList) {
  struct Plain {
    std::vector<Literal> body;
    std::vector<Literal> head;
    ClauseNumber number = 0;
    bool is_live = true;
  };
  const auto implies = [](const Plain& one, const Plain& other) {
    return std::ranges::includes(other.body, one.body) && std::ranges::includes(other.head, one.head, std::greater<>());
  };
  for (std::uint64_t seed = 1; seed <= test::rounds(200U); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    base::Random random(seed);
    ClauseStore store;
    std::vector<Plain> plain;
    for (int step = 0; step < 60; ++step) {
      Plain made;
      for (std::uint32_t predicate = 0; predicate < 6; ++predicate) {
        if (random.chance(0.3)) made.body.push_back(unary(predicate, x_term));
        if (random.chance(0.3)) made.head.insert(made.head.begin(), unary(predicate, x_term));
      }
      if (made.body.empty() && made.head.size() < 2) continue;
      const bool is_redundant =
          std::ranges::any_of(plain, [&](const Plain& old) { return old.is_live && implies(old, made); });
      ASSERT_EQ(store.is_redundant(made.body, made.head), is_redundant);
      if (is_redundant) continue;
      for (Plain& old : plain) old.is_live = old.is_live && !implies(made, old);
      made.number = store.insert(made.body, made.head, std::min<std::size_t>(1, made.head.size()));
      plain.push_back(made);
      for (const Plain& old : plain) ASSERT_EQ(store.is_live(old.number), old.is_live);
    }
  }
}

}  // namespace
}  // namespace geminga::consequence
