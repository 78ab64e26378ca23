#include "daemon/memory/memory_reserve.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <new>

#include "base/time.hpp"
#include "daemon/memory/memory_watch.hpp"
#include "daemon/memory/process_limits.hpp"

namespace geminga::daemon {
namespace {

TEST(MemoryReserve, IsGivenBackOnceWhenMemoryIsShortAndTakenAnew) {
  {
    MemoryReserve reserve;
    EXPECT_EQ(MemoryReserve::size(), reserved_bytes);
    EXPECT_FALSE(MemoryReserve::take_shortage());
    const std::new_handler handler = std::get_new_handler();
    ASSERT_NE(handler, nullptr);
    handler();
    EXPECT_EQ(MemoryReserve::size(), 0U) << "operator new tries again, and finds it";
    EXPECT_THROW(handler(), std::bad_alloc) << "there was nothing left";
    EXPECT_TRUE(MemoryReserve::take_shortage());
    EXPECT_FALSE(MemoryReserve::take_shortage());
    EXPECT_TRUE(reserve.refill());
    EXPECT_EQ(MemoryReserve::size(), reserved_bytes);
  }
  EXPECT_EQ(std::get_new_handler(), nullptr);
  EXPECT_EQ(MemoryReserve::size(), 0U);
}

TEST(MemoryWatch, TellsOnceThatMemoryWasShortAndMakesTheReserveWholeAgain) {
  MemoryWatch watch;
  base::Instant now{};
  EXPECT_FALSE(watch.is_short(now));
  std::get_new_handler()();
  EXPECT_TRUE(watch.is_short(now)) << "between two looks at the system, too";
  EXPECT_EQ(MemoryReserve::size(), 0U) << "there may be no memory for it so soon";
  EXPECT_FALSE(watch.is_short(now));
  now += std::chrono::seconds(1);
  EXPECT_FALSE(watch.is_short(now));
  EXPECT_EQ(MemoryReserve::size(), reserved_bytes);
}

TEST(ProcessLimits, TellTheMemoryInUse) {
  EXPECT_GT(memory_in_use(), 0U);
  const auto most = memory_of_group();
  EXPECT_TRUE(!most || *most > memory_in_use());
}

}  // namespace
}  // namespace geminga::daemon
