#include "daemon/memory/memory_reserve.hpp"

#include <gtest/gtest.h>

#include <new>

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

TEST(ProcessLimits, TellTheMemoryInUse) {
  EXPECT_GT(memory_in_use(), 0U);
  const auto most = memory_of_group();
  EXPECT_TRUE(!most || *most > memory_in_use());
}

}  // namespace
}  // namespace geminga::daemon
