// A site carries what it asks for, and not the world.
#include "discovery/summary/horizon.hpp"

#include <gtest/gtest.h>

#include "discovery/summary/limits.hpp"

namespace geminga::summary {
namespace {

using std::chrono::hours;
using std::chrono::seconds;

constexpr std::uint64_t ours = 5;

base::Instant when(base::Duration time) { return base::Instant(hours(1) + time); }

Topic rank(std::uint32_t number) { return {.digest = ours, .rank = number}; }
Topic iri(const std::string& text) { return {.digest = 0, .rank = 0, .iri = text}; }

Message answer(std::uint64_t site, const Topic& topic, unsigned magnitude, std::uint64_t digest = ours) {
  return {.kind = Kind::answer, .site = SiteId{site}, .topic = topic, .digest = digest, .magnitude = magnitude};
}

struct Rig {
  Horizon horizon{SiteId{1}, ours};
  base::Random random{2};

  void hear(const Message& message, base::Instant now) { horizon.hear(message, now, random); }
};

TEST(Horizon, AsksAtOnceByRankAndByIriAndThenNowAndAgain) {
  Rig rig;
  EXPECT_TRUE(rig.horizon.want("Ball", 7, when(seconds(0))));
  const auto questions = rig.horizon.take_questions(when(seconds(0)), rig.random);
  ASSERT_EQ(questions.size(), 2U);
  EXPECT_EQ(questions[0].topic, iri("Ball"));
  EXPECT_EQ(questions[1].topic, rank(7));
  EXPECT_GE(rig.horizon.next_due(), when(ask_again * 4 / 5));
  EXPECT_LE(rig.horizon.next_due(), when(ask_again * 6 / 5));
  EXPECT_TRUE(rig.horizon.want("Ball", 7, when(seconds(1)))) << "it is there";
  EXPECT_TRUE(rig.horizon.take_questions(when(seconds(1)), rig.random).empty());
  rig.horizon.end("Ball");
  EXPECT_EQ(rig.horizon.next_due(), base::never);
}

TEST(Horizon, DoesNotAskWhatAnotherSiteHasJustAsked) {
  Rig rig;
  rig.horizon.want("Ball", 7, when(seconds(0)));
  (void)rig.horizon.take_questions(when(seconds(0)), rig.random);
  const Message question{.kind = Kind::question, .site = SiteId{2}, .topic = rank(7), .digest = ours};
  rig.hear(question, when(ask_again / 2));
  rig.hear({.kind = Kind::question, .site = SiteId{2}, .topic = iri("Ball"), .digest = 8}, when(ask_again / 2));
  const auto due = rig.horizon.take_questions(when(ask_again * 6 / 5), rig.random);
  ASSERT_EQ(due.size(), 1U) << "a question by IRI of another ontology is answered by sites that need not answer us";
  EXPECT_EQ(due.front().topic, iri("Ball"));
}

TEST(Horizon, KeepsAnswersToItsInterestsAndDropsAllOthers) {
  Rig rig;
  rig.horizon.want("Ball", 7, when(seconds(0)));
  rig.hear(answer(2, rank(7), 3), when(seconds(1)));
  rig.hear(answer(3, iri("Ball"), 5, 8), when(seconds(1)));
  rig.hear(answer(4, iri("Ball"), 9), when(seconds(1)));  // of our ontology: it says the rank to us
  rig.hear(answer(5, rank(8), 9), when(seconds(1)));      // not asked for
  rig.hear(answer(1, rank(7), 9), when(seconds(1)));      // our own
  EXPECT_EQ(rig.horizon.remembered(), 2U);
  const std::vector<Offerer> expected{{SiteId{3}, 5}, {SiteId{2}, 3}};
  EXPECT_EQ(rig.horizon.offerers("Ball", when(seconds(2))), expected);
  rig.hear(answer(3, iri("Ball"), 0, 8), when(seconds(3)));
  EXPECT_EQ(rig.horizon.offerers("Ball", when(seconds(4))).size(), 1U);
  EXPECT_TRUE(rig.horizon.offerers("Ball", when(seconds(1) + remembered_for)).empty()) << "too long ago";
  rig.horizon.end("Ball");
  EXPECT_EQ(rig.horizon.remembered(), 0U);
}

TEST(Horizon, NamesAsManySitesForAnExpansionAsAreEnough) {
  Rig rig;
  rig.horizon.want("Ball", 7, when(seconds(0)));
  for (std::uint64_t site = 2; site < 10; ++site) rig.hear(answer(site, rank(7), 2), when(seconds(1)));
  rig.hear(answer(20, rank(7), 4), when(seconds(1)));
  EXPECT_EQ(rig.horizon.enough("Ball", 1, when(seconds(2))), (std::vector<Offerer>{{SiteId{20}, 4}}));
  EXPECT_EQ(rig.horizon.enough("Ball", 12, when(seconds(2))).size(), 3U) << "8 and 2 and 2";
  EXPECT_EQ(rig.horizon.enough("Ball", 1000, when(seconds(2))).size(), 9U) << "all that there are";
  rig.horizon.forget(SiteId{20});
  EXPECT_EQ(rig.horizon.enough("Ball", 1, when(seconds(2))).front().site, SiteId{2});
}

TEST(Horizon, KeepsItsLimits) {
  Rig rig;
  for (std::size_t i = 0; i < max_interests; ++i)
    EXPECT_TRUE(rig.horizon.want(std::to_string(i), {}, when(seconds(0))));
  EXPECT_FALSE(rig.horizon.want("one more", {}, when(seconds(0))));
  for (std::uint64_t site = 2; site < max_remembered + 2; ++site) rig.hear(answer(site, iri("0"), 1), when(seconds(1)));
  EXPECT_EQ(rig.horizon.remembered(), max_remembered);
  EXPECT_EQ(rig.horizon.refused(), 0U);
  rig.hear(answer(max_remembered + 2, iri("0"), 1), when(seconds(2)));
  EXPECT_EQ(rig.horizon.refused(), 1U);
  rig.hear(answer(max_remembered + 2, iri("0"), 1), when(seconds(1) + remembered_for));
  EXPECT_EQ(rig.horizon.refused(), 1U) << "the others have run out";
  EXPECT_EQ(rig.horizon.remembered(), 1U);
}

}  // namespace
}  // namespace geminga::summary
