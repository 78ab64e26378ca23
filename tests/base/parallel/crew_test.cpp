// A crew passes an exception of any of its threads to the caller, and ends all of them.
#include "base/parallel/crew.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

namespace geminga::parallel {
namespace {

TEST(Crew, CallsEachNumberOnce) {
  for (const unsigned wanted : {0U, 1U, 2U, 5U}) {
    Crew crew(wanted);
    ASSERT_EQ(crew.size(), std::max(1U, wanted));
    std::vector<std::atomic<int>> calls(crew.size());
    crew.run([&](unsigned me) { ++calls[me]; }, [] { ADD_FAILURE() << "nothing was thrown"; });
    for (const auto& count : calls) EXPECT_EQ(count, 1);
  }
}

TEST(Crew, EndsItsWaitingThreadsWithoutWork) {
  // It runs in a child process: a thread that is not woken would hang it until the alarm, and one that is not joined
  // would abort it.
  const auto make_and_end = [] {
    alarm(60);
    unsigned size = 0;
    {
      const Crew crew(3);
      size = crew.size();
    }
    std::exit(size == 3 ? 0 : 1);
  };
  EXPECT_EXIT(make_and_end(), testing::ExitedWithCode(0), "");
}

TEST(Crew, WhatAnyThreadThrowsReachesTheCallerWhenAllHaveEnded) {
  for (const unsigned thrower : {0U, 1U, 3U}) {
    Crew crew(4);
    std::atomic<bool> is_stopped = false;
    std::atomic<unsigned> ended = 0;
    const auto work = [&](unsigned me) {
      if (me == thrower) throw std::runtime_error(std::to_string(me));
      is_stopped.wait(false);
      ++ended;
    };
    const auto stop = [&] {
      is_stopped = true;
      is_stopped.notify_all();
    };
    try {
      crew.run(work, stop);
      FAIL() << "nothing was thrown";
    } catch (const std::runtime_error& error) {
      EXPECT_EQ(error.what(), std::to_string(thrower));
    }
    EXPECT_EQ(ended, 3U);
  }
}

TEST(Crew, ThrowsOneThingWhereAllThrow) {
  Crew crew(4);
  std::atomic<unsigned> stops = 0;
  EXPECT_THROW(crew.run([](unsigned) { throw std::bad_alloc(); }, [&] { ++stops; }), std::bad_alloc);
  EXPECT_EQ(stops, 4U);
}

}  // namespace
}  // namespace geminga::parallel
