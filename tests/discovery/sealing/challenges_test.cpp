// The exchange about freshness: who is asked, who answers, and for how long.
#include "discovery/sealing/challenges.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "discovery/sealing/rig.hpp"

namespace geminga::sealing {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

constexpr base::Instant start{std::chrono::hours(1)};
constexpr Session own{0x0a00000000000001};
constexpr Challenge ours{0x1111};
constexpr std::size_t much = 1000;

Session other(std::uint64_t number) { return Session(number << 48 | 1); }

struct Talk {
  Talk() { challenges.begin(own, ours, start); }
  Greeting say(base::Instant now, std::size_t room = much, env::InterfaceIndex on = wlan) {
    return challenges.greeting(on, keys, room, now);
  }
  Challenges challenges;
  Keyring keys = policy(Mode::encrypted, {1}).keys;
};

constexpr base::Instant later = start + calling_time;

TEST(Challenges, CallEverybodyInTheFirstSecond) {
  Talk talk;
  EXPECT_TRUE(talk.say(start).calls_everybody);
  EXPECT_EQ(talk.say(later - milliseconds(1)).challenge, ours);
  EXPECT_TRUE(talk.say(later).is_empty());
}

TEST(Challenges, AreProvedByNothingButTheirEcho) {
  Talk talk;
  EXPECT_FALSE(talk.challenges.is_proof({}));
  EXPECT_FALSE(talk.challenges.is_proof({.challenge = ours}));
  EXPECT_FALSE(talk.challenges.is_proof({.echoes = {Challenge(5)}}));
  EXPECT_TRUE(talk.challenges.is_proof({.echoes = {Challenge(5), ours}}));
  talk.challenges.renew(Challenge(6));
  EXPECT_FALSE(talk.challenges.is_proof({.echoes = {ours}}));
}

TEST(Challenges, AskWhoHasProvedNothingUntilItIsSilentForASecondOrProved) {
  Talk talk;
  EXPECT_FALSE(talk.challenges.asks(later));
  talk.challenges.ask(other(7), wlan, later);
  EXPECT_TRUE(talk.challenges.asks(later));
  EXPECT_THAT(talk.say(later).asked, ElementsAre(SessionTag(7)));
  EXPECT_FALSE(talk.say(later).calls_everybody);
  EXPECT_TRUE(talk.say(later, much, lan).is_empty()) << "it was heard on another interface";
  EXPECT_TRUE(talk.challenges.asks(later + asking_time - milliseconds(1)));
  EXPECT_FALSE(talk.challenges.asks(later + asking_time));
  talk.challenges.ask(other(7), wlan, later);
  talk.challenges.settle(other(7));
  EXPECT_FALSE(talk.challenges.asks(later));
}

TEST(Challenges, NameSixteenAndCallEverybodyForOneMore) {
  for (const std::size_t count : {max_asked - 1, max_asked, max_asked + 1}) {
    Talk talk;
    for (std::size_t i = 1; i <= count; ++i) talk.challenges.ask(other(i), wlan, later);
    const Greeting greeting = talk.say(later);
    EXPECT_EQ(greeting.calls_everybody, count > max_asked);
    EXPECT_THAT(greeting.asked, SizeIs(std::min(count, max_asked)));
    EXPECT_TRUE(talk.say(later + asking_time).is_empty());
  }
}

TEST(Challenges, AreGivenBackThreeTimesWhereTheyWereHeard) {
  Talk talk;
  talk.challenges.hear({.challenge = Challenge(5), .asked = {tag_of(own)}}, other(1), wlan, later);
  EXPECT_TRUE(talk.challenges.is_asked(later));
  EXPECT_THAT(talk.say(later, much, lan).echoes, IsEmpty());
  EXPECT_TRUE(talk.challenges.is_asked(later));
  for (int i = 0; i < echo_copies; ++i) {
    EXPECT_THAT(talk.say(later).echoes, ElementsAre(Challenge(5)));
    EXPECT_FALSE(talk.challenges.is_asked(later));
  }
  EXPECT_THAT(talk.say(later).echoes, IsEmpty());
}

TEST(Challenges, AreGivenBackEachTimeToWhoNamesUsAndOnceASecondToWhoCallsEverybody) {
  Talk talk;
  const auto count = [&](const Greeting& heard, base::Instant now) {
    talk.challenges.hear(heard, other(1), wlan, now);
    std::size_t echoes = 0;
    while (!talk.say(now).echoes.empty()) ++echoes;
    return echoes;
  };
  const Greeting call{.calls_everybody = true, .challenge = Challenge(5)};
  EXPECT_EQ(count(call, later), 3U);
  EXPECT_EQ(count(call, later + call_spacing - milliseconds(1)), 0U);
  EXPECT_EQ(count({.calls_everybody = true, .challenge = Challenge(6)}, later + milliseconds(999)), 3U)
      << "another one";
  EXPECT_EQ(count({.challenge = Challenge(6), .asked = {tag_of(own)}}, later + milliseconds(999)), 3U);
  EXPECT_EQ(count(call, later + seconds(5)), 3U);
}

TEST(Challenges, OfOthersAreNoneOfOurBusiness) {
  Talk talk;
  talk.challenges.hear({.challenge = Challenge(5), .asked = {SessionTag(99)}}, other(1), wlan, later);
  EXPECT_FALSE(talk.challenges.is_asked(later));
  EXPECT_TRUE(talk.say(later).is_empty());
}

TEST(Challenges, OfTheLastWhoAskedGoFirstWhereTheyAreTooMany) {
  Talk talk;
  for (std::uint64_t i = 1; i <= max_waiting_echoes + 1; ++i) {
    talk.challenges.hear({.calls_everybody = true, .challenge = Challenge(i)}, other(i), wlan, later);
  }
  EXPECT_EQ(talk.say(later).echoes.front(), Challenge(max_waiting_echoes + 1));
  EXPECT_THAT(talk.say(later).echoes, SizeIs(max_echoes));
  std::set<Challenge> all;
  for (Greeting greeting = talk.say(later); !greeting.is_empty(); greeting = talk.say(later)) {
    all.insert(greeting.echoes.begin(), greeting.echoes.end());
  }
  EXPECT_FALSE(all.contains(Challenge(1))) << "the first one had to go";
  EXPECT_TRUE(all.contains(Challenge(2)));
}

TEST(Challenges, TakeNoMoreRoomThanThereIs) {
  for (std::size_t room = 0; room < 200; ++room) {
    Talk talk;
    talk.keys = policy(Mode::encrypted, {1, 2, 3}).keys;
    for (std::uint64_t i = 1; i <= 5; ++i) {
      talk.challenges.ask(other(i), wlan, later);
      talk.challenges.hear({.calls_everybody = true, .challenge = Challenge(i)}, other(i), wlan, later);
    }
    const Greeting greeting = talk.say(later, room);
    if (greeting.is_empty()) continue;
    Octets octets(max_greeting_bytes);
    EXPECT_LE(write_greeting(greeting, octets), room);
  }
}

TEST(Challenges, GoWithTheKeysOfWhoHasSeveral) {
  Talk talk;
  talk.keys = policy(Mode::encrypted, {1, 2}).keys;
  EXPECT_THAT(talk.say(later).keys, ElementsAre(key_of(1).id(), key_of(2).id()));
}

TEST(Challenges, KnowWhoWasHeardOnOneInterfaceAlone) {
  Talk talk;
  EXPECT_FALSE(talk.challenges.asks_only_on(lan, wlan, later));
  talk.challenges.ask(other(7), lan, later);
  EXPECT_TRUE(talk.challenges.asks_only_on(lan, wlan, later));
  EXPECT_FALSE(talk.challenges.asks_only_on(wlan, lan, later));
  talk.challenges.ask(other(7), wlan, later);
  EXPECT_FALSE(talk.challenges.asks_only_on(lan, wlan, later));
  talk.challenges.ask(other(8), lan, later);
  EXPECT_TRUE(talk.challenges.asks_only_on(lan, wlan, later));
  EXPECT_FALSE(talk.challenges.asks_only_on(lan, wlan, later + asking_time));
}

TEST(Challenges, OweNothingWhereNothingIsSaid) {
  Talk talk;
  const Greeting asking{.calls_everybody = true, .challenge = Challenge(5)};
  talk.challenges.hear(asking, other(7), lan, later);
  talk.challenges.forget_owed(wlan);
  EXPECT_TRUE(talk.challenges.is_asked(later));
  talk.challenges.forget_owed(lan);
  EXPECT_FALSE(talk.challenges.is_asked(later));
  EXPECT_TRUE(talk.say(later, much, lan).is_empty());
}

}  // namespace
}  // namespace geminga::sealing
