// Sealed teams reach hosts from which multicasts are kept; without a key nobody is spoken to alone.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "discovery/participant/air/deaf_hosts.hpp"
#include "discovery/sealing/rig.hpp"
#include "sim/robots.hpp"

namespace geminga::sim {
namespace {

using sealing::Mode;
using sealing::policy;
using std::chrono::minutes;
using std::chrono::seconds;
using testing::Contains;
using testing::HasSubstr;
using testing::SizeIs;

constexpr Bounds patient = {.missing = seconds(60), .surplus = seconds(60)};

/// A team in which each has heard the others.
struct Met : Robots {
  Met(std::uint64_t seed, int count, double loss, bool is_sealed)
      : Robots(World::seed_or(seed), count, {.loss = loss, .longest_delay = std::chrono::milliseconds(5)}, patient) {
    for (const auto& host : world.hosts()) {
      if (is_sealed) host->settings.sealing = policy(Mode::encrypted, {1});
      host->hears_datagrams_alone = true;
    }
    start();
    world.run_for(seconds(20));
  }
  [[nodiscard]] std::size_t known_to(std::size_t number) { return world.ask(host(number), "participants").size() - 1; }
  [[nodiscard]] std::uint64_t octets_alone() const {
    std::uint64_t octets = 0;
    for (const auto& one : world.hosts()) octets += one->octets_sent_alone;
    return octets;
  }
};

TEST(Reach, IsFoundAgainAloneByASealedTeamAtAnyLoss) {
  for (const double loss : {0.0, 0.3}) {
    Met team(61, 4, loss, true);
    ASSERT_EQ(team.octets_alone(), 0U) << "loss " << loss << ": nobody is deaf";
    team.team.is_excused = true;  // the deaf one is right to take all for gone at first
    team.host(3).hears_multicasts = false;
    team.world.run_for(minutes(1));
    EXPECT_EQ(team.known_to(3), 4U) << "loss " << loss;
    EXPECT_EQ(team.known_to(0), 4U);
    EXPECT_GT(team.octets_alone(), 0U);
  }
}

TEST(Reach, CostsACopyOfEachDatagramAndLosesNobodyAnyMore) {
  Met team(62, 3, 0, true);
  team.team.is_excused = true;
  team.host(2).hears_multicasts = false;
  team.world.run_for(minutes(1));
  const std::size_t events = team.team.events();
  const std::uint64_t said = team.host(0).octets_sent();
  const std::uint64_t alone = team.host(0).octets_sent_alone;
  for (int second = 0; second < 120; ++second) {
    team.world.run_for(seconds(1));
    ASSERT_EQ(team.known_to(2), 3U) << "second " << second;
  }
  EXPECT_EQ(team.team.events(), events) << "no service went or came";
  EXPECT_LE(team.host(0).octets_sent_alone - alone, 2 * (team.host(0).octets_sent() - said));
}

TEST(Reach, OfAHostThatNothingReachesIsTriedWithinItsOctets) {
  Met team(63, 3, 0, true);
  team.team.is_excused = true;
  team.host(2).hears_multicasts = false;
  team.host(2).hears_datagrams_alone = false;
  std::uint64_t before = 0;
  for (int quarter = 0; quarter < 4; ++quarter) {
    team.world.run_for(minutes(15));
    const std::uint64_t octets = team.host(0).octets_sent_alone - before;
    before = team.host(0).octets_sent_alone;
    // The tries begin within 32, 64, 128 s, ... of each other: six in the first quarter of an hour, and then two.
    EXPECT_LE(octets, (quarter == 0 ? 6 : 2) * participant::max_try_bytes) << "quarter " << quarter;
    EXPECT_GT(octets, 0U) << "quarter " << quarter << ": it is heard, and tried for as long as it is";
  }
}

TEST(Reach, IsForEightHostsAtMost) {
  Met team(64, 12, 0, true);
  team.team.is_excused = true;
  for (std::size_t number = 2; number < 12; ++number) {
    team.host(number).hears_multicasts = false;
    team.host(number).hears_datagrams_alone = false;
  }
  team.world.run_for(seconds(20));
  EXPECT_THAT(team.world.ask(team.host(0), "status"), Contains(HasSubstr(" tried_alone=8 ")));
}

/// A team of which two never heard each other by multicast, and all others hear and are heard by everybody.
struct Apart : Robots {
  Apart(std::uint64_t seed, int count, double loss, bool is_sealed)
      : Robots(World::seed_or(seed), count, {.loss = loss, .longest_delay = std::chrono::milliseconds(5)}, patient) {
    for (const auto& host : world.hosts()) {
      if (is_sealed) host->settings.sealing = policy(Mode::encrypted, {1});
      host->hears_datagrams_alone = true;
    }
    host(0).multicasts_kept_from = {host(1).name()};
    host(1).multicasts_kept_from = {host(0).name()};
    team.is_excused = true;  // they are right to miss each other at first
    start();
  }
  [[nodiscard]] std::size_t known_to(std::size_t number) { return world.ask(host(number), "participants").size() - 1; }
};

TEST(Reach, IsFoundByTheWordOfOthersInASealedTeamAtAnyLoss) {
  for (const double loss : {0.0, 0.3}) {
    Apart robots(66, 4, loss, true);
    robots.world.run_for(seconds(60));
    EXPECT_EQ(robots.known_to(0), 4U) << "loss " << loss;
    EXPECT_EQ(robots.known_to(1), 4U) << "loss " << loss;
    robots.world.run_for(seconds(60));
    EXPECT_EQ(robots.known_to(0), 4U) << "and kept, loss " << loss;
  }
}

TEST(Reach, OfAHostThatIsHeardByOthersAloneIsTriedWithinItsOctets) {
  Apart robots(67, 3, 0, true);
  robots.host(0).hears_datagrams_alone = robots.host(1).hears_datagrams_alone = false;
  robots.world.run_for(minutes(15));
  const std::uint64_t first = robots.host(0).octets_sent_alone;
  EXPECT_GT(first, 0U);
  EXPECT_LE(first, participant::max_tries_of_unheard * participant::max_try_bytes);
  const std::uint64_t said = robots.host(2).octets_sent();
  robots.world.run_for(minutes(60));
  EXPECT_LE(robots.host(2).octets_sent() - said, std::uint64_t{60} * 60 * 100) << "introductions end";
}

TEST(Reach, IsNotFoundByTheWordOfOthersWithoutAKey) {
  Apart robots(68, 3, 0, false);
  robots.world.run_for(seconds(60));
  EXPECT_EQ(robots.known_to(0), 2U);
  EXPECT_EQ(robots.host(0).octets_sent_alone + robots.host(2).octets_sent_alone, 0U);
}

TEST(Reach, IsLeftToTheOwnerWithoutAKey) {
  Met team(65, 3, 0, false);
  team.team.is_excused = true;
  team.host(2).hears_multicasts = false;
  team.world.run_for(minutes(2));
  EXPECT_EQ(team.octets_alone(), 0U);
  EXPECT_EQ(team.known_to(2), 1U);
}

}  // namespace
}  // namespace geminga::sim
