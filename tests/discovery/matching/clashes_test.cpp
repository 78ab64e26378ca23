// A number matches the concept whose 32-bit identity it is, unless two concepts share the number.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "discovery/matching/meeting/obstacle.hpp"
#include "discovery/matching/team.hpp"

namespace geminga::matching {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Identity concept_of(int number) {
  return SemanticIdentity{.concept_iri = "http://clash.example/#C" + std::to_string(number), .representation_iri = {}};
}

/// The first two of them with one 32-bit identity.
std::pair<Identity, Identity> twins() {
  std::pair two{concept_of(27'646), concept_of(303'210)};
  EXPECT_EQ(id32(two.first), id32(two.second));
  return two;
}

std::vector<ServiceKey> told_of_a_clash(Matcher& matcher) {
  std::vector<ServiceKey> keys;
  for (const Clash& clash : matcher.take_clashes()) {
    EXPECT_THAT(clash.text, HasSubstr("two different services, <http://clash.example/#C"));
    keys.push_back(clash.to);
  }
  return keys;
}

TEST(Clash, ANumberMeetsTheConceptWhoseHashItIs) {
  const Identity named = concept_of(1);
  const Identity number = NumericIdentity{id32(named)};
  for (const auto& [offered, asked] : {std::pair(named, number), std::pair(number, named)}) {
    for (const bool offer_comes_first : {true, false}) {
      Matcher matcher;
      if (offer_comes_first) matcher.put(offer(key(2, 1, 7), offered));
      matcher.put(request(key(here, 1, 1), asked));
      if (!offer_comes_first) matcher.put(offer(key(2, 1, 7), offered));
      EXPECT_THAT(told(matcher), ElementsAre("p1.1.1 pub add p2.1.7 exact 0"));
      EXPECT_THAT(matched(matcher, request(key(here, 1, 1), asked).subscription), ElementsAre(key(2, 1, 7)));
    }
  }
  Matcher matcher;
  matcher.put(offer(key(2, 1, 7), TextIdentity{"a text"}));
  matcher.put(request(key(here, 1, 1), NumericIdentity{id32(TextIdentity{"a text"})}));
  EXPECT_THAT(told(matcher), IsEmpty()) << "a text has no part in this";
}

TEST(Clash, IsWhyTheTwoDoNotMeet) {
  const auto [one, other] = twins();
  Matcher matcher;
  const auto asks = request(key(here, 1, 1), NumericIdentity{id32(one)});
  matcher.put(asks);
  matcher.put(offer(key(2, 1, 1), one));
  const auto* offered = matcher.publications().find_entry(key(2, 1, 1));
  EXPECT_TRUE(matcher.examination().why(asks, *offered));
  EXPECT_TRUE(matcher.examination().examine(asks, *matcher.examination().prepare(asks), *offered).meets());
  matcher.put(offer(key(3, 1, 1), other));
  const auto why = matcher.examination().why(asks, *offered);
  ASSERT_FALSE(why);
  EXPECT_THAT(why.error(), HasSubstr("that of two different services"));
  EXPECT_EQ(matcher.examination().examine(asks, *matcher.examination().prepare(asks), *offered).first(),
            Obstacle::clash);
}

TEST(Clash, IsNotWhyANumberDoesNotMeetAnotherConcept) {
  const auto [one, other] = twins();
  Matcher matcher;
  matcher.put(request(key(here, 1, 1), NumericIdentity{id32(one)}));
  for (std::uint32_t peer = 1; const Identity& offered : {one, other, concept_of(-1)})
    matcher.put(offer(key(2, peer++, 1), offered));
  const auto asks = request(key(here, 1, 1), NumericIdentity{id32(one)});
  const auto* ball = matcher.publications().find_entry(key(2, 3, 1));
  EXPECT_EQ(matcher.examination().examine(asks, *matcher.examination().prepare(asks), *ball).first(), Obstacle::kind);
}

TEST(Clash, IsToldOnceHoweverOftenItsPartsChangeOtherwise) {
  const auto [one, other] = twins();
  Matcher matcher;
  const auto asks = request(key(here, 1, 1), NumericIdentity{id32(one)});
  matcher.put(asks);
  matcher.put(offer(key(here, 2, 1), one));
  auto remote = offer(key(3, 1, 1), other);
  matcher.put(remote);
  EXPECT_EQ(told_of_a_clash(matcher).size(), 2U);
  remote.publication.attributes["rate"] = "30";
  matcher.put(remote);
  EXPECT_THAT(told_of_a_clash(matcher), IsEmpty());
  auto faster = asks;
  faster.subscription.priority = 1;
  matcher.put(faster);
  EXPECT_THAT(told_of_a_clash(matcher), IsEmpty());
  // A peer that begins to use the number is told of the clash, and so are the peers that it cannot meet.
  remote.publication.identity = NumericIdentity{id32(one)};
  matcher.put(remote);
  EXPECT_THAT(told_of_a_clash(matcher), IsEmpty()) << "the clash is over";
  matcher.put(request(key(3, 1, 2), other));
  EXPECT_EQ(told_of_a_clash(matcher).size(), 2U);
  matcher.put(request(key(3, 1, 3), NumericIdentity{id32(one)}));
  EXPECT_EQ(told_of_a_clash(matcher).size(), 2U);
}

TEST(Clash, AProviderThatAClashKeptApartIsNoIncumbentWhenItEnds) {
  const auto [one, other] = twins();
  const Identity number = NumericIdentity{id32(one)};
  Matcher matcher;
  auto apart = offer(key(3, 1, 1), number);
  apart.publication.protocol = "tcp";
  matcher.put(apart);
  matcher.put(offer(key(2, 1, 1), number));
  matcher.put(request(key(4, 1, 1), other));
  auto asks = request(key(9, 1, 1), one);
  asks.subscription.protocols = {"tcp"};
  matcher.put(asks);
  // The clash ends with the concept that the request asked for, and the limit makes the choice matter here.
  matcher.put(request(key(9, 1, 1), number, 1));
  EXPECT_THAT(matcher.choices().chosen(key(9, 1, 1)), ElementsAre(key(2, 1, 1)))
      << "the smaller key, since nobody was there";
}

TEST(Clash, TwoConceptsThatShareANumberAreNotConnectedByItAndBothSidesAreTold) {
  const auto [one, other] = twins();
  const Identity number = NumericIdentity{id32(one)};
  Matcher matcher;
  matcher.put(request(key(here, 1, 1), number));
  matcher.put(request(key(here, 1, 2), one));
  matcher.put(offer(key(here, 2, 1), one));
  EXPECT_THAT(told(matcher), ElementsAre("p1.1.1 pub add p1.2.1 exact 0", "p1.2.1 sub add p1.1.1 exact 0",
                                         "p1.1.2 pub add p1.2.1 exact 0", "p1.2.1 sub add p1.1.2 exact 0"));
  EXPECT_THAT(told_of_a_clash(matcher), IsEmpty());
  matcher.put(offer(key(2, 1, 7), other));
  EXPECT_THAT(told(matcher), ElementsAre("p1.1.1 pub del p1.2.1 changed", "p1.2.1 sub del p1.1.1 changed"));
  EXPECT_THAT(told_of_a_clash(matcher),
              testing::UnorderedElementsAre(key(here, 1, 1), key(here, 1, 2), key(here, 2, 1)));
  matcher.remove_publication(key(2, 1, 7), Reason::left);
  EXPECT_THAT(told(matcher), ElementsAre("p1.1.1 pub add p1.2.1 exact 0", "p1.2.1 sub add p1.1.1 exact 0"));
  EXPECT_THAT(told_of_a_clash(matcher), IsEmpty());
}

TEST(Clash, TwoConceptsThatShareANumberWhichNobodyUsesAreNobodysBusiness) {
  const auto [one, other] = twins();
  Matcher matcher;
  matcher.put(request(key(here, 1, 1), one));
  matcher.put(offer(key(here, 2, 1), other));
  matcher.put(offer(key(here, 2, 2), one));
  EXPECT_THAT(told(matcher), ElementsAre("p1.1.1 pub add p1.2.2 exact 0", "p1.2.2 sub add p1.1.1 exact 0"));
  EXPECT_THAT(told_of_a_clash(matcher), IsEmpty());
}

}  // namespace
}  // namespace geminga::matching
