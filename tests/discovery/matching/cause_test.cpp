// A cause keeps what was replaced.
#include "discovery/matching/cause.hpp"

#include <gtest/gtest.h>

#include "discovery/matching/owners.hpp"

namespace geminga::matching {
namespace {

const Identity ball = TextIdentity{"ball"};

TEST(Cause, ThatReplacesNothingTellsOfEntriesAsTheyAre) {
  Owners owners;
  const auto& offered = owners.add(offer(key(2, 1, 1), ball));
  const auto& asked = owners.add(request(key(here, 1, 1), ball));
  const Cause cause;
  EXPECT_EQ(cause.as_told(offered), offered.kept);
  EXPECT_EQ(cause.as_told(asked), asked.kept);
  EXPECT_FALSE(cause.modifies(offered));
  EXPECT_FALSE(cause.modifies(asked));
  EXPECT_EQ(cause.replaced_subscription(), nullptr);
}

TEST(Cause, TellsOfAReplacedPublicationAsItWas) {
  Owners owners;
  const auto& offered = owners.add(offer(key(2, 1, 1), ball, 1));
  const auto& other = owners.add(offer(key(2, 1, 2), ball));
  Cause cause;
  cause.replace(offered, owners.directory.offers().replace(offered, offer(key(2, 1, 1), ball, 2)));
  EXPECT_EQ(cause.as_told(offered)->publication.priority, 1);
  EXPECT_TRUE(cause.modifies(offered));
  EXPECT_FALSE(cause.modifies(other));
}

TEST(Cause, IsNoModificationWhereOnlyTheOwnHostJudgesByWhatChanged) {
  Owners owners;
  const auto& offered = owners.add(offer(key(2, 1, 1), ball));
  auto changed = offered.entry;
  changed.publication.for_whom = "rate > 1";
  Cause of_offer;
  of_offer.replace(offered, owners.directory.offers().replace(offered, changed));
  EXPECT_FALSE(of_offer.modifies(offered));
  const auto& asked = owners.add(request(key(here, 1, 1), ball));
  auto next = asked.entry;
  next.subscription.where = "rate > 1";
  Cause of_request;
  of_request.replace(asked, owners.directory.requests().replace(asked, next, owners.preparation.prepare(next)), true);
  EXPECT_TRUE(of_request.replaces(asked));
  EXPECT_FALSE(of_request.modifies(asked));
  ASSERT_NE(of_request.replaced_subscription(), nullptr);
  EXPECT_TRUE(of_request.replaced_subscription()->was_clashing);
}

}  // namespace
}  // namespace geminga::matching
