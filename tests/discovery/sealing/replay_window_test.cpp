// The open counters: each once on each interface, and never long after a higher one.
#include "discovery/sealing/replay_window.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "base/random.hpp"

namespace geminga::sealing {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr env::InterfaceIndex one{1};
constexpr env::InterfaceIndex two{2};
constexpr base::Instant start{std::chrono::hours(1)};

/// Whether a counter may be heard; if so, it is taken.
bool hears(ReplayWindow& window, std::uint32_t counter, base::Instant now = start, env::InterfaceIndex on = one) {
  if (!window.is_open(on, counter, now)) return false;
  window.take(on, counter, now, false);
  return true;
}

TEST(ReplayWindow, HearsEachCounterOnce) {
  ReplayWindow window(one, 100, start, false);
  EXPECT_FALSE(hears(window, 100));
  EXPECT_TRUE(hears(window, 103));
  EXPECT_FALSE(hears(window, 103));
  EXPECT_TRUE(hears(window, 101)) << "overtaken";
  EXPECT_FALSE(hears(window, 101));
  EXPECT_TRUE(hears(window, 102));
}

TEST(ReplayWindow, HearsNothingFromBeforeTheProof) {
  ReplayWindow window(one, 100, start, false);
  EXPECT_FALSE(hears(window, 99));
  EXPECT_FALSE(hears(window, 0));
}

TEST(ReplayWindow, ReachesSixtyThreeCountersBack) {
  ReplayWindow window(one, 0, start, false);
  EXPECT_TRUE(hears(window, 164));
  EXPECT_FALSE(hears(window, 164 - window_counters));
  EXPECT_TRUE(hears(window, 164 - window_counters + 1));
  EXPECT_TRUE(hears(window, 163));
}

TEST(ReplayWindow, SurvivesAnyStepUpToTheLastCounter) {
  ReplayWindow window(one, 0, start, false);
  for (const std::uint32_t counter : {1U, 64U, 128U, 1000U, 0x80000000U, 0xfffffffeU, 0xffffffffU}) {
    EXPECT_TRUE(hears(window, counter)) << counter;
    EXPECT_FALSE(hears(window, counter)) << counter;
  }
}

TEST(ReplayWindow, ClosesASecondAfterAHigherCounter) {
  ReplayWindow window(one, 100, start, false);
  EXPECT_TRUE(hears(window, 110));
  EXPECT_TRUE(hears(window, 101, start + overtaken_time - milliseconds(1)));
  EXPECT_FALSE(hears(window, 102, start + overtaken_time));
  EXPECT_TRUE(hears(window, 111, start + seconds(5)));
  EXPECT_FALSE(hears(window, 103, start + seconds(5)));
}

TEST(ReplayWindow, ClosesInTwoSecondsHoweverManyCountersFollow) {
  ReplayWindow window(one, 100, start, false);
  EXPECT_TRUE(hears(window, 102));
  base::Instant now = start;
  for (std::uint32_t counter = 103; counter < 140; ++counter) {
    now += milliseconds(60);
    EXPECT_TRUE(hears(window, counter, now));
  }
  EXPECT_FALSE(hears(window, 101, now)) << "it is within the counters of the window, and 2.2 s late";
}

TEST(ReplayWindow, HearsADatagramOnceOnEachInterface) {
  ReplayWindow window(one, 100, start, false);
  EXPECT_TRUE(hears(window, 101, start, one));
  EXPECT_TRUE(hears(window, 101, start, two));
  EXPECT_FALSE(hears(window, 101, start, two));
  EXPECT_FALSE(hears(window, 101, start, one));
}

TEST(ReplayWindow, TellsTheCopyOfADatagramThatCameAloneAndByMulticastOnce) {
  for (const bool comes_alone_first : {false, true}) {
    ReplayWindow window(one, 100, start, comes_alone_first);
    window.take(one, 150, start, comes_alone_first);
    for (const std::uint32_t counter : {100U, 150U}) {
      EXPECT_FALSE(window.is_copy(one, counter, comes_alone_first)) << "a replay";
      ASSERT_TRUE(window.is_copy(one, counter, !comes_alone_first)) << counter;
      window.take_copy(one, counter, !comes_alone_first);
      EXPECT_FALSE(window.is_copy(one, counter, !comes_alone_first)) << "a replay of the copy";
      EXPECT_FALSE(hears(window, counter));
    }
    EXPECT_FALSE(window.is_copy(one, 120, !comes_alone_first)) << "it was never heard";
    EXPECT_FALSE(window.is_copy(one, 151, !comes_alone_first));
    EXPECT_FALSE(window.is_copy(two, 150, !comes_alone_first));
    window.take(one, 150 + window_counters, start, comes_alone_first);
    EXPECT_FALSE(window.is_copy(one, 150, !comes_alone_first)) << "it left the window";
  }
}

TEST(ReplayWindow, HearsNothingOnAnotherInterfaceThatIsLate) {
  ReplayWindow window(one, 100, start, false);
  EXPECT_TRUE(hears(window, 101, start, one));
  EXPECT_FALSE(hears(window, 101, start + overtaken_time, two)) << "recorded on one network, replayed on the other";
}

TEST(ReplayWindow, KnowsFourInterfacesAndNoFifth) {
  ReplayWindow window(one, 100, start, false);
  for (std::uint32_t on = 1; on <= max_ways; ++on)
    EXPECT_TRUE(hears(window, 101, start, env::InterfaceIndex(on))) << on;
  EXPECT_FALSE(hears(window, 102, start, env::InterfaceIndex(max_ways + 1)));
}

TEST(ReplayWindow, AgreesWithASetUnderAnyOrder) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    base::Random random(seed);
    ReplayWindow window(one, 1000, start, false);
    std::set<std::uint32_t> heard{1000};
    std::uint32_t highest = 1000;
    for (int i = 0; i < 2000; ++i) {
      const auto counter = highest + static_cast<std::uint32_t>(random.below(80)) - 70;
      const bool is_new = counter > 1000 && !heard.contains(counter) && counter + window_counters > highest;
      ASSERT_EQ(hears(window, counter), is_new) << "seed " << seed << ", counter " << counter << " of " << highest;
      if (is_new) heard.insert(counter);
      if (is_new) highest = std::max(highest, counter);
    }
  }
}

}  // namespace
}  // namespace geminga::sealing
