#include "discovery/participant/air/deaf_hosts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace geminga::participant {
namespace {

using std::chrono::seconds;
using testing::ElementsAre;
using testing::IsEmpty;

constexpr base::Instant noon{seconds(1000)};
constexpr base::Duration interval = seconds(2);
constexpr env::InterfaceIndex eth0{2};
constexpr env::InterfaceIndex wlan0{3};

DeafHosts::Way way(std::uint32_t number) {
  return {.participant = ParticipantId{number}, .interface = eth0, .address = "10.0.0." + std::to_string(number)};
}

TEST(DeafHosts, AreTriedOnTheirInterfaceForEightIntervals) {
  DeafHosts hosts;
  hosts.hear_deaf(way(7), interval, noon);
  EXPECT_THAT(hosts.take(eth0, 100, noon), ElementsAre("10.0.0.7"));
  EXPECT_THAT(hosts.take(wlan0, 100, noon), IsEmpty());
  const base::Instant end = noon + try_intervals * interval;
  EXPECT_THAT(hosts.take(eth0, 100, end - base::Duration(1)), ElementsAre("10.0.0.7"));
  EXPECT_THAT(hosts.take(eth0, 100, end), IsEmpty());
  EXPECT_EQ(hosts.octets_sent(), 200U);
}

TEST(DeafHosts, AreTriedWithSoManyOctetsAtMost) {
  for (const auto& [octets, are_sent] :
       {std::pair(max_try_bytes - 1, true), std::pair(max_try_bytes, true), std::pair(max_try_bytes + 1, false)}) {
    DeafHosts hosts;
    hosts.hear_deaf(way(7), interval, noon);
    EXPECT_EQ(hosts.take(eth0, octets, noon).size() == 1, are_sent) << octets;
  }
  DeafHosts hosts;
  hosts.hear_deaf(way(7), interval, noon);
  for (int i = 0; i < 1000; ++i) (void)hosts.take(eth0, 1000, noon);
  EXPECT_EQ(hosts.octets_sent(), max_try_bytes / 1000 * 1000);
}

TEST(DeafHosts, AreLeftAloneForTwiceAsLongAfterEachTryUpToALongestPause) {
  DeafHosts hosts;
  hosts.hear_deaf(way(7), interval, noon);
  std::vector<std::int64_t> pauses;  // in intervals
  bool was_tried = true;
  base::Instant end = noon;
  for (base::Instant now = noon; pauses.size() < 8; now += interval) {
    const bool is_tried = !hosts.take(eth0, 1, now).empty();
    if (was_tried && !is_tried) end = now;
    if (!was_tried && is_tried) pauses.push_back((now - end) / interval);
    was_tried = is_tried;
  }
  EXPECT_THAT(pauses, ElementsAre(8, 16, 32, 64, 128, 256, 256, 256));
}

TEST(DeafHosts, ThatAreLostAreGivenUpAfterEightTries) {
  DeafHosts hosts;
  hosts.lose(way(7), interval, noon);
  for (base::Instant now = noon; now < noon + std::chrono::hours(2); now += interval) (void)hosts.take(eth0, 1, now);
  EXPECT_EQ(hosts.size(), 0U);
  EXPECT_EQ(hosts.octets_sent(), max_tries_of_unheard * try_intervals);
}

TEST(DeafHosts, AreEightAtMostAndThoseThatAreHeardComeFirst) {
  for (const std::uint32_t count : {7U, 8U, 9U}) {
    DeafHosts hosts;
    for (std::uint32_t number = 1; number <= count; ++number) hosts.hear_deaf(way(number), interval, noon);
    EXPECT_EQ(hosts.size(), std::min<std::size_t>(count, max_deaf_hosts));
  }
  DeafHosts hosts;
  for (std::uint32_t number = 1; number <= max_deaf_hosts + 1; ++number) hosts.lose(way(number), interval, noon);
  EXPECT_EQ(hosts.size(), max_deaf_hosts);
  hosts.hear_deaf(way(20), interval, noon);
  EXPECT_EQ(hosts.size(), max_deaf_hosts);
  EXPECT_THAT(hosts.take(eth0, 1, noon), testing::Contains("10.0.0.20"));
}

TEST(DeafHosts, ThatAreIntroducedGiveWayToThoseThatWereHeard) {
  DeafHosts hosts;
  for (std::uint32_t number = 1; number <= max_deaf_hosts + 1; ++number) hosts.introduce(way(number), interval, noon);
  EXPECT_THAT(hosts.take(eth0, 1, noon), testing::SizeIs(max_deaf_hosts));
  hosts.lose(way(20), interval, noon);
  hosts.hear_deaf(way(21), interval, noon);
  hosts.introduce(way(22), interval, noon);
  const auto tried = hosts.take(eth0, 1, noon);
  EXPECT_THAT(tried, testing::IsSupersetOf({"10.0.0.20", "10.0.0.21"}));
  EXPECT_THAT(tried, testing::Not(testing::Contains("10.0.0.22")));
  for (base::Instant now = noon; now < noon + std::chrono::hours(2); now += interval) (void)hosts.take(eth0, 1, now);
  EXPECT_EQ(hosts.size(), 1U) << "those that are not heard are given up";
}

TEST(DeafHosts, AreSpokenToOnceTheyAreReachedUntilTheyAreDeafAgainOrLeave) {
  DeafHosts hosts;
  hosts.hear_deaf(way(7), interval, noon);
  ASSERT_THAT(hosts.take(eth0, 100, noon), ElementsAre("10.0.0.7"));
  hosts.hear(ParticipantId{7});
  const base::Instant later = noon + std::chrono::hours(1);
  EXPECT_THAT(hosts.take(eth0, max_try_bytes + 1, later), ElementsAre("10.0.0.7"));
  hosts.hear_deaf(way(7), interval, later);
  EXPECT_THAT(hosts.take(eth0, 100, later), IsEmpty()) << "a pause comes first";
  EXPECT_THAT(hosts.take(eth0, 100, later + first_pause_intervals * interval), ElementsAre("10.0.0.7"));
  hosts.forget(ParticipantId{7});
  EXPECT_EQ(hosts.size(), 0U);
}

TEST(DeafHosts, AreForgottenWhereTheyHearUsWithoutACopyOrWereLostAndAreHeardAgain) {
  DeafHosts hosts;
  hosts.hear_deaf(way(7), interval, noon);
  hosts.hear(ParticipantId{7});
  hosts.lose(way(8), interval, noon);
  ASSERT_THAT(hosts.take(eth0, 100, noon), ElementsAre("10.0.0.8"));
  hosts.hear(ParticipantId{8});
  EXPECT_THAT(hosts.take(eth0, 100, noon), IsEmpty());
}

}  // namespace
}  // namespace geminga::participant
