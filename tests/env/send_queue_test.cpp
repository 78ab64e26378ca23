#include "env/asio/send_queue.hpp"

#include <gtest/gtest.h>

#include "base/random.hpp"

namespace geminga::env {
namespace {

TEST(SendQueue, GivesWhatCameInInItsOrder) {
  SendQueue queue;
  queue.append("one ");
  queue.append("two");
  queue.drop(2);
  EXPECT_EQ(queue.waiting(), "e two");
  queue.append(" three");
  queue.drop(6);
  EXPECT_EQ(queue.waiting(), "three");
  queue.drop(5);
  EXPECT_EQ(queue.waiting(), "");
}

/// A client that always reads a little and never everything: sent bytes must not stay.
TEST(SendQueue, ThatNeverRunsEmptyHoldsNoMoreThanSeveralTimesWhatWaits) {
  constexpr std::size_t most_waiting = 20'000;
  SendQueue queue;
  queue.append(std::string(most_waiting, 'x'));
  for (int round = 0; round < 10'000; ++round) {
    queue.drop(most_waiting / 2);
    ASSERT_EQ(queue.waiting().size(), most_waiting / 2);
    queue.append(std::string(most_waiting / 2, 'x'));
    ASSERT_LE(queue.held(), 4 * most_waiting + SendQueue::kept_bytes) << "after " << round;
  }
}

TEST(SendQueue, GivesTheRoomOfALongAnswerBack) {
  SendQueue queue;
  queue.append(std::string(4'000'000, 'x'));
  queue.drop(3'999'999);
  EXPECT_LE(queue.held(), SendQueue::kept_bytes);
  EXPECT_EQ(queue.waiting(), "x");
}

TEST(SendQueue, IsRightHoweverItIsCut) {
  base::Random random(4717);
  SendQueue queue;
  std::string in;
  std::string out;
  for (int step = 0; step < 2000; ++step) {
    const std::string more(random.below(300), static_cast<char>('a' + random.below(26)));
    queue.append(more);
    in += more;
    const std::size_t count = random.below(queue.waiting().size() + 1);
    out += queue.waiting().substr(0, count);
    queue.drop(count);
  }
  out += queue.waiting();
  EXPECT_EQ(out, in);
}

}  // namespace
}  // namespace geminga::env
