// A small world of sites comes to know what it asks for.
#include "scenarios/sites.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace geminga::scenarios {
namespace {

TEST(Sites, KnowAllThatOfferWhatTheyAskForAndCarryNothingElse) {
  const SiteConditions conditions{.seed = 4, .sites = 40, .clusters = 4, .time = std::chrono::minutes(45)};
  const SiteResult result = simulate_sites(conditions);
  EXPECT_GT(result.pairs, 100U);
  EXPECT_EQ(result.missing, 0U);
  EXPECT_EQ(result.surplus, 0U);
  EXPECT_NEAR(result.remembered, static_cast<double>(result.pairs) / 40, 0.01);
  EXPECT_NEAR(result.remembered / result.expected_remembered, 1, 0.4);
  EXPECT_GT(result.expansions, 100U);
  EXPECT_EQ(result.listed.size(), result.expansions);
  EXPECT_EQ(result.unanswered, 0U);
  EXPECT_LE(std::ranges::max(result.listed), std::chrono::milliseconds(240)) << "a round trip over a gateway";
}

TEST(Sites, KnowNearlyAllWhereATenthOfTheMessagesIsLost) {
  const SiteConditions conditions{.seed = 5, .sites = 40, .clusters = 4, .time = std::chrono::minutes(45), .loss = 0.1};
  const SiteResult result = simulate_sites(conditions);
  EXPECT_GT(result.missing, 0U);
  EXPECT_LT(result.missing, result.pairs / 10) << "what is lost is asked for again";
  EXPECT_LT(result.unanswered, result.expansions / 20);
  EXPECT_GE(result.listed.size() + result.unanswered, result.expansions);
}

}  // namespace
}  // namespace geminga::scenarios
