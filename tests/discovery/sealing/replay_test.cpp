// Recordings and forgeries against a seal, and floods of them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

#include "discovery/sealing/rig.hpp"

namespace geminga::sealing {
namespace {

using std::chrono::hours;
using std::chrono::milliseconds;
using std::chrono::seconds;
using testing::AnyOf;

const Policy sealed = policy(Mode::encrypted, {1});

struct Pair : testing::Test {
  Pair() { introduce(one, other); }
  Member one{1, sealed};
  Member other{2, sealed};
};

using SealOfTwo = Pair;

TEST(Seal, HearsANewcomerWithItsSecondDatagram) {
  Member known(1, sealed);
  known.pass(hours(1));
  Member newcomer(2, sealed);
  EXPECT_EQ(known.hear(newcomer.say("claim")), "unproved");
  EXPECT_TRUE(known.seal.asks(known.now));
  EXPECT_TRUE(known.seal.is_asked(known.now));
  EXPECT_EQ(newcomer.hear(known.say("presence")), "presence") << "it gives the challenge of the claim back";
  EXPECT_EQ(known.hear(newcomer.say("claim")), "claim") << "it gives the challenge of the presence back";
  EXPECT_FALSE(known.seal.asks(known.now));
}

TEST(Seal, OfThirtyThatStartTogetherIsProvedAfterOneRound) {
  std::vector<std::unique_ptr<Member>> team;
  for (int i = 1; i <= 30; ++i) team.push_back(std::make_unique<Member>(i, sealed));
  const auto round = [&] {
    std::size_t heard = 0;
    std::vector<Octets> said;
    for (const auto& member : team) said.push_back(member->say("claim"));
    for (std::size_t to = 0; to < team.size(); ++to) {
      for (std::size_t from = 0; from < team.size(); ++from) {
        if (from != to && team[to]->hear(said[from]) == "claim") ++heard;
      }
    }
    return heard;
  };
  EXPECT_EQ(round(), 0U);
  EXPECT_EQ(round(), 30U * 29U);
}

TEST_F(SealOfTwo, HearsNoDatagramTwice) {
  const Octets datagram = one.say("state");
  EXPECT_EQ(other.hear(datagram), "state");
  EXPECT_EQ(other.hear(datagram), "replayed");
  EXPECT_EQ(other.hear(datagram, wlan, "10.0.0.66"), "replayed") << "from another address";
  EXPECT_EQ(other.hear(datagram, lan), "state") << "another interface of ours on the same link";
  other.pass(seconds(1));
  EXPECT_EQ(other.hear(datagram, env::InterfaceIndex(9)), "replayed") << "and not later";
}

TEST_F(SealOfTwo, CountsACopyThatIsSaidAloneBesideAMulticastAsNoReplay) {
  const Octets datagram = one.say("state");
  EXPECT_EQ(other.hear(datagram), "state");
  Arrival alone = other.arrival();
  alone.is_alone = true;
  EXPECT_EQ(other.seal.open(bent(datagram, 40), alone).error(), Rejection::forged);
  EXPECT_EQ(other.seal.open(datagram, alone).error(), Rejection::copied);
  EXPECT_EQ(other.seal.ledger().rejected(Rejection::copied), 0U);
  EXPECT_EQ(other.seal.ledger().rejected(Rejection::replayed), 0U);
  EXPECT_EQ(other.seal.open(datagram, alone).error(), Rejection::replayed) << "the second one";
  EXPECT_EQ(other.seal.ledger().rejected(Rejection::replayed), 1U);
}

TEST_F(SealOfTwo, HearsNothingThatWasKeptBack) {
  const Octets kept = one.say("old");
  EXPECT_EQ(other.hear(one.say("new")), "new");
  other.pass(overtaken_time);
  EXPECT_EQ(other.hear(kept), "replayed");
}

TEST_F(SealOfTwo, HearsNothingOfARecordedSession) {
  Member yesterday(3, sealed);
  introduce(yesterday, other);
  std::vector<Octets> recording;
  for (int i = 0; i < 200; ++i) recording.push_back(yesterday.say("x"));
  Member fresh(4, sealed);
  fresh.pass(hours(24));
  for (const Octets& datagram : recording) {
    EXPECT_EQ(fresh.hear(datagram), "unproved");
    (void)fresh.say("presence");
  }
  for (const Octets& datagram : recording) (void)other.hear(datagram);
  for (const Octets& datagram : recording) EXPECT_EQ(other.hear(datagram), "replayed");
}

TEST(Seal, HearsNothingOfARecordingOfTheWholeTeamThatWasTogetherYesterday) {
  Member one(1, sealed);
  Member other(2, sealed);
  std::vector<Octets> recording;
  for (int i = 0; i < 20; ++i) {
    recording.push_back(one.say("x"));
    (void)other.hear(recording.back());
    recording.push_back(other.say("y"));
    (void)one.hear(recording.back());
  }
  Member today(3, sealed);
  for (const Octets& datagram : recording) {
    EXPECT_EQ(today.hear(datagram), "unproved");
    (void)today.say("z");
  }
}

TEST(Seal, HearsNothingOfASessionThatItHadToForget) {
  Member host(1, sealed);
  Member victim(2, sealed);
  introduce(victim, host);
  std::vector<Octets> recording;
  for (int i = 0; i < 3; ++i) recording.push_back(victim.say("x"));
  for (const Octets& datagram : recording) EXPECT_EQ(host.hear(datagram), "x");
  for (std::size_t i = 0; i < max_sessions; ++i) {
    host.pass(milliseconds(1));
    Member member(static_cast<int>(i) + 10, sealed, host.now);
    introduce(member, host);
  }
  for (const Octets& datagram : recording) EXPECT_EQ(host.hear(datagram), "unproved");
  introduce(host, victim);
  EXPECT_EQ(host.hear(victim.say("y")), "y") << "who lives proves itself again";
  for (const Octets& datagram : recording) EXPECT_EQ(host.hear(datagram), "replayed");
}

TEST_F(SealOfTwo, HearsNothingForged) {
  const Octets datagram = one.say("state");
  for (std::size_t at = 0; at < datagram.size(); ++at) {
    EXPECT_THAT(other.hear(bent(datagram, at)), AnyOf("forged", "other-version", "plain", "unknown-key", "replayed"));
  }
  EXPECT_EQ(other.hear(datagram), "state") << "no forgery has moved its window";
}

TEST_F(SealOfTwo, GivesAForgerNoPlaceAndNoAnswer) {
  Octets datagram = one.say("state");
  for (std::uint8_t i = 1; i < 100; ++i) {
    EXPECT_EQ(other.hear(bent(datagram, 4, i)), "forged") << "another session";
  }
  EXPECT_FALSE(other.seal.asks(other.now));
  EXPECT_FALSE(other.seal.is_asked(other.now));
}

TEST_F(SealOfTwo, HearsItsOwnEchoForNothing) {
  const Octets datagram = one.say("state");
  EXPECT_EQ(one.hear(datagram), "own");
  for (std::size_t i = 0; i < rejection_count; ++i) EXPECT_EQ(one.seal.ledger().rejected(Rejection(i)), 0U);
}

TEST(Seal, BeginsAnotherSessionWhenACopyOfItsProcessGoesOnWithTheSame) {
  Member one(1, sealed);
  Member copy(1, sealed);
  (void)one.say("a");
  const Octets first = one.say("b");
  EXPECT_EQ(copy.hear(first), "own");
  const Octets own = copy.say("c");
  EXPECT_NE(read_header(own)->session, read_header(first)->session);
}

TEST(Seal, TakesTextsUpToTheirLimitAndDatagramsUpToTheirs) {
  Member one(1, sealed);
  Member other(2, sealed);
  introduce(one, other);
  for (const std::size_t size : {std::size_t{1199}, std::size_t{1200}}) {
    const Octets datagram = one.say(noise(size));
    EXPECT_LE(datagram.size(), env::max_datagram_bytes);
    EXPECT_EQ(other.hear(datagram), noise(size));
  }
  Octets datagram = one.say(noise(1200));
  EXPECT_EQ(datagram.size(), env::max_datagram_bytes);
  datagram.push_back(std::byte{0});
  EXPECT_EQ(other.hear(datagram), "too-large");
  EXPECT_EQ(other.hear(octets_of("G")), "too-short");
  EXPECT_EQ(other.hear({}), "plain");
}

TEST(Seal, RefusesAnyOctetsWithoutHarm) {
  Member one(1, sealed);
  base::Random random(99);
  for (int i = 0; i < 20000; ++i) {
    Octets datagram(random.below(1300));
    for (std::byte& octet : datagram) octet = static_cast<std::byte>(random.next());
    if (random.chance(0.5) && datagram.size() > 4) {
      datagram[0] = std::byte{0x47};
      datagram[1] = std::byte{0x11};
      datagram[2] = static_cast<std::byte>(static_cast<std::uint16_t>(key_of(1).id()) >> 8);
      datagram[3] = static_cast<std::byte>(static_cast<std::uint16_t>(key_of(1).id()));
    }
    ASSERT_NE(one.hear(datagram).size(), 0U);
  }
  EXPECT_FALSE(one.seal.asks(one.now));
}

}  // namespace
}  // namespace geminga::sealing
