// Conclusions of one step: how they are built, and which of them are none.
#include "reasoning/dl/consequence/conclusions.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace geminga::consequence {
namespace {

class ConclusionsOfAStep : public testing::Test {
 protected:
  using Clause = std::pair<std::vector<Literal>, std::vector<Literal>>;

  [[nodiscard]] std::vector<Clause> clauses() const {
    std::vector<Clause> all;
    conclusions_.for_each_clause([&](std::span<const Literal> body, std::span<const Literal> head) {
      all.emplace_back(std::vector(body.begin(), body.end()), std::vector(head.begin(), head.end()));
      return true;
    });
    return all;
  }

 private:
  base::Arena arena_;
  ArenaUse use_{arena_};

 protected:
  static constexpr Literal a = unary(1, x_term);
  static constexpr Literal b = unary(2, x_term);
  static constexpr Literal c = unary(3, x_term);
  static constexpr Literal d = unary(4, x_term);
  SharedEffort shared_{{.clauses = 1000, .alternatives = 2}};
  Effort effort_{shared_};
  Conclusions conclusions_{effort_, shared_};
  ClauseStore store_;
};

TEST_F(ConclusionsOfAStep, TakeTheSidesWithoutTheResolvedLiterals) {
  const ClauseNumber first = store_.insert(std::vector{c}, std::vector{b, a}, 1);
  conclusions_.begin();
  conclusions_.add_side(store_, {first, b});
  conclusions_.finish(store_, std::vector{d});
  EXPECT_EQ(clauses(), (std::vector<Clause>{{{c}, {a, d}}}));
  EXPECT_TRUE(conclusions_.units().empty());
}

TEST_F(ConclusionsOfAStep, AreUnitsWithoutABodyUnlessTheyAreKnown) {
  static_cast<void>(store_.insert_unit(a));
  for (const Literal literal : {a, b}) conclusions_.conclude(store_, {no_clause, c}, literal);
  EXPECT_EQ(std::vector(conclusions_.units().begin(), conclusions_.units().end()), std::vector{b});
  EXPECT_TRUE(clauses().empty());
}

TEST_F(ConclusionsOfAStep, AreAContradictionWithoutBodyAndHead) {
  conclusions_.begin();
  conclusions_.finish(store_, {});
  EXPECT_TRUE(conclusions_.has_contradiction());
  conclusions_.clear();
  EXPECT_FALSE(conclusions_.has_contradiction());
}

TEST_F(ConclusionsOfAStep, CutTheStoreBeyondTheLastAlternative) {
  const ClauseNumber kept = store_.insert({}, std::vector{d, c}, 1);
  for (int time = 0; time < 2; ++time) {
    conclusions_.begin();
    conclusions_.finish(store_, std::vector{b, a});
  }
  EXPECT_EQ(clauses().size(), 2U);
  EXPECT_TRUE(store_.is_live(kept));
  conclusions_.begin();
  conclusions_.finish(store_, std::vector{b, a});
  EXPECT_EQ(clauses().size(), 2U);
  EXPECT_TRUE(store_.is_cut());
  EXPECT_FALSE(store_.is_live(kept));
  EXPECT_TRUE(shared_.has_cut_context());
}

}  // namespace
}  // namespace geminga::consequence
