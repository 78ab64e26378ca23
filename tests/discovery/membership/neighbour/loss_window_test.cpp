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
