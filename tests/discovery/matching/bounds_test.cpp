// How many pairs one request or one offer may be in: what the air brings must not fill a host's memory.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "discovery/matching/state.hpp"
#include "discovery/matching/team.hpp"

namespace geminga::matching {
namespace {

const Identity ball = TextIdentity{"ball"};

TEST(Bounds, AConsumerThatAsksForAllIsGivenTheBestOfSoMany) {
  Matcher matcher;
  const ServiceKey asking = key(here, 1, 1);
  matcher.put(request(asking, ball));
  for (std::uint32_t number = 1; number <= max_given + 1; ++number) {
    matcher.put(offer(key(2, 1, number), ball));
    EXPECT_EQ(matcher.chosen(asking).size(), std::min(number, max_given));
  }
  auto best = offer(key(3, 1, 1), ball);
  best.publication.priority = 1;
  matcher.put(best);
  EXPECT_EQ(matcher.chosen(asking).front(), best.key);
  EXPECT_EQ(matcher.chosen(asking).size(), max_given);
  remove_participant(matcher, ParticipantId(3), Reason::left);
  EXPECT_EQ(matcher.chosen(asking).size(), max_given);
  for (std::uint32_t number = 1; number <= 2; ++number) {
    matcher.remove_publication(key(2, 1, number), Reason::withdrawn);
    EXPECT_EQ(matcher.chosen(asking).size(), max_given + 1 - number);
  }
}

TEST(Bounds, AProviderIsToldOfSoManyConsumersAndOfTheOthersWhenHalfHaveGone) {
  Matcher matcher;
  const ServiceKey offering = key(here, 1, 1);
  auto offered = offer(offering, ball);
  offered.publication.mode = ChannelMode::one_to_many_pubsub;
  matcher.put(offered);
  const auto asking = [&](std::uint32_t number) {
    auto one = request(key(2, 1, number), ball);
    one.subscription.mode = ChannelMode::one_to_many_pubsub;
    return one;
  };
  for (std::uint32_t number = 1; number <= max_consumers + 2; ++number) {
    matcher.put(asking(number));
    EXPECT_EQ(matcher.consumers(offering).size(), std::min<std::size_t>(number, max_consumers));
  }
  std::uint32_t number = 1;
  for (; number < max_consumers / 2; ++number) matcher.remove_subscription(key(2, 1, number), Reason::withdrawn);
  EXPECT_EQ(matcher.consumers(offering).size(), max_consumers / 2 + 1);
  matcher.remove_subscription(key(2, 1, number), Reason::withdrawn);
  EXPECT_EQ(matcher.consumers(offering).size(), max_consumers / 2 + 2) << "those that waited are taken up";
}

}  // namespace
}  // namespace geminga::matching
