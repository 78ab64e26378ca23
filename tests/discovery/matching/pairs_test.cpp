// Judging makes candidates, settling makes choices and events.
#include "discovery/matching/pairs.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "discovery/matching/owners.hpp"

namespace geminga::matching {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

const Identity ball = TextIdentity{"ball"};

TEST(Pairs, AreTakenIntoAccountWhenJudgedAndToldWhenSettled) {
  Owners owners;
  const auto& asked = owners.add(request(key(here, 1, 1), ball));
  const auto& offered = owners.add(offer(key(2, 1, 1), ball));
  const auto& other = owners.add(offer(key(2, 1, 2), TextIdentity{"robot"}));
  Cause cause;
  owners.pairs.judge(asked, offered, cause);
  owners.pairs.judge(asked, other, cause);
  EXPECT_TRUE(owners.pairs.considered_by(offered).contains(asked.slot));
  EXPECT_TRUE(owners.pairs.considered_by(other).empty());
  EXPECT_FALSE(owners.pairs.chosen_match(asked, offered)) << "not yet";
  EXPECT_THAT(owners.told(), IsEmpty());
  owners.pairs.settle(asked, cause);
  EXPECT_TRUE(owners.pairs.chosen_match(asked, offered));
  EXPECT_THAT(owners.told(), ElementsAre("p1.1.1 pub add p2.1.1 exact 0"));
}

TEST(Pairs, OfAllPublicationsOfASubscriptionAreJudgedAtOnce) {
  Owners owners;
  owners.add(offer(key(2, 1, 1), ball, 1));
  owners.add(offer(key(2, 1, 2), ball, 2));
  const auto& asked = owners.add(request(key(here, 1, 1), ball, 1));
  Cause cause;
  owners.pairs.judge_anew({&asked}, cause);
  EXPECT_THAT(owners.told(), ElementsAre("p1.1.1 pub add p2.1.2 exact 0"));
  EXPECT_EQ(owners.judge.judged(), 2U);
}

TEST(Pairs, DoNotTellAConsumerThatTheCauseLeavesUntold) {
  Owners owners;
  owners.add(offer(key(here, 1, 2), ball));
  const auto& asked = owners.add(request(key(here, 1, 1), ball));
  Cause cause;
  cause.untold = &asked;
  owners.pairs.judge_all(asked, cause);
  owners.pairs.settle(asked, cause);
  EXPECT_THAT(owners.told(), ElementsAre("p1.1.2 sub add p1.1.1 exact 0"));
}

TEST(Pairs, ThatAreWithdrawnGiveWhomToSettleInOrderOfKey) {
  Owners owners;
  const auto& gone = owners.add(offer(key(2, 1, 1), ball));
  owners.add(offer(key(2, 1, 2), ball));
  std::vector<const registry::StoredSubscription*> asked;
  for (const std::uint32_t number : {2U, 1U}) asked.push_back(&owners.add(request(key(here, 1, number), ball, 1)));
  Cause cause;
  owners.pairs.judge_anew(asked, cause);
  (void)owners.told();
  owners.directory.offers().retire({&gone}, Reason::left);
  const auto concerned = owners.pairs.withdraw({&gone}, Reason::left);
  EXPECT_THAT(concerned, ElementsAre(asked[1], asked[0]));
  EXPECT_TRUE(owners.pairs.considered_by(gone).empty());
  for (const auto* one : concerned) owners.pairs.settle(*one, cause);
  EXPECT_THAT(owners.told(), ElementsAre("p1.1.1 pub del p2.1.1 left", "p1.1.1 pub add p2.1.2 exact 0",
                                         "p1.1.2 pub del p2.1.1 left", "p1.1.2 pub add p2.1.2 exact 0"));
}

TEST(Pairs, OfASubscriptionThatEndsAreToldToItsProvidersAlone) {
  Owners owners;
  const auto& offered = owners.add(offer(key(here, 1, 2), ball));
  const auto& asked = owners.add(request(key(here, 1, 1), ball));
  Cause cause;
  owners.pairs.judge_anew({&asked}, cause);
  (void)owners.told();
  owners.pairs.end(asked, Reason::withdrawn, cause);
  EXPECT_THAT(owners.told(), ElementsAre("p1.1.2 sub del p1.1.1 withdrawn"));
  EXPECT_TRUE(owners.pairs.considered_by(offered).empty());
  EXPECT_THAT(owners.pairs.choice(asked).chosen(), IsEmpty());
}

TEST(Pairs, AnnounceTheChoiceOfARequestThatHadToChooseAndForgetItWithTheRequest) {
  Owners owners;
  owners.add(offer(key(2, 1, 1), ball, 1));
  const auto& second = owners.add(offer(key(2, 1, 2), ball, 2));
  const auto& asked = owners.add(request(key(here, 1, 1), ball, 1));
  Cause cause;
  owners.pairs.judge_anew({&asked}, cause);
  EXPECT_THAT(owners.pairs.announced().keys(asked), ElementsAre(second.entry.key));
  EXPECT_TRUE(owners.pairs.take_choice_change());
  EXPECT_FALSE(owners.pairs.take_choice_change());
  owners.pairs.end(asked, Reason::withdrawn, cause);
  EXPECT_THAT(owners.pairs.announced().keys(asked), IsEmpty());
  EXPECT_FALSE(owners.pairs.take_choice_change());
}

}  // namespace
}  // namespace geminga::matching
