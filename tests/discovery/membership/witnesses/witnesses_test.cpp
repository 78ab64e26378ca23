// The testimony of others about the participants that they have heard.
#include "discovery/membership/witnesses/witnesses.hpp"

#include <gmock/gmock.h>

#include "discovery/membership/schedule/deadline.hpp"

namespace geminga::membership {
namespace {

using announcement::BootNonce;
using announcement::HeardWithin;

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr base::Instant now{seconds(1000)};

/// A robot that knows all others of a team 1 to `count`, and heard all at `heard`.
Witnesses member_of(std::uint32_t count, std::uint32_t self, base::Instant heard) {
  Witnesses witnesses;
  witnesses.set_self(ParticipantId{self}, BootNonce{self});
  for (std::uint32_t id = count; id > 0; --id) {
    if (id == self) continue;
    witnesses.add(ParticipantId{id}, BootNonce{id});
    witnesses.update(ParticipantId{id}, heard, seconds(2));
  }
  return witnesses;
}

announcement::Announcement presence_of(std::uint32_t id, const Witnesses& witnesses) {
  announcement::Announcement presence;
  presence.participant = ParticipantId{id};
  presence.witness = witnesses.say(now);
  return presence;
}

TEST(Witnesses, GiveEachWordItsPlaceWhoeverSpeaks) {
  for (const std::uint32_t self : {1U, 2U, 5U}) {
    for (const std::uint32_t other : {1U, 3U, 5U}) {
      if (self == other) continue;
      auto ours = member_of(5, self, now - seconds(5));
      auto theirs = member_of(5, other, now - milliseconds(100));
      theirs.update(ParticipantId{self == 4 ? 2U : 4U}, now - seconds(9), seconds(2));
      ASSERT_TRUE(ours.hear(presence_of(other, theirs), now));
      for (std::uint32_t id = 1; id <= 5; ++id) {
        if (id == self) continue;
        const bool is_heard = id != other && id != 4;
        EXPECT_EQ(ours.seen(ParticipantId{id}), is_heard ? now - milliseconds(500) : base::Instant{})
            << self << " hears " << other << " of " << id;
      }
    }
  }
}

TEST(Witnesses, AreQuotedByNameUntilSomebodyComesOrGoes) {
  auto ours = member_of(5, 3, now);
  auto theirs = member_of(5, 2, now - milliseconds(700));
  theirs.update(ParticipantId{4}, now - seconds(9), seconds(2));
  EXPECT_FALSE(ours.last_word(ParticipantId{2}));
  EXPECT_FALSE(ours.last_word(ParticipantId{9})) << "not known";
  ASSERT_TRUE(ours.hear(presence_of(2, theirs), now));
  const auto word = ours.last_word(ParticipantId{2});
  ASSERT_TRUE(word);
  EXPECT_EQ(word->said, now);
  using testing::Pair;
  EXPECT_THAT(word->heard, testing::ElementsAre(
                               Pair(ParticipantId{1}, HeardWithin::half), Pair(ParticipantId{3}, HeardWithin::half),
                               Pair(ParticipantId{4}, HeardWithin::longer), Pair(ParticipantId{5}, HeardWithin::half)));
  EXPECT_FALSE(ours.last_word(ParticipantId{4})) << "it has said nothing";
  ours.add(ParticipantId{6}, BootNonce{6});
  EXPECT_FALSE(ours.last_word(ParticipantId{2})) << "its words have other places now";
}

TEST(Witnesses, SayNothingToWhoKnowsOthers) {
  auto ours = member_of(5, 1, now);
  EXPECT_FALSE(ours.hear(presence_of(2, member_of(6, 2, now)), now));
  ours.remove(ParticipantId{5});
  EXPECT_FALSE(ours.hear(presence_of(2, member_of(5, 2, now)), now));
  EXPECT_TRUE(ours.hear(presence_of(2, member_of(4, 2, now)), now));
}

TEST(Witnesses, CountOnlyWhoElseHasSpokenOfLate) {
  auto ours = member_of(6, 1, now);
  for (const std::uint32_t other : {2U, 3U, 3U}) (void)ours.hear(presence_of(other, member_of(6, other, now)), now);
  EXPECT_EQ(ours.words(ParticipantId{2}, now, seconds(2)), 2U);
  EXPECT_EQ(ours.words(ParticipantId{3}, now, seconds(2)), 1U);
  EXPECT_EQ(ours.words(ParticipantId{4}, now, seconds(2)), enough_witnesses);
  EXPECT_EQ(ours.words(ParticipantId{4}, now + seconds(3), seconds(2)), enough_witnesses) << "the interval before";
  EXPECT_EQ(ours.words(ParticipantId{4}, now + seconds(5), seconds(2)), 0U);
}

TEST(Witnesses, DifferNewlyForTwoIntervalsAndAgainWhenSomethingChanges) {
  auto ours = member_of(4, 1, now);
  auto presence = presence_of(2, member_of(4, 2, now));
  EXPECT_EQ(ours.compare(presence, now).unknown, Unknown::nobody) << "they know the same";
  ++presence.witness.members;
  EXPECT_NE(ours.compare(presence, now + seconds(1)).unknown, Unknown::nobody);
  EXPECT_NE(ours.compare(presence, now + seconds(4)).unknown, Unknown::nobody);
  EXPECT_EQ(ours.compare(presence, now + seconds(5)).unknown, Unknown::nobody) << "they may never hear each other";
  ours.remove(ParticipantId{4});
  EXPECT_NE(ours.compare(presence, now + seconds(6)).unknown, Unknown::nobody);
  EXPECT_EQ(ours.compare(presence, now + seconds(11)).unknown, Unknown::nobody);
  ++presence.witness.members;
  EXPECT_NE(ours.compare(presence, now + seconds(12)).unknown, Unknown::nobody);
  presence.participant = ParticipantId{4};
  EXPECT_EQ(ours.compare(presence, now + seconds(12)).unknown, Unknown::nobody) << "unknown";
}

TEST(Witnesses, TellWhomSomebodyDoesNotKnowWhereOneOrTwoAreMissing) {
  const auto unknown_to_two = [](std::vector<std::uint32_t> missing, std::uint32_t count = 9) {
    auto ours = member_of(count, 1, now);
    auto theirs = member_of(count, 2, now);
    for (const std::uint32_t id : missing) theirs.remove(ParticipantId{id});
    const auto unknown = ours.compare(presence_of(2, theirs), now).unknown;
    EXPECT_EQ(ours.is_unlike(now), unknown == Unknown::unclear);
    return unknown;
  };
  EXPECT_EQ(unknown_to_two({}), Unknown::nobody);
  EXPECT_EQ(unknown_to_two({1}), Unknown::us);
  EXPECT_EQ(unknown_to_two({5, 1}), Unknown::us);
  EXPECT_EQ(unknown_to_two({5}), Unknown::others);
  EXPECT_EQ(unknown_to_two({5, 7}), Unknown::others);
  EXPECT_EQ(unknown_to_two({5, 7, 8}), Unknown::unclear);
  EXPECT_EQ(unknown_to_two({1, 7, 8}), Unknown::unclear);
  const auto most = static_cast<std::uint32_t>(max_told_apart + 1);
  EXPECT_EQ(unknown_to_two({5, 7}, most), Unknown::others);
  EXPECT_EQ(unknown_to_two({5, 7}, most + 1), Unknown::unclear);
  EXPECT_EQ(unknown_to_two({1}, most + 1), Unknown::us);
}

TEST(Witnesses, AreUnlikeUntilOursOrTheLastWordOfAnotherIsOfTheSame) {
  auto ours = member_of(8, 1, now);
  const auto theirs = member_of(9, 2, now);
  EXPECT_EQ(ours.compare(presence_of(2, theirs), now).unknown, Unknown::unclear) << "it knows one whom we do not";
  EXPECT_TRUE(ours.is_unlike(now));
  EXPECT_FALSE(ours.is_unlike(now + seconds(4))) << "some never hear each other";
  EXPECT_EQ(ours.compare(presence_of(3, member_of(8, 3, now)), now).unknown, Unknown::nobody);
  EXPECT_FALSE(ours.is_unlike(now));
  (void)ours.compare(presence_of(2, theirs), now);
  EXPECT_TRUE(ours.is_unlike(now));
  ours.add(ParticipantId{9}, BootNonce{9});
  EXPECT_FALSE(ours.is_unlike(now));
}

TEST(Witnesses, TellWhoMayNotHaveHeardWhatWeChanged) {
  auto ours = member_of(4, 1, now);
  const auto changed = now - milliseconds(100);
  const auto misses = [&](base::Instant heard, base::Instant at) {
    auto theirs = member_of(4, 2, heard);
    announcement::Announcement presence;
    presence.participant = ParticipantId{2};
    presence.witness = theirs.say(at);
    return ours.misses_us(presence, changed, seconds(2), at);
  };
  EXPECT_TRUE(misses(now - seconds(5), now)) << "not for an interval";
  EXPECT_FALSE(misses(now - milliseconds(200), now)) << "of late, but perhaps before that";
  EXPECT_TRUE(misses(now - milliseconds(200), now + seconds(3)));
  EXPECT_FALSE(misses(now + seconds(4), now + seconds(5))) << "after that";
  EXPECT_FALSE(misses(now + seconds(4), now + seconds(9))) << "it knew, and has only missed a presence since then";
  auto stranger = presence_of(3, member_of(5, 3, now - seconds(5)));
  EXPECT_FALSE(ours.misses_us(stranger, changed, seconds(2), now)) << "it knows others, so places have no meaning";
}

TEST(Witnesses, DoNotTestifyByWhatMayHaveBeenSaidWhileTheySlept) {
  auto ours = member_of(3, 1, now);
  ours.distrust_until(now);
  EXPECT_THAT(ours.say(now).heard, testing::Each(HeardWithin::longer));
  EXPECT_FALSE(ours.has_heard(ParticipantId{2}, now));
  ours.update(ParticipantId{2}, now + milliseconds(1), seconds(2));
  EXPECT_THAT(ours.say(now + milliseconds(1)).heard,
              testing::ElementsAre(HeardWithin::longer, HeardWithin::quarter, HeardWithin::longer));
  EXPECT_TRUE(ours.has_heard(ParticipantId{2}, now + milliseconds(1)));
  EXPECT_FALSE(ours.has_heard(ParticipantId{9}, now)) << "unknown";
}

TEST(Witnesses, TakeNothingBack) {
  auto ours = member_of(4, 1, now);
  (void)ours.hear(presence_of(2, member_of(4, 2, now - milliseconds(100))), now);
  (void)ours.hear(presence_of(2, member_of(4, 2, now - seconds(5))), now + seconds(1));
  EXPECT_EQ(ours.seen(ParticipantId{3}), now - milliseconds(500));
}

/// The result of `ours` when a robot says in each interval from `begin` on that it heard us that long ago.
void say_of_us(Witnesses& ours, Witnesses& theirs, base::Instant begin, base::Instant end, base::Duration age) {
  for (base::Instant at = begin; at <= end; at += seconds(2)) {
    theirs.update(ParticipantId{1}, at - age, seconds(2));
    announcement::Announcement presence;
    presence.participant = ParticipantId{2};
    presence.witness = theirs.say(at);
    (void)ours.hear(presence, at);
  }
}

TEST(Witnesses, KnowWhoIsDeafToUsAfterFourIntervals) {
  auto ours = member_of(3, 1, now);
  auto theirs = member_of(3, 2, now);
  say_of_us(ours, theirs, now, now + seconds(20), milliseconds(100));
  EXPECT_FALSE(ours.is_deaf_to_us(ParticipantId{2}));
  say_of_us(ours, theirs, now + seconds(22), now + seconds(28), seconds(5));
  EXPECT_FALSE(ours.is_deaf_to_us(ParticipantId{2})) << "three intervals may be loss";
  say_of_us(ours, theirs, now + seconds(30), now + seconds(30), seconds(5));
  EXPECT_TRUE(ours.is_deaf_to_us(ParticipantId{2}));
  EXPECT_FALSE(ours.is_deaf_to_us(ParticipantId{3})) << "it has said nothing";
  EXPECT_FALSE(ours.is_deaf_to_us(ParticipantId{9}));
  say_of_us(ours, theirs, now + seconds(32), now + seconds(44), seconds(5));
  EXPECT_FALSE(ours.is_surely_deaf_to_us(ParticipantId{2})) << "people are told after twelve";
  say_of_us(ours, theirs, now + seconds(46), now + seconds(46), seconds(5));
  EXPECT_TRUE(ours.is_surely_deaf_to_us(ParticipantId{2}));
  say_of_us(ours, theirs, now + seconds(48), now + seconds(48), milliseconds(100));
  EXPECT_FALSE(ours.is_deaf_to_us(ParticipantId{2})) << "one word is enough to be heard again";
  EXPECT_FALSE(ours.is_surely_deaf_to_us(ParticipantId{2}));
}

TEST(Witnesses, KnowWhoIsDeafToUsThoughItDoesNotKnowUs) {
  auto ours = member_of(3, 1, now);
  Witnesses theirs;
  theirs.set_self(ParticipantId{2}, BootNonce{2});
  theirs.add(ParticipantId{3}, BootNonce{3});
  for (int i = 0; i <= 4; ++i) {
    EXPECT_FALSE(ours.is_deaf_to_us(ParticipantId{2}));
    EXPECT_FALSE(ours.hear(presence_of(2, theirs), now + i * seconds(2)));
  }
  EXPECT_TRUE(ours.is_deaf_to_us(ParticipantId{2}));
  theirs.add(ParticipantId{4}, BootNonce{4});
  EXPECT_FALSE(ours.hear(presence_of(2, theirs), now + seconds(10)));
  EXPECT_FALSE(ours.is_deaf_to_us(ParticipantId{2})) << "who knows others says nothing of us";
}

TEST(Witnesses, KnowWhoIsDeafToUsSinceItKnowsNobody) {
  auto ours = member_of(5, 1, now);
  Witnesses theirs;
  theirs.set_self(ParticipantId{2}, BootNonce{2});
  for (int i = 0; i <= 4; ++i) (void)ours.hear(presence_of(2, theirs), now + i * seconds(2));
  EXPECT_TRUE(ours.is_deaf_to_us(ParticipantId{2}));
}

}  // namespace
}  // namespace geminga::membership
