// Services that cannot be reached from here: who is told of them, and what of a choice others must know.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "discovery/matching/matcher.hpp"
#include "discovery/matching/meeting/obstacle.hpp"
#include "discovery/matching/team.hpp"

namespace geminga::matching {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using enum ChannelMode;

const Identity ball = TextIdentity{"ball"};

registry::PublicationEntry far_offer(bool is_reachable, std::uint32_t participant = 2, std::int32_t priority = 0) {
  auto entry = offer(key(participant, 1, 7), ball, priority);
  entry.is_reachable = is_reachable;
  return entry;
}

registry::SubscriptionEntry wish(RequiredReach reach, std::uint32_t number = 1, std::uint32_t limit = 0) {
  auto entry = request(key(here, 1, number), ball, limit);
  entry.subscription.reach = reach;
  return entry;
}

TEST(Reach, WithholdsWhatCannotBeReachedFromAConsumerThatDoesNotAskForAll) {
  Matcher matcher;
  matcher.put(wish(RequiredReach::routed, 1));
  matcher.put(wish(RequiredReach::any, 2));
  matcher.put(far_offer(false));
  EXPECT_THAT(told(matcher), ElementsAre("p1.1.2 pub add p2.1.7 exact 0"));
  matcher.put(far_offer(true));
  EXPECT_THAT(told(matcher), ElementsAre("p1.1.1 pub add p2.1.7 exact 0", "p1.1.2 pub modify p2.1.7 exact 0"));
  matcher.put(far_offer(false));
  EXPECT_THAT(told(matcher), ElementsAre("p1.1.1 pub del p2.1.7 unreachable", "p1.1.2 pub modify p2.1.7 exact 0"));
  matcher.put(wish(RequiredReach::any, 1));
  matcher.put(wish(RequiredReach::routed, 2));
  EXPECT_THAT(told(matcher), ElementsAre("p1.1.1 pub add p2.1.7 exact 0", "p1.1.2 pub del p2.1.7 unreachable"));
}

TEST(Reach, IsJudgedForConsumersOfThisHostAlone) {
  Matcher matcher;
  matcher.put(offer(key(here, 1, 1), ball));
  auto consumer = request(key(3, 1, 1), ball);
  consumer.is_reachable = false;
  matcher.put(consumer);
  EXPECT_THAT(told(matcher), ElementsAre("p1.1.1 sub add p3.1.1 exact 0")) << "it may open the channel";
  matcher.put(far_offer(false));
  EXPECT_TRUE(matcher.search().is_used(*matcher.publications().find_entry(key(2, 1, 7))))
      << "by a consumer of another host";
}

TEST(Reach, IsNothingToDescriptionsOfParticipants) {
  Matcher matcher;
  auto description = offer(key(2, 0, 1), ball, 0, participant);
  description.is_reachable = false;
  matcher.put(description);
  matcher.put(request(key(here, 1, 1), ball, 0, Degree::narrower, participant));
  EXPECT_THAT(told(matcher), ElementsAre("p1.1.1 pub add p2.0.1 exact 0"));
}

TEST(Reach, LeavesThePlaceToTheNextAndAnnouncesTheChoice) {
  Matcher matcher;
  matcher.put(wish(RequiredReach::routed, 1, 1));
  matcher.put(far_offer(false, 2, 9));
  EXPECT_THAT(told(matcher), IsEmpty());
  matcher.put(far_offer(true, 3, 0));
  EXPECT_THAT(told(matcher), ElementsAre("p1.1.1 pub add p3.1.7 exact 0"));
  // The host of the other provider would choose that one, which has the greater priority.
  EXPECT_THAT(matcher.choices().announced(key(here, 1, 1)), ElementsAre(key(3, 1, 7)));
  matcher.put(far_offer(true, 2, 9));
  EXPECT_THAT(told(matcher), ElementsAre("p1.1.1 pub add p2.1.7 exact 0", "p1.1.1 pub del p3.1.7 outranked"));
}

TEST(Reach, IsTheLastObstacleOfAPair) {
  Matcher matcher;
  matcher.put(far_offer(false));
  auto asked = wish(RequiredReach::routed);
  const auto finding = [&] {
    return matcher.examination().examine(asked, *matcher.examination().prepare(asked),
                                         *matcher.publications().find_entry(key(2, 1, 7)));
  };
  EXPECT_EQ(finding().first(), Obstacle::unreachable);
  EXPECT_EQ(to_string(finding().first()), "unreachable");
  asked.subscription.protocols = {"tcp"};
  EXPECT_EQ(finding().first(), Obstacle::protocol);
  EXPECT_EQ(finding().count(), 2U);
  asked.subscription.reach = RequiredReach::any;
  EXPECT_EQ(finding().count(), 1U);
}

}  // namespace
}  // namespace geminga::matching
