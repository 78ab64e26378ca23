// Timelines of the identifier claim.
#include "discovery/membership/claim/identifier_claim.hpp"

#include <gmock/gmock.h>

#include <set>
#include <vector>

namespace geminga::membership {
namespace {

using base::Duration;
using base::Instant;
using std::chrono::milliseconds;
using std::chrono::seconds;
using Step = IdentifierClaim::Step;
using Verdict = IdentifierClaim::Verdict;

constexpr Instant start{seconds(100)};

/// Runs until the claim has nothing to do; appends the instants of its claims.
Instant settle(IdentifierClaim& claim, Step expected, std::vector<Instant>* claims = nullptr) {
  while (true) {
    const auto now = claim.due();
    EXPECT_NE(now, base::never);
    if (now == base::never) return now;
    const auto step = claim.step(now);
    if (step == Step::send_claim) {
      if (claims != nullptr) claims->push_back(now);
      continue;
    }
    EXPECT_EQ(step, expected);
    return now;
  }
}

IdentifierClaim held(std::uint64_t seed = 1) {
  IdentifierClaim claim(seed);
  claim.start(start);
  settle(claim, Step::claimed);
  return claim;
}

TEST(IdentifierClaim, HoldsItsIdentifierNinetyMillisecondsAfterItsStart) {
  IdentifierClaim claim(1);
  EXPECT_EQ(claim.due(), base::never);
  EXPECT_EQ(claim.id(), ParticipantId{});
  claim.start(start);
  EXPECT_NE(claim.id(), ParticipantId{});
  EXPECT_FALSE(claim.is_held());
  std::vector<Instant> claims;
  const auto claimed = settle(claim, Step::claimed, &claims);
  EXPECT_THAT(claims, ::testing::ElementsAre(start, start + milliseconds(30), start + milliseconds(60)));
  EXPECT_EQ(claimed, start + milliseconds(90));
  EXPECT_TRUE(claim.is_held());
  EXPECT_EQ(claim.due(), base::never);
  EXPECT_EQ(claim.step(claimed + seconds(9)), Step::wait);
}

TEST(IdentifierClaim, DoesNothingBeforeItIsDue) {
  IdentifierClaim claim(1);
  claim.start(start);
  ASSERT_EQ(claim.step(start), Step::send_claim);
  EXPECT_EQ(claim.step(start), Step::wait);
  EXPECT_EQ(claim.step(start + milliseconds(30) - std::chrono::nanoseconds(1)), Step::wait);
  EXPECT_EQ(claim.step(start + milliseconds(30)), Step::send_claim);
}

TEST(IdentifierClaim, IsNotDelayedByLateTimersAndDoesNotSendItsCopiesAtOnce) {
  IdentifierClaim claim(1);
  claim.start(start);
  ASSERT_EQ(claim.step(start + milliseconds(4)), Step::send_claim);
  EXPECT_EQ(claim.due(), start + milliseconds(30));
  ASSERT_EQ(claim.step(start + milliseconds(70)), Step::send_claim);
  EXPECT_EQ(claim.due(), start + milliseconds(85));
}

TEST(IdentifierClaim, DrawsDifferentIdentifiersForDifferentSeedsAndNeverNone) {
  std::set<ParticipantId> ids;
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    IdentifierClaim claim(seed);
    claim.start(start);
    ids.insert(claim.id());
  }
  EXPECT_EQ(ids.size(), 1000U);
  EXPECT_FALSE(ids.contains(ParticipantId{}));
}

TEST(IdentifierClaim, DrawsNoneThatIsKnownToBeTaken) {
  IdentifierClaim first(5);
  first.start(start);
  const auto taken = first.id();
  IdentifierClaim second(5, [taken](ParticipantId id) { return id == taken; });
  second.start(start);
  EXPECT_NE(second.id(), taken);
}

TEST(IdentifierClaim, DrawsAgainWhenAnOwnerAnswersOrAnotherClaimsTheSame) {
  for (const auto kind : {announcement::Kind::state, announcement::Kind::claim}) {
    IdentifierClaim claim(2);
    claim.start(start);
    const auto first = claim.id();
    ASSERT_EQ(claim.step(start), Step::send_claim);
    const auto when = start + milliseconds(50);
    EXPECT_EQ(claim.conflict(kind, when), Verdict::redrawn);
    EXPECT_NE(claim.id(), first);
    std::vector<Instant> claims;
    EXPECT_EQ(settle(claim, Step::claimed, &claims), when + milliseconds(90));
    EXPECT_EQ(claims.size(), claim_copies);
  }
}

TEST(IdentifierClaim, KeepsAnIdentifierThatItOwnsAgainstAClaimAndAnswers) {
  auto claim = held();
  const auto id = claim.id();
  EXPECT_EQ(claim.conflict(announcement::Kind::claim, start + seconds(1)), Verdict::answer);
  EXPECT_EQ(claim.id(), id);
  EXPECT_TRUE(claim.is_held());
}

TEST(IdentifierClaim, DropsAnIdentifierThatTwoOwn) {
  auto claim = held();
  const auto id = claim.id();
  const auto when = start + seconds(1);
  EXPECT_EQ(claim.conflict(announcement::Kind::state, when), Verdict::dropped);
  EXPECT_NE(claim.id(), id);
  EXPECT_FALSE(claim.is_held());
  EXPECT_EQ(settle(claim, Step::claimed), when + milliseconds(90));
}

TEST(IdentifierClaim, IgnoresAGoodbyeForItsIdentifier) {
  auto claim = held();
  EXPECT_EQ(claim.conflict(announcement::Kind::goodbye, start + seconds(1)), Verdict::ignore);
  EXPECT_TRUE(claim.is_held());
  IdentifierClaim claiming(3);
  EXPECT_EQ(claiming.conflict(announcement::Kind::state, start), Verdict::ignore);
  claiming.start(start);
  const auto id = claiming.id();
  EXPECT_EQ(claiming.conflict(announcement::Kind::goodbye, start), Verdict::ignore);
  EXPECT_EQ(claiming.id(), id);
}

TEST(IdentifierClaim, FailsWhenItsAttemptsAreUsedUp) {
  IdentifierClaim claim(4);
  claim.start(start);
  for (std::size_t i = 1; i < max_claim_attempts; ++i)
    EXPECT_EQ(claim.conflict(announcement::Kind::state, start), Verdict::redrawn);
  EXPECT_EQ(claim.conflict(announcement::Kind::state, start), Verdict::failed);
  EXPECT_EQ(claim.id(), ParticipantId{});
  EXPECT_EQ(claim.due(), start);
  EXPECT_EQ(claim.step(start), Step::failed);
  EXPECT_EQ(claim.step(start), Step::failed);
  EXPECT_EQ(claim.due(), base::never);
  EXPECT_EQ(claim.conflict(announcement::Kind::state, start), Verdict::ignore);
}

TEST(IdentifierClaim, SucceedsWithItsLastAttempt) {
  IdentifierClaim claim(4);
  claim.start(start);
  for (std::size_t i = 1; i < max_claim_attempts; ++i)
    EXPECT_EQ(claim.conflict(announcement::Kind::state, start), Verdict::redrawn);
  settle(claim, Step::claimed);
}

/// The verdicts on a forger that answers everything with a clash: `count` of them, one each `spacing`.
struct Attacked {
  std::size_t dropped = 0;
  std::size_t redrawn = 0;
  std::size_t kept = 0;
};
Attacked attack(IdentifierClaim& claim, Instant from, Duration length, Duration spacing) {
  Attacked result;
  for (auto now = from; now < from + length; now += spacing) {
    while (claim.due() <= now) (void)claim.step(now);
    switch (claim.conflict(announcement::Kind::state, now)) {
      case Verdict::dropped:
        ++result.dropped;
        break;
      case Verdict::redrawn:
        ++result.redrawn;
        break;
      case Verdict::kept:
        ++result.kept;
        break;
      default:
        ADD_FAILURE() << "a running participant gives up";
    }
  }
  return result;
}

TEST(IdentifierClaim, NeverFailsOnceItHasHeldAnIdentifierAndDrawsABoundedNumberAMinute) {
  auto claim = held();
  const auto first = attack(claim, start + seconds(1), seconds(60), milliseconds(1));
  EXPECT_EQ(first.dropped + first.redrawn, static_cast<std::size_t>(redraw_capacity) + 2);
  const auto later = attack(claim, start + seconds(61), seconds(600), milliseconds(1));
  EXPECT_EQ(later.dropped + later.redrawn, seconds(600) / redraw_refill);
  EXPECT_GT(later.kept, 500'000U);
}

TEST(IdentifierClaim, IsHeldInSpiteOfAForgerNinetyMillisecondsAfterItsLastDraw) {
  auto claim = held();
  auto now = start + seconds(1);
  ASSERT_EQ(claim.conflict(announcement::Kind::state, now), Verdict::dropped);
  for (std::int64_t i = 1; i < redraw_capacity; ++i) {
    now += milliseconds(1);
    ASSERT_EQ(claim.conflict(announcement::Kind::claim, now), Verdict::redrawn);
  }
  const auto id = claim.id();
  const auto until = now + milliseconds(90);
  while (now < until) {
    ASSERT_FALSE(claim.is_held());
    now += milliseconds(1);
    EXPECT_EQ(claim.conflict(announcement::Kind::state, now), Verdict::kept);
    while (claim.due() <= now) (void)claim.step(now);
  }
  EXPECT_TRUE(claim.is_held());
  EXPECT_EQ(claim.id(), id);
  EXPECT_EQ(claim.conflict(announcement::Kind::state, now), Verdict::kept);
  EXPECT_EQ(claim.conflict(announcement::Kind::claim, now), Verdict::answer);
  EXPECT_EQ(claim.conflict(announcement::Kind::goodbye, now), Verdict::ignore);
  EXPECT_TRUE(claim.is_held());
}

TEST(IdentifierClaim, DrawsAgainForAClashThatComesLaterThanAllItsDrawsAreBack) {
  auto claim = held();
  auto now = start;
  for (int i = 0; i < 20; ++i) {
    now += redraw_refill;
    ASSERT_EQ(claim.conflict(announcement::Kind::state, now), Verdict::dropped);
    now = settle(claim, Step::claimed);
  }
}

}  // namespace
}  // namespace geminga::membership
