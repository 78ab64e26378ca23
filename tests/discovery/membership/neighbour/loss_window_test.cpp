// The loss that the sequence numbers of one sender show.
#include "discovery/membership/neighbour/loss_window.hpp"

#include <gtest/gtest.h>

namespace geminga::membership {
namespace {

TEST(LossWindow, CountsNeitherCopiesNorReorderingAsLoss) {
  LossWindow window;
  EXPECT_EQ(window.loss(), 0);
  for (const std::uint64_t sequence : {10U, 12U, 11U, 12U, 9U, 13U}) window.count(sequence);
  EXPECT_EQ(window.loss(), 0);
}

TEST(LossWindow, ForgetsWhatIsLongerAgoThanSixtyFour) {
  LossWindow window;
  window.count(0);
  window.count(63);
  EXPECT_DOUBLE_EQ(window.loss(), 62.0 / 64);
  window.count(64);
  EXPECT_DOUBLE_EQ(window.loss(), 62.0 / 64);
  for (std::uint64_t sequence = 65; sequence < 200; ++sequence) window.count(sequence);
  EXPECT_EQ(window.loss(), 0);
}

TEST(LossWindow, RemembersTheLastTwoHundredAndFiftySixForThoseWhoHaveToBeSure) {
  LossWindow window;
  for (std::uint64_t sequence = 0; sequence <= 254; sequence += 2) window.count(sequence);
  EXPECT_EQ(window.for_long(), (LossSample{.missed = 127, .numbers = 255}));
  EXPECT_EQ(window.lately(), (LossSample{.missed = 32, .numbers = 64})) << "254, 252, ... 192";
  window.count(255);
  EXPECT_EQ(window.for_long(), (LossSample{.missed = 127, .numbers = 256}));
  window.count(256);
  EXPECT_EQ(window.for_long(), (LossSample{.missed = 127, .numbers = 256})) << "0 is forgotten, which was heard";
  window.count(257);
  EXPECT_EQ(window.for_long(), (LossSample{.missed = 126, .numbers = 256}));
  window.count(256 + 257);
  EXPECT_EQ(window.for_long(), (LossSample{.missed = 255, .numbers = 256}));
  EXPECT_FALSE(window.has(257)) << "order is judged by 64";
}

TEST(LossWindow, GoesOnForThoseWhoHaveToBeSureWhereASenderWasGivenUp) {
  LossWindow former;
  for (const std::uint64_t sequence : {10U, 14U, 18U}) former.count(sequence);
  LossWindow window;
  window.count(25);
  window.go_on_from(former);
  EXPECT_EQ(window.loss(), 0) << "deadlines follow what was heard since";
  EXPECT_FALSE(window.has(18));
  EXPECT_EQ(window.lately(), (LossSample{.missed = 12, .numbers = 16}));
  window.count(26);
  EXPECT_EQ(window.for_long(), (LossSample{.missed = 12, .numbers = 17}));
  EXPECT_EQ(window.span(), 2);
  for (const std::uint64_t other : {18U, 18U + 256U, 17U}) {
    LossWindow late;
    late.count(other);
    late.go_on_from(former);
    EXPECT_EQ(late.for_long(), (LossSample{.missed = 0, .numbers = 1})) << "too early or too late: " << other;
  }
}

TEST(LossWindow, BeginsAnewWhenTheSenderDoes) {
  LossWindow window;
  window.count(1000);
  window.count(1010);
  EXPECT_GT(window.loss(), 0.7);
  window.count(1010 - 64);
  EXPECT_EQ(window.loss(), 0);
  window.count(std::numeric_limits<std::uint64_t>::max());
  EXPECT_DOUBLE_EQ(window.loss(), 63.0 / 64);
}

}  // namespace
}  // namespace geminga::membership
