// Questions to the matcher: which publication has the place, which meet a request, which requests are served.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "discovery/matching/matcher.hpp"
#include "discovery/matching/team.hpp"

namespace geminga::matching {
namespace {

using testing::ElementsAre;
using enum ChannelMode;

const Identity ball = TextIdentity{"ball"};

TEST(Matcher, SaysWhoHasThePlaceThatAPublicationDoesNotGet) {
  Matcher matcher;
  matcher.put(request(key(here, 1, 1), ball, 1));
  matcher.put(offer(key(3, 1, 1), ball, 1));
  matcher.put(offer(key(2, 1, 1), ball, 1));
  matcher.put(offer(key(4, 1, 1), ball, 0));
  matcher.put(offer(key(5, 1, 1), TextIdentity{"goal"}));
  const auto standing = [&](std::uint32_t participant) {
    return standing_of(matcher, key(here, 1, 1), key(participant, 1, 1));
  };
  ASSERT_TRUE(standing(2) && standing(3) && standing(4));
  EXPECT_FALSE(standing(5)) << "it does not match";
  EXPECT_TRUE(standing(3)->is_chosen) << "it was there first";
  EXPECT_EQ(standing(3)->rank, 2U);
  EXPECT_EQ(standing(3)->candidates, 3U);
  EXPECT_EQ(standing(3)->decided, Standing::Decided::by_incumbent);
  EXPECT_FALSE(standing(2)->is_chosen) << "its key is smaller, which does not count against one that was there first";
  EXPECT_EQ(standing(2)->rival->key, key(3, 1, 1));
  EXPECT_EQ(standing(2)->decided, Standing::Decided::by_incumbent);
  EXPECT_FALSE(standing(4)->is_chosen);
  EXPECT_EQ(standing(4)->decided, Standing::Decided::by_rank);
  matcher.put(request(key(here, 1, 1), ball));
  EXPECT_TRUE(standing(4)->is_chosen) << "without a limit everything is";
}

TEST(Matcher, OfAConsumerElsewhereItSaysWhatTheRankingSays) {
  Matcher matcher;
  matcher.put(request(key(9, 1, 1), ball, 1, Degree::narrower, one_to_many_stream));
  matcher.put(offer(key(3, 1, 1), ball, 1, one_to_many_stream));
  matcher.put(offer(key(2, 1, 1), ball, 1, one_to_many_stream));
  const auto standing = standing_of(matcher, key(9, 1, 1), key(3, 1, 1));
  ASSERT_TRUE(standing);
  EXPECT_EQ(standing->decided, Standing::Decided::elsewhere);
  EXPECT_FALSE(standing->is_chosen);
  EXPECT_EQ(standing->rival->key, key(2, 1, 1));
}

TEST(Matcher, FindsWhatMeetsARequest) {
  Matcher matcher;
  matcher.put(offer(key(2, 1, 1), ball, 1));
  matcher.put(offer(key(3, 1, 2), ball, 5));
  matcher.put(offer(key(3, 1, 1), ball, 1));
  matcher.put(offer(key(3, 1, 3), TextIdentity{"goal"}, 9));
  const Subscription asked = request(key(here, 1, 1), ball, 1).subscription;
  EXPECT_THAT(matched(matcher, asked), ElementsAre(key(2, 1, 1), key(3, 1, 1), key(3, 1, 2)));
  EXPECT_FALSE(matcher.search().candidates(asked, *matcher.examination().prepare(asked), 2)) << "they are more";
}

TEST(Matcher, KnowsWhoIsServedAndUsedInTheWholeTeam) {
  Matcher matcher;
  matcher.put(offer(key(2, 1, 1), ball));
  matcher.put(offer(key(2, 1, 2), TextIdentity{"goal"}));
  matcher.put(request(key(3, 1, 1), ball));
  matcher.put(request(key(3, 1, 2), TextIdentity{"line"}, 1));
  EXPECT_TRUE(matcher.search().is_used(*matcher.publications().find_entry(key(2, 1, 1))));
  EXPECT_FALSE(matcher.search().is_used(*matcher.publications().find_entry(key(2, 1, 2))));
  EXPECT_TRUE(matcher.search().is_served(*matcher.subscriptions().find_entry(key(3, 1, 1))));
  EXPECT_FALSE(matcher.search().is_served(*matcher.subscriptions().find_entry(key(3, 1, 2))));
}

TEST(Matcher, ListsEntriesByKey) {
  Matcher matcher;
  for (const auto& one : {key(3, 1, 1), key(1, 2, 1), key(2, 1, 5), key(2, 1, 4)}) {
    matcher.put(offer(one, ball));
    matcher.put(request(one, ball));
  }
  std::vector<ServiceKey> publications;
  std::vector<ServiceKey> subscriptions;
  EXPECT_TRUE(matcher.publications().visit_after(std::nullopt, [&](const auto& stored) {
    publications.push_back(stored.entry.key);
    return true;
  }));
  EXPECT_TRUE(matcher.subscriptions().visit_after(std::nullopt, [&](const auto& stored) {
    subscriptions.push_back(stored.entry.key);
    return true;
  }));
  EXPECT_THAT(publications, ElementsAre(key(1, 2, 1), key(2, 1, 4), key(2, 1, 5), key(3, 1, 1)));
  EXPECT_EQ(subscriptions, publications);
}

}  // namespace
}  // namespace geminga::matching
