// Teams whose hosts differ in keys or mode, and the ways to one mode.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "discovery/sealing/rig.hpp"

namespace geminga::sealing {
namespace {

using std::chrono::seconds;
using testing::ElementsAre;

constexpr ParticipantId robot{0x1a2b3c4d};

/// Whether both hear each other, once each had the chance to prove itself.
bool are_together(Member& one, Member& other) {
  introduce(one, other);
  return other.hear(one.say("x")) == "x" && one.hear(other.say("y")) == "y";
}

TEST(Policy, WithoutKeysSaysAndHearsWhatIsNotSealed) {
  Member one(1, {});
  Member other(2, {});
  EXPECT_EQ(text_of(one.say("state")), "state");
  EXPECT_EQ(other.hear(one.say("state")), "state");
  Member sealer(3, policy(Mode::encrypted, {1}));
  EXPECT_EQ(other.hear(sealer.say("state")), "unknown-key");
  EXPECT_EQ(sealer.hear(one.say("state")), "plain");
}

TEST(Policy, OfTheSameKeyLetsBothModesHearEachOther) {
  Member one(1, policy(Mode::encrypted, {1}));
  Member other(2, policy(Mode::authenticated, {1}));
  EXPECT_TRUE(are_together(one, other));
}

TEST(Policy, OfAnotherKeyHearsNothing) {
  Member one(1, policy(Mode::encrypted, {1}));
  Member other(2, policy(Mode::encrypted, {2}));
  EXPECT_FALSE(are_together(one, other));
  EXPECT_EQ(one.hear(other.say("x")), "unknown-key");
}

TEST(Policy, GoesFromPlainToEncryptedHostByHostAndNobodyIsLost) {
  // Each step begins when all hosts have made the one before. Within a step the hosts are in any order.
  const std::vector<Policy> steps{
      {}, policy(Mode::prepared, {1}), policy(Mode::mixed, {1}), policy(Mode::encrypted, {1})};
  for (std::size_t step = 0; step + 1 < steps.size(); ++step) {
    Member one(1, steps[step]);
    Member other(2, steps[step]);
    EXPECT_TRUE(are_together(one, other)) << step;
    one.seal.adopt(steps[step + 1], one.now);
    EXPECT_TRUE(are_together(one, other)) << step << " and the next";
    other.seal.adopt(steps[step + 1], other.now);
    EXPECT_TRUE(are_together(one, other)) << step + 1;
  }
}

TEST(Policy, RotatesAKeyHostByHostAndNobodyIsLost) {
  const std::vector<Policy> steps{policy(Mode::encrypted, {1}), policy(Mode::encrypted, {1, 2}),
                                  policy(Mode::encrypted, {2, 1}), policy(Mode::encrypted, {2})};
  Member one(1, steps[0]);
  Member other(2, steps[0]);
  EXPECT_TRUE(are_together(one, other));
  for (std::size_t step = 1; step < steps.size(); ++step) {
    one.seal.adopt(steps[step], one.now);
    EXPECT_TRUE(are_together(one, other)) << step;
    other.seal.adopt(steps[step], other.now);
    EXPECT_TRUE(are_together(one, other)) << step;
  }
  Member late(3, steps[0]);
  EXPECT_FALSE(are_together(one, late)) << "it has slept through the rotation";
}

TEST(Policy, KeepsProvedSessionsWhenAKeyIsAddedOrAnotherOneSeals) {
  Member one(1, policy(Mode::encrypted, {1}));
  Member other(2, policy(Mode::encrypted, {1}));
  introduce(one, other);
  for (const Policy& next : {policy(Mode::encrypted, {1, 2}), policy(Mode::encrypted, {2, 1})}) {
    one.seal.adopt(next, one.now);
    other.seal.adopt(next, other.now);
    EXPECT_EQ(other.hear(one.say("x")), "x");
  }
}

TEST(Policy, WithoutAKeyOfBeforeWantsProofsAnew) {
  Member one(1, policy(Mode::encrypted, {2, 1}));
  Member other(2, policy(Mode::encrypted, {2, 1}));
  introduce(one, other);
  other.seal.adopt(policy(Mode::encrypted, {2}), other.now);
  EXPECT_EQ(other.hear(one.say("x")), "unproved") << "who has the old key may have moved its window";
  EXPECT_TRUE(are_together(one, other));
}

TEST(Policy, ShowsWhoOpensWithWhichKeys) {
  Member one(1, policy(Mode::encrypted, {1, 2}));
  Member other(2, policy(Mode::encrypted, {1}));
  introduce(one, other);
  const Octets datagram = one.say("x");
  const auto opened = other.seal.open(datagram, other.arrival());
  ASSERT_TRUE(opened);
  EXPECT_FALSE(other.seal.sealing_of(robot));
  EXPECT_TRUE(other.seal.attribute(*opened, robot, other.arrival()));
  EXPECT_THAT(other.seal.sealing_of(robot)->keys, ElementsAre(key_of(1).id(), key_of(2).id()));
  EXPECT_EQ(other.seal.sealing_of(robot)->key, key_of(1).id());
  EXPECT_EQ(other.seal.sealing_of(robot)->protection, Protection::encrypted);
  (void)other.hear(one.say(noise(1200)));
  EXPECT_THAT(other.seal.sealing_of(robot)->keys, ElementsAre(key_of(1).id(), key_of(2).id()))
      << "there was no room to say them";
  one.seal.adopt(policy(Mode::encrypted, {1}), one.now);
  (void)other.hear(one.say("x"));
  EXPECT_THAT(other.seal.sealing_of(robot)->keys, ElementsAre(key_of(1).id()));
}

TEST(Policy, ThatIsMixedHearsNothingPlainInTheNameOfWhoSeals) {
  Member one(1, policy(Mode::mixed, {1}));
  Member other(2, policy(Mode::mixed, {1}));
  introduce(one, other);
  const Octets datagram = one.say("x");
  const auto opened = other.seal.open(datagram, other.arrival());
  ASSERT_TRUE(opened);
  ASSERT_TRUE(other.seal.attribute(*opened, robot, other.arrival()));
  const Octets forged = octets_of("x");
  const auto plain = other.seal.open(forged, other.arrival());
  ASSERT_TRUE(plain);
  EXPECT_FALSE(other.seal.attribute(*plain, robot, other.arrival()));
  EXPECT_TRUE(other.seal.attribute(*plain, ParticipantId(7), other.arrival())) << "who does not seal yet";
  other.pass(sealed_memory - seconds(1));
  EXPECT_FALSE(other.seal.attribute(*plain, robot, other.arrival()));
  other.pass(seconds(1));
  EXPECT_TRUE(other.seal.attribute(*plain, robot, other.arrival())) << "it has gone back to plain";
  EXPECT_EQ(other.seal.ledger().rejected(Rejection::downgraded), 2U);
}

TEST(Policy, HasAWordForEachMode) {
  for (const Mode mode : {Mode::plain, Mode::prepared, Mode::mixed, Mode::authenticated, Mode::encrypted}) {
    EXPECT_EQ(read_mode(to_string(mode)), mode);
  }
  EXPECT_EQ(read_mode("secret"), std::nullopt);
}

}  // namespace
}  // namespace geminga::sealing
