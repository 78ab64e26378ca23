#include "base/budget.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>
#include <vector>

namespace geminga::base {
namespace {

TEST(Budget, IsSpentBehindItsLastStepAndNotAtIt) {
  for (const std::uint64_t last : {4U, 5U, 6U}) {
    Budget budget(5);
    bool goes_on = true;
    for (std::uint64_t step = 0; step < last; ++step) goes_on = budget.spend(1);
    EXPECT_EQ(goes_on, last <= 5) << last;
    EXPECT_EQ(budget.is_spent(), last > 5) << last;
    EXPECT_EQ(budget.reason().has_value(), last > 5) << last;
  }
}

TEST(Budget, NamesTheLimitThatWasReached) {
  Budget steps(3);
  static_cast<void>(steps.spend(4));
  EXPECT_EQ(steps.reason(), "the limit of 3 steps was reached");
  Budget time(Budget::unlimited, [] { return true; });
  EXPECT_FALSE(time.spend(1));
  EXPECT_EQ(time.reason(), "the time limit was reached");
}

TEST(Budget, WithoutLimitIsNeverSpent) {
  Budget budget;
  EXPECT_TRUE(budget.spend(Budget::unlimited / 2));
  EXPECT_TRUE(budget.spend(Budget::unlimited / 2));
}

TEST(Budget, AsksForTheTimeOnceInSoManySteps) {
  int asked = 0;
  Budget budget(
      Budget::unlimited,
      [&] {
        ++asked;
        return false;
      },
      100);
  for (int step = 0; step < 1000; ++step) EXPECT_TRUE(budget.spend(1));
  EXPECT_EQ(asked, 10);
}

TEST(Budget, StaysSpentAndKeepsItsReason) {
  bool is_over = true;
  Budget budget(1'000'000, [&] { return is_over; });
  EXPECT_FALSE(budget.spend(1));
  is_over = false;
  EXPECT_FALSE(budget.spend(2'000'000));
  EXPECT_EQ(budget.reason(), "the time limit was reached");
  EXPECT_EQ(budget.spent(), 1U) << "what comes behind its end is not counted";
}

TEST(Budget, EndsAllWhoShareIt) {
  Budget budget(1'000'000);
  std::atomic<int> ended{0};
  std::vector<std::thread> workers;
  for (int worker = 0; worker < 4; ++worker) {
    workers.emplace_back([&] {
      BudgetUse use(&budget);
      while (use.spend(1)) {
      }
      ++ended;
    });
  }
  for (std::thread& worker : workers) worker.join();
  EXPECT_EQ(ended, 4);
}

TEST(BudgetUse, WithoutABudgetMaySpendEverything) {
  BudgetUse use(nullptr);
  for (int step = 0; step < 10'000; ++step) EXPECT_TRUE(use.spend(1'000'000));
}

TEST(BudgetUse, TellsInBatchesAndNotEachStep) {
  int asked = 0;
  Budget budget(
      Budget::unlimited,
      [&] {
        ++asked;
        return false;
      },
      0);
  BudgetUse use(&budget);
  for (int step = 0; step < 10'240; ++step) EXPECT_TRUE(use.spend(1));
  EXPECT_EQ(asked, 10);
}

}  // namespace
}  // namespace geminga::base
