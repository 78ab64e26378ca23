// PREFERENCES.md: the providers that a consumer wants first, and when it changes to another.
#include "discovery/matching/arbitration/preferences.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "discovery/matching/team.hpp"

namespace geminga::matching {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const Identity ball = TextIdentity{"ball"};
const ServiceKey consumer = key(here, 1, 1);

/// A consumer that takes the best, and three providers on other hosts: p2.1.1 rate 10, p3.1.1 rate 20, p4.1.1 rate 30.
class Preferring : public testing::Test {
 protected:
  static registry::PublicationEntry provider(std::uint32_t host, const std::string& rate) {
    auto entry = offer(key(host, 1, 1), ball);
    if (!rate.empty()) entry.publication.attributes["rate"] = rate;
    return entry;
  }
  void put_all() {
    for (std::uint32_t host = 2; host <= 4; ++host) matcher.put(provider(host, std::to_string(10 * (host - 1))));
  }
  std::vector<std::string> ask(std::uint32_t limit, const std::string& prefer,
                               std::vector<ProviderFilter> favoured = {}, const std::string& rank = "") {
    auto wish = request(consumer, ball, limit, Degree::broader);
    wish.subscription.prefer = prefer;
    wish.subscription.favoured = std::move(favoured);
    wish.subscription.rank = rank;
    matcher.put(wish);
    return told(matcher);
  }

  Matcher matcher;
};

TEST_F(Preferring, TheGreatestOrTheSmallestIsFirst) {
  put_all();
  EXPECT_THAT(ask(1, "rate desc"), ElementsAre("p1.1.1 pub add p4.1.1 exact 0"));
  EXPECT_THAT(ask(1, "rate asc"), ElementsAre("p1.1.1 pub add p2.1.1 exact 0", "p1.1.1 pub del p4.1.1 outranked"));
  EXPECT_THAT(ask(1, "", {}), IsEmpty()) << "without a preference all are the same, and the incumbent stays";
}

TEST_F(Preferring, WhoSaysNothingIsLast) {
  matcher.put(provider(2, ""));
  matcher.put(provider(3, "fast"));
  matcher.put(provider(4, "1"));
  EXPECT_THAT(ask(1, "rate desc"), ElementsAre("p1.1.1 pub add p4.1.1 exact 0"));
  EXPECT_THAT(ask(1, "rate asc"), IsEmpty());
  EXPECT_THAT(ask(2, "rate asc"), ElementsAre("p1.1.1 pub add p2.1.1 exact 0")) << "the smaller key of the two";
}

TEST_F(Preferring, AWishIsFollowedByTheNext) {
  auto far = provider(2, "10");
  auto near = provider(3, "10");
  far.publication.attributes["range"] = "3 m";
  near.publication.attributes["range"] = "50 cm";
  matcher.put(far);
  matcher.put(near);
  matcher.put(provider(4, "20"));
  EXPECT_THAT(ask(1, "rate asc, range asc"), ElementsAre("p1.1.1 pub add p3.1.1 exact 0"));
  EXPECT_THAT(ask(1, "rate asc, range desc"),
              ElementsAre("p1.1.1 pub add p2.1.1 exact 0", "p1.1.1 pub del p3.1.1 outranked"));
}

TEST_F(Preferring, FavouritesComeInTheirOrderAndThenAllOthers) {
  put_all();
  EXPECT_THAT(ask(1, "rate desc", {{"robot3", ""}, {"robot2", "module1"}}),
              ElementsAre("p1.1.1 pub add p3.1.1 exact 0"));
  matcher.remove_publication(key(3, 1, 1), Reason::withdrawn);
  EXPECT_THAT(told(matcher), ElementsAre("p1.1.1 pub del p3.1.1 withdrawn", "p1.1.1 pub add p2.1.1 exact 0"));
  matcher.remove_publication(key(2, 1, 1), Reason::left);
  EXPECT_THAT(told(matcher), ElementsAre("p1.1.1 pub del p2.1.1 left", "p1.1.1 pub add p4.1.1 exact 0"));
  matcher.put(provider(3, "0"));
  EXPECT_THAT(told(matcher), ElementsAre("p1.1.1 pub add p3.1.1 exact 0", "p1.1.1 pub del p4.1.1 outranked"))
      << "the favourite is back";
}

TEST_F(Preferring, PriorityCountsBeforeWishesUnlessRankSaysOtherwise) {
  put_all();
  auto important = provider(2, "10");
  important.publication.priority = 1;
  matcher.put(important);
  EXPECT_THAT(ask(1, "rate desc"), ElementsAre("p1.1.1 pub add p2.1.1 exact 0"));
  EXPECT_THAT(ask(1, "rate desc", {}, "prefer"),
              ElementsAre("p1.1.1 pub add p4.1.1 exact 0", "p1.1.1 pub del p2.1.1 outranked"));
  EXPECT_THAT(ask(1, "rate desc", {{"robot3", ""}}, "prefer,favour"), IsEmpty());
}

TEST_F(Preferring, AnIncumbentGivesWayOnlyToWhoIsBetterByTheMargin) {
  put_all();
  EXPECT_THAT(ask(1, "rate desc by 5"), ElementsAre("p1.1.1 pub add p4.1.1 exact 0"));
  matcher.put(provider(2, "34.9"));
  EXPECT_THAT(told(matcher), IsEmpty());
  matcher.put(provider(2, "35"));
  EXPECT_THAT(told(matcher), ElementsAre("p1.1.1 pub add p2.1.1 exact 0", "p1.1.1 pub del p4.1.1 outranked"));
  matcher.put(provider(2, "26"));
  EXPECT_THAT(told(matcher), ElementsAre("p1.1.1 pub modify p2.1.1 exact 0")) << "worse by less than the margin";
  matcher.put(provider(2, "25"));
  EXPECT_THAT(told(matcher), ElementsAre("p1.1.1 pub add p4.1.1 exact 0", "p1.1.1 pub del p2.1.1 outranked"));
}

TEST_F(Preferring, AMarginHasTheUnitOfItsValues) {
  auto one = provider(2, "");
  auto other = provider(3, "");
  one.publication.attributes["range"] = "2 m";
  other.publication.attributes["range"] = "1.9 m";
  matcher.put(one);
  EXPECT_THAT(ask(1, "range asc by 20 cm"), ElementsAre("p1.1.1 pub add p2.1.1 exact 0"));
  matcher.put(other);
  EXPECT_THAT(told(matcher), IsEmpty());
  other.publication.attributes["range"] = "1";
  matcher.put(other);
  EXPECT_THAT(told(matcher), IsEmpty()) << "nobody guesses the unit";
  other.publication.attributes["range"] = "1790 mm";
  matcher.put(other);
  EXPECT_THAT(told(matcher), ElementsAre("p1.1.1 pub add p3.1.1 exact 0", "p1.1.1 pub del p2.1.1 outranked"));
}

TEST_F(Preferring, TheSameLengthInAnotherUnitIsNoBetter) {
  matcher.put(provider(3, "70 cm"));
  EXPECT_THAT(ask(1, "rate asc"), ElementsAre("p1.1.1 pub add p3.1.1 exact 0"));
  matcher.put(provider(4, "0.7 m"));
  matcher.put(provider(2, "0.7 m"));
  EXPECT_THAT(told(matcher), IsEmpty()) << "0.7 m and 70 cm differ by what rounding makes of them";
}

TEST_F(Preferring, WhoIsBetterByJustTheMarginTakesThePlace) {
  matcher.put(provider(2, "15 cm"));
  EXPECT_THAT(ask(1, "rate asc by 5 cm"), ElementsAre("p1.1.1 pub add p2.1.1 exact 0"));
  matcher.put(provider(3, "10.01 cm"));
  EXPECT_THAT(told(matcher), IsEmpty());
  matcher.put(provider(3, "10 cm"));
  EXPECT_THAT(told(matcher), ElementsAre("p1.1.1 pub add p3.1.1 exact 0", "p1.1.1 pub del p2.1.1 outranked"));
}

TEST_F(Preferring, WhoIsBetterByJustAMarginWithoutUnitTakesThePlace) {
  matcher.put(provider(2, "1000.1"));
  EXPECT_THAT(ask(1, "rate desc by 0.05"), ElementsAre("p1.1.1 pub add p2.1.1 exact 0"));
  matcher.put(provider(3, "1000.1499"));
  EXPECT_THAT(told(matcher), IsEmpty());
  matcher.put(provider(3, "1000.15"));
  EXPECT_THAT(told(matcher), ElementsAre("p1.1.1 pub add p3.1.1 exact 0", "p1.1.1 pub del p2.1.1 outranked"));
}

TEST_F(Preferring, TheBestOfManyAreFoundWhenThePreferenceChanges) {
  // More than a choice remembers, so that some were dropped by an order that does not hold any longer.
  for (std::uint32_t host = 2; host < 60; ++host) matcher.put(provider(host, std::to_string(host)));
  EXPECT_EQ(ask(2, "rate asc").size(), 2U);
  EXPECT_THAT(ask(2, "rate desc"), ElementsAre("p1.1.1 pub add p59.1.1 exact 0", "p1.1.1 pub add p58.1.1 exact 0",
                                               "p1.1.1 pub del p2.1.1 outranked", "p1.1.1 pub del p3.1.1 outranked"));
}

TEST_F(Preferring, WhatCannotBeReadIsRefusedAndFromOthersPrefersNothing) {
  const auto fault = [](const std::string& prefer, const std::string& rank) {
    Subscription asked;
    asked.prefer = prefer;
    asked.rank = rank;
    const auto error = check_preferences(asked);
    return error ? error->text : "";
  };
  for (const char* prefer : {"rate", "rate up", "asc", "rate asc,", ",rate asc", "rate asc by", "rate asc by x",
                             "rate asc by -1", "rate asc by 5 foo", "rate asc rate desc", "r\xc3\xa4te asc", "a/b asc",
                             " ", "rate asc within 5", "a asc, b asc, c asc, d asc, e asc", "attr. asc"}) {
    EXPECT_THAT(fault(prefer, ""), HasSubstr("prefer: ")) << prefer;
  }
  for (const char* rank : {"rate", "degree,degree", "degree,", ",degree", "Degree", " "}) {
    EXPECT_THAT(fault("", rank), HasSubstr("rank: ")) << rank;
  }
  for (const char* prefer : {"", "rate asc", " rate  asc ", "attr.port desc", "a asc,b desc by 0 , c asc by 1e3 m/s"}) {
    EXPECT_EQ(fault(prefer, "distance, degree,favour,prefer,priority"), "") << prefer;
  }
  put_all();
  EXPECT_THAT(ask(1, "rate upwards"), ElementsAre("p1.1.1 pub add p2.1.1 exact 0"));
}

}  // namespace
}  // namespace geminga::matching
