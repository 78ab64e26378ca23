// Words of other hosts are judged in steps of bounded work, and end where judging them at once would.
#include "discovery/matching/agenda.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <string>

#include "discovery/matching/matcher.hpp"
#include "discovery/matching/team.hpp"

namespace geminga::matching {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

const Identity ball = TextIdentity{"ball"};

class AgendaTest : public testing::Test {
 protected:
  void ask(std::uint32_t count) {
    for (std::uint32_t number = 1; number <= count; ++number) matcher.put(request(key(here, 1, number), ball));
  }
  void offer_from(std::uint32_t participant, std::uint32_t count) {
    for (std::uint32_t number = 1; number <= count; ++number) matcher.put(offer(key(participant, 1, number), ball));
    drain();
  }
  /// Takes all steps, each of which must be small.
  void drain() {
    while (true) {
      const std::uint64_t judged = matcher.judged();
      const bool is_over = !matcher.take_step();
      EXPECT_LE(matcher.judged() - judged, max_judged_in_step);
      if (is_over) return;
    }
  }
  /// How often each event was told since the last call.
  std::map<std::string, int> counts() {
    std::map<std::string, int> counts;
    for (const std::string& one : told(matcher)) ++counts[one.substr(one.find(' ') + 1)];
    return counts;
  }

  Matcher matcher;
};

using Counts = std::map<std::string, int>;

TEST_F(AgendaTest, TakesAPublicationToAFewRequestsAtOnceAndToManyInSteps) {
  for (const std::size_t count : {max_judged_in_step - 1, max_judged_in_step, max_judged_in_step + 1}) {
    Matcher one;
    for (std::uint32_t number = 1; number <= count; ++number) one.put(request(key(here, 1, number), ball));
    one.put(offer(key(2, 1, 1), ball));
    EXPECT_EQ(told(one).size(), count) << "a little more than a step is still done at once";
    EXPECT_FALSE(one.has_steps());
  }
  const auto many = static_cast<std::uint32_t>(6 * max_judged_in_step);
  ask(many);
  const std::uint64_t judged = matcher.judged();
  matcher.put(offer(key(2, 1, 1), ball));
  EXPECT_LT(matcher.judged() - judged, many);
  EXPECT_TRUE(matcher.has_steps());
  drain();
  EXPECT_EQ(counts(), (Counts{{"pub add p2.1.1 exact 0", many}}));
  EXPECT_FALSE(matcher.has_steps());
}

TEST_F(AgendaTest, TellsEachOfManyOnceThatAPublicationHasChanged) {
  const auto many = static_cast<std::uint32_t>(6 * max_judged_in_step);
  ask(many);
  offer_from(2, 1);
  (void)counts();
  auto changed = offer(key(2, 1, 1), ball);
  changed.publication.port = 6000;
  matcher.put(changed);
  // Meanwhile one asks anew, one changes, and one goes: each is told of the publication as it is.
  matcher.remove_subscription(key(here, 1, many), Reason::withdrawn);
  matcher.put(request(key(here, 1, many), ball));
  matcher.put(request(key(here, 1, many - 1), ball, 1));
  matcher.remove_subscription(key(here, 1, many - 2), Reason::withdrawn);
  drain();
  EXPECT_EQ(counts(), (Counts{{"pub add p2.1.1 exact 0", 1}, {"pub modify p2.1.1 exact 0", many - 2}}));
  matcher.put(changed);
  EXPECT_FALSE(matcher.has_steps()) << "nothing has changed";
}

TEST_F(AgendaTest, TakesTheStepsThatAreLeftBeforeAnotherWordOfOthers) {
  const auto many = static_cast<std::uint32_t>(6 * max_judged_in_step);
  ask(many);
  matcher.put(offer(key(2, 1, 1), ball));
  matcher.put(offer(key(3, 1, 1), Identity(TextIdentity{"robot"})));
  EXPECT_EQ(counts(), (Counts{{"pub add p2.1.1 exact 0", many}}));
}

TEST_F(AgendaTest, ForgetsAPublicationThatIsRemovedMeanwhile) {
  const auto many = static_cast<std::uint32_t>(6 * max_judged_in_step);
  ask(many);
  matcher.put(offer(key(2, 1, 1), ball));
  matcher.begin_removal_of_publication(key(2, 1, 1), Reason::withdrawn);
  drain();
  const Counts all = counts();
  EXPECT_EQ(all.at("pub add p2.1.1 exact 0"), all.at("pub del p2.1.1 withdrawn"));
  EXPECT_EQ(matcher.publications().size(), 0U);
}

TEST_F(AgendaTest, TakesASubscriptionOfAnotherHostThroughManyOffersInSteps) {
  const auto many = static_cast<std::uint32_t>(6 * max_judged_in_step);
  for (std::uint32_t number = 1; number <= many; ++number) matcher.put(offer(key(here, 1, number), ball));
  matcher.put(request(key(2, 1, 1), ball));
  EXPECT_TRUE(matcher.has_steps());
  drain();
  EXPECT_EQ(counts(), (Counts{{"sub add p2.1.1 exact 0", many}}));
  auto changed = request(key(2, 1, 1), ball);
  changed.subscription.port = 6000;
  matcher.put(changed);
  matcher.remove_publication(key(here, 1, many), Reason::withdrawn);
  matcher.put(offer(key(here, 1, many), ball));
  drain();
  Counts all = counts();
  EXPECT_EQ(all.at("sub add p2.1.1 exact 0"), 1);
  EXPECT_GE(all.at("sub modify p2.1.1 exact 0"), static_cast<int>(many) - 1) << "each that it had already";
  matcher.put(request(key(2, 1, 1), Identity(TextIdentity{"robot"})));
  drain();
  EXPECT_EQ(counts(), (Counts{{"sub del p2.1.1 changed", many}}));
}

TEST_F(AgendaTest, OffersAUsedUpChoiceItsCandidatesInSteps) {
  for (const std::size_t count : {max_refilled_at_once - 1, max_refilled_at_once, max_refilled_at_once + 1}) {
    SCOPED_TRACE(count);
    Matcher one;
    one.put(request(key(here, 1, 1), ball, 1));
    for (std::uint32_t number = 1; number <= count; ++number) {
      one.put(offer(key(2 + number % 2, 1, number), ball, number % 2 == 0 ? 1 : 0));
    }
    while (one.take_step()) {
    }
    (void)told(one);
    // Half of them go, and with them all that are remembered.
    one.begin_departure(ParticipantId{2}, Reason::left);
    std::vector<std::string> words;
    while (one.take_step()) {
    }
    words = told(one);
    ASSERT_EQ(words.size(), 2U);
    EXPECT_EQ(words.back(), "p1.1.1 pub add p3.1.1 exact 0");
    EXPECT_EQ(one.choices().chosen(key(here, 1, 1)), std::vector{key(3, 1, 1)});
  }
}

TEST_F(AgendaTest, LooksAtNoMoreForAChangeOfAConverterHoweverManyWait) {
  ask(1);
  offer_from(2, 5);
  matcher.begin_departure(ParticipantId{2}, Reason::left);
  drain();
  EXPECT_THAT(matcher.choices().chosen(key(here, 1, 1)), IsEmpty());
  EXPECT_FALSE(matcher.has_steps());
}

}  // namespace
}  // namespace geminga::matching
