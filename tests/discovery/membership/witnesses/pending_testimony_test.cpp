// Many testimonies read together give what each of them says.
#include "discovery/membership/witnesses/pending_testimony.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "base/random.hpp"

namespace geminga::membership {
namespace {

using announcement::HeardList;
using announcement::HeardWithin;

constexpr base::Duration interval = std::chrono::seconds(2);

base::Instant seen(HeardWithin within, base::Instant at) {
  if (within == HeardWithin::quarter) return at - interval / 4;
  return within == HeardWithin::half ? at - interval / 2 : at - interval;
}

TEST(PendingTestimony, SayTogetherWhatEachOfThemSaid) {
  base::Random random(3);
  for (const std::size_t places : {1U, 4U, 31U, 32U, 33U, 100U, 1025U}) {
    PendingTestimony words;
    words.resize(places);
    std::vector<base::Instant> expected(places);
    base::Instant now{std::chrono::hours(1)};
    while (!words.is_full()) {
      now += random.between(base::Duration(0), interval);
      HeardList heard;
      for (std::size_t place = 0; place < places; ++place) {
        const auto within = static_cast<HeardWithin>(random.below(4));
        heard.push_back(within);
        if (within != HeardWithin::longer) expected[place] = std::max(expected[place], seen(within, now));
      }
      words.add(heard.octets(), now);
    }
    std::vector<base::Instant> together(places);
    words.read([&](std::size_t place, HeardWithin within, base::Instant at) {
      together.at(place) = std::max(together.at(place), seen(within, at));
    });
    EXPECT_EQ(together, expected) << places;
    for (std::size_t place = 0; place < places; ++place) {
      base::Instant alone{};
      words.read_one(place, [&](HeardWithin within, base::Instant at) { alone = std::max(alone, seen(within, at)); });
      EXPECT_EQ(alone, expected[place]) << place << " of " << places;
    }
    words.clear();
    words.read([](std::size_t, HeardWithin, base::Instant) { FAIL() << "nothing is pending"; });
  }
}

TEST(PendingTestimony, LeaveOutWhatHasNoPlace) {
  PendingTestimony words;
  words.resize(2);
  const std::vector<std::uint8_t> octets(300, 0xff);
  words.add(octets, base::Instant(interval));
  std::size_t places = 0;
  words.read([&](std::size_t, HeardWithin, base::Instant) { ++places; });
  EXPECT_EQ(places, 32U) << "a block";
}

}  // namespace
}  // namespace geminga::membership
