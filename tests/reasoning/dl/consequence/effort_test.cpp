// The limits of a saturation, at their last value and one beyond.
#include "reasoning/dl/consequence/effort.hpp"

#include <gtest/gtest.h>

namespace geminga::consequence {
namespace {

TEST(SharedEffort, StopsAllThreadsOneClauseBeyondTheLimit) {
  SharedEffort shared({.clauses = 10, .alternatives = 0});
  EXPECT_TRUE(shared.count_clauses(9));
  EXPECT_TRUE(shared.count_clauses(1));
  EXPECT_FALSE(shared.is_cut_off());
  EXPECT_FALSE(shared.count_clauses(1));
  EXPECT_TRUE(shared.is_cut_off());
}

TEST(SharedEffort, CountsAHundredAttemptsAsAClause) {
  SharedEffort shared({.clauses = 10, .alternatives = 0});
  EXPECT_TRUE(shared.count_attempts(1099));
  EXPECT_FALSE(shared.count_attempts(1));
}

TEST(SharedEffort, TakesEightStepsOfTheBudgetForAClauseAndOneForAnAttempt) {
  base::Budget budget(100);
  SharedEffort shared({.clauses = 1000, .alternatives = 0, .budget = &budget});
  EXPECT_TRUE(shared.count_clauses(10));
  EXPECT_TRUE(shared.count_attempts(19));
  EXPECT_EQ(budget.left(), 1U);
  EXPECT_FALSE(shared.count_clauses(1));
}

TEST(SharedEffort, StopsWhenTooManyMessagesWait) {
  SharedEffort shared({.clauses = 1, .alternatives = 0});
  for (std::size_t at = 0; at < shared.max_messages(); ++at) ASSERT_TRUE(shared.count_message()) << at;
  shared.count_received(1);
  EXPECT_TRUE(shared.count_message());
  EXPECT_FALSE(shared.is_flooded());
  EXPECT_FALSE(shared.count_message());
  EXPECT_TRUE(shared.is_flooded());
  EXPECT_TRUE(shared.is_cut_off());
}

TEST(SharedEffort, AllowsFewerAlternativesOnceManyContextsHadTooMany) {
  SharedEffort shared({.clauses = 1, .alternatives = 200});
  for (int context = 0; context < 256; ++context) {
    EXPECT_EQ(shared.max_alternatives(), 200U);
    shared.count_cut_context();
  }
  EXPECT_EQ(shared.max_alternatives(), 16U);
}

TEST(Effort, ReportsClausesOfAThreadWithTheirLiterals) {
  SharedEffort shared({.clauses = 5, .alternatives = 0});
  Effort effort(shared);
  effort.count_unit();
  effort.count_clause(7);   // one
  effort.count_clause(16);  // three
  EXPECT_TRUE(shared.count_clauses(0));
  EXPECT_TRUE(effort.report());
  EXPECT_FALSE(shared.count_clauses(1));
}

TEST(Effort, StopsItsRuleWhenTheAttemptsOfAllAreTooMany) {
  SharedEffort shared({.clauses = 1, .alternatives = 0});
  Effort effort(shared);
  for (int attempt = 1; attempt < 4096; ++attempt) effort.count_attempt();
  EXPECT_FALSE(effort.is_stopped());
  effort.count_attempt();
  EXPECT_TRUE(effort.is_stopped());
  EXPECT_FALSE(effort.may_continue());
}

}  // namespace
}  // namespace geminga::consequence
