// Which pairs are judged here, and how many one request or one offer may be in: what the air brings must not fill a
// host's memory.
#include "discovery/matching/interest.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "discovery/matching/matcher.hpp"
#include "discovery/matching/team.hpp"

namespace geminga::matching {
namespace {

const Identity ball = TextIdentity{"ball"};

TEST(Interest, IsInAllPairsOfALocalConsumerAndInThoseOfOthersThatTellAProviderHere) {
  const auto mine = offer(key(here, 1, 1), ball);
  const auto others = offer(key(2, 1, 1), ball);
  EXPECT_TRUE(is_of_interest(request(key(here, 1, 1), ball), others));
  auto remote = request(key(3, 1, 1), ball);
  EXPECT_TRUE(is_of_interest(remote, mine));
  EXPECT_FALSE(is_of_interest(remote, others)) << "without a limit no provider stands in the way of another";
  remote.subscription.limit = max_counted_providers;
  EXPECT_TRUE(is_of_interest(remote, others));
  remote.subscription.limit = max_counted_providers + 1;
  EXPECT_FALSE(is_of_interest(remote, others));
  remote.subscription.limit = 1;
  remote.subscription.chosen = {others.key};
  EXPECT_FALSE(is_of_interest(remote, mine)) << "its host has chosen";
  remote.subscription.chosen = {mine.key};
  EXPECT_TRUE(is_of_interest(remote, mine));
  remote.subscription.mode = ChannelMode::one_to_many_stream;
  EXPECT_FALSE(is_of_interest(remote, mine)) << "providers of streams are not told";
}

TEST(Interest, OfAChoiceIsWhereALimitDecides) {
  EXPECT_EQ(arbitrated_limit(request(key(here, 1, 1), ball)), max_given);
  EXPECT_EQ(arbitrated_limit(request(key(here, 1, 1), ball, 3)), 3U);
  EXPECT_TRUE(is_chosen_here(request(key(here, 1, 1), ball)));
  EXPECT_FALSE(is_chosen_here(request(key(2, 1, 1), ball)));
  for (const std::uint32_t limit : {max_counted_providers - 1, max_counted_providers, max_counted_providers + 1}) {
    const auto remote = request(key(2, 1, 1), ball, limit);
    EXPECT_EQ(is_chosen_here(remote), limit <= max_counted_providers) << limit;
    EXPECT_EQ(arbitrated_limit(remote), limit <= max_counted_providers ? limit : 0) << limit;
    EXPECT_EQ(counted_limit(remote), limit);
  }
}

TEST(Bounds, AConsumerThatAsksForAllIsGivenTheBestOfSoMany) {
  Matcher matcher;
  const ServiceKey asking = key(here, 1, 1);
  matcher.put(request(asking, ball));
  for (std::uint32_t number = 1; number <= max_given + 1; ++number) {
    matcher.put(offer(key(2, 1, number), ball));
    EXPECT_EQ(matcher.choices().chosen(asking).size(), std::min(number, max_given));
  }
  auto best = offer(key(3, 1, 1), ball);
  best.publication.priority = 1;
  matcher.put(best);
  EXPECT_EQ(matcher.choices().chosen(asking).front(), best.key);
  EXPECT_EQ(matcher.choices().chosen(asking).size(), max_given);
  remove_participant(matcher, ParticipantId(3), Reason::left);
  EXPECT_EQ(matcher.choices().chosen(asking).size(), max_given);
  for (std::uint32_t number = 1; number <= 2; ++number) {
    matcher.remove_publication(key(2, 1, number), Reason::withdrawn);
    EXPECT_EQ(matcher.choices().chosen(asking).size(), max_given + 1 - number);
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
    EXPECT_EQ(matcher.choices().consumers(offering).size(), std::min<std::size_t>(number, max_consumers));
  }
  std::uint32_t number = 1;
  for (; number < max_consumers / 2; ++number) matcher.remove_subscription(key(2, 1, number), Reason::withdrawn);
  EXPECT_EQ(matcher.choices().consumers(offering).size(), max_consumers / 2 + 1);
  matcher.remove_subscription(key(2, 1, number), Reason::withdrawn);
  EXPECT_EQ(matcher.choices().consumers(offering).size(), max_consumers / 2 + 2) << "those that waited are taken up";
}

}  // namespace
}  // namespace geminga::matching
