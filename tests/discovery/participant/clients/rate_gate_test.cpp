#include "discovery/participant/clients/rate_gate.hpp"

#include <gtest/gtest.h>

namespace geminga::participant {
namespace {

using std::chrono::milliseconds;
using Verdict = RateGate::Verdict;

TEST(RateGate, PassesItsLimitRefusesTheRestAndThenCallsItAFlood) {
  RateGate gate(2, 1);
  const base::Instant first{};
  EXPECT_EQ(gate.count(first), Verdict::pass);
  EXPECT_EQ(gate.count(first), Verdict::pass);
  EXPECT_EQ(gate.count(first), Verdict::refuse);
  EXPECT_EQ(gate.count(first + milliseconds(999)), Verdict::flood);
}

TEST(RateGate, ForgivesAfterASecondAndNotBefore) {
  RateGate gate(1, 9);
  const base::Instant first{};
  EXPECT_EQ(gate.count(first), Verdict::pass);
  EXPECT_EQ(gate.count(first + milliseconds(999)), Verdict::refuse);
  EXPECT_EQ(gate.count(first + milliseconds(1000)), Verdict::pass);
}

TEST(RateGate, CountsWorkAsStatementsButNeverAsAFlood) {
  RateGate gate(10, 1);
  const base::Instant first{};
  EXPECT_EQ(gate.count(first), Verdict::pass);
  gate.charge(8);
  EXPECT_EQ(gate.count(first), Verdict::pass);
  gate.charge(1000);
  EXPECT_EQ(gate.count(first), Verdict::refuse);
  EXPECT_EQ(gate.count(first + milliseconds(1000)), Verdict::pass);
}

}  // namespace
}  // namespace geminga::participant
