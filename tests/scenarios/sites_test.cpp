// A small world of sites comes to know what it asks for.
#include "scenarios/sites.hpp"

#include <gtest/gtest.h>

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
}

}  // namespace
}  // namespace geminga::scenarios
