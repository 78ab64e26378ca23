// A participant that leaves is removed in steps.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "discovery/matching/matcher.hpp"
#include "discovery/matching/team.hpp"

namespace geminga::matching {
namespace {

using testing::ElementsAre;

const Identity ball = TextIdentity{"ball"};

TEST(Matcher, NothingOfAParticipantThatIsLeavingIsGivenBetweenTheSteps) {
  Matcher matcher;
  for (std::uint32_t number = 1; number <= 3; ++number) matcher.put(offer(key(2, 1, number), ball, 9));
  matcher.put(request(key(2, 1, 9), ball, 1));
  matcher.put(offer(key(3, 1, 1), ball));
  matcher.put(offer(key(here, 1, 5), ball, 1));
  matcher.put(request(key(here, 1, 1), ball, 1));
  matcher.put(request(key(here, 1, 2), ball, 2));
  (void)matcher.take_events();
  matcher.begin_departure(ParticipantId{2}, Reason::left);
  matcher.put(request(key(here, 1, 3), ball, 1));
  EXPECT_THAT(told(matcher), ElementsAre("p1.1.3 pub add p1.1.5 exact 0", "p1.1.5 sub add p1.1.3 exact 0"));
  std::vector<std::string> words;
  int steps = 0;
  while (matcher.take_step()) {
    ++steps;
    for (const std::string& one : told(matcher)) words.push_back(one);
    EXPECT_THAT(matched(matcher, request(key(here, 1, 1), ball).subscription),
                ElementsAre(key(here, 1, 5), key(3, 1, 1)));
  }
  EXPECT_GT(steps, 5) << "one for each that is concerned or goes";
  EXPECT_THAT(words, testing::UnorderedElementsAre("p1.1.1 pub del p2.1.1 left", "p1.1.1 pub add p1.1.5 exact 0",
                                                   "p1.1.5 sub add p1.1.1 exact 0", "p1.1.2 pub del p2.1.1 left",
                                                   "p1.1.2 pub del p2.1.2 left", "p1.1.2 pub add p1.1.5 exact 0",
                                                   "p1.1.5 sub add p1.1.2 exact 0", "p1.1.2 pub add p3.1.1 exact 0"));
  EXPECT_EQ(matcher.publications().size(), 2U);
  EXPECT_EQ(matcher.subscriptions().size(), 3U);
}

TEST(Matcher, TellsOfAWithdrawalInStepsInTheOrderOfTheRequestsAndNotOfTheirMaking) {
  Matcher matcher;
  matcher.put(offer(key(2, 1, 1), ball));
  for (const std::uint32_t number : {3U, 1U, 2U}) matcher.put(request(key(here, 1, number), ball));
  (void)matcher.take_events();
  matcher.begin_removal_of_publication(key(2, 1, 1), Reason::withdrawn);
  std::vector<std::string> words;
  while (matcher.take_step()) {
    for (const std::string& one : told(matcher)) words.push_back(one);
  }
  EXPECT_THAT(words, ElementsAre("p1.1.1 pub del p2.1.1 withdrawn", "p1.1.2 pub del p2.1.1 withdrawn",
                                 "p1.1.3 pub del p2.1.1 withdrawn"));
}

TEST(Matcher, WhoComesBackBeforeHisDepartureIsOverIsThere) {
  Matcher matcher;
  matcher.put(offer(key(2, 1, 1), ball));
  matcher.put(offer(key(2, 1, 2), ball));
  matcher.put(request(key(here, 1, 1), ball));
  (void)matcher.take_events();
  matcher.begin_departure(ParticipantId{2}, Reason::left);
  EXPECT_FALSE(matcher.remove_publication(key(2, 1, 2), Reason::withdrawn)) << "it is going already";
  matcher.put(offer(key(2, 1, 1), ball));
  EXPECT_FALSE(matcher.take_step());
  EXPECT_THAT(told(matcher),
              ElementsAre("p1.1.1 pub del p2.1.1 left", "p1.1.1 pub del p2.1.2 left", "p1.1.1 pub add p2.1.1 exact 0"));
}

}  // namespace
}  // namespace geminga::matching
