// Two pieces of work are both done, whichever of them fails.
#include "base/parallel/both.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace geminga::parallel {
namespace {

TEST(Both, AreDoneWithAnyNumberOfThreads) {
  for (const unsigned threads : {0U, 1U, 2U, 5U}) {
    int first = 0;
    int second = 0;
    do_both(threads, [&] { ++first; }, [&] { ++second; });
    EXPECT_EQ(first, 1);
    EXPECT_EQ(second, 1);
  }
}

TEST(Both, AreDoneInTurnByOneThread) {
  std::string order;
  do_both(1, [&] { order += 'a'; }, [&] { order += 'b'; });
  EXPECT_EQ(order, "ab");
}

TEST(Both, ThrowWhatEitherOfThemThrows) {
  const auto fail = [] { throw std::runtime_error("no memory"); };
  int done = 0;
  const auto work = [&] { ++done; };
  EXPECT_THROW(do_both(2, fail, work), std::runtime_error);
  EXPECT_THROW(do_both(2, work, fail), std::runtime_error);
  EXPECT_EQ(done, 2);
  EXPECT_THROW(do_both(1, work, fail), std::runtime_error);
}

}  // namespace
}  // namespace geminga::parallel
