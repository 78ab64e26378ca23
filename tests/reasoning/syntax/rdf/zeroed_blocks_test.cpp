// Memory that raptor asks for is zeroed, and comes from the cache of its thread.
#include "reasoning/syntax/rdf/triples/zeroed_blocks.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <limits>
#include <memory>
#include <span>

namespace geminga::rdf {
namespace {

using testing::Each;

struct Free {
  void operator()(void* block) const { std::free(block); }
};
using Block = std::unique_ptr<unsigned char, Free>;

Block zeroed(std::size_t count, std::size_t size) {
  return Block(static_cast<unsigned char*>(std::calloc(count, size)));
}

TEST(ZeroedBlocks, AreOfThisProgramUnlessASanitizerHasItsOwn) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  EXPECT_FALSE(has_zeroed_blocks());
#else
  EXPECT_TRUE(has_zeroed_blocks());
#endif
}

TEST(ZeroedBlocks, HoldNothingOfTheBlocksBeforeThem) {
  for (std::size_t size = 1; size < 3000; size += size / 3 + 1) {
    {
      std::memset(Block(static_cast<unsigned char*>(std::malloc(size))).get(), 0xff, size);
    }
    const Block block = zeroed(size, 1);
    ASSERT_NE(block, nullptr);
    EXPECT_THAT(std::span(block.get(), size), Each(0)) << size;
  }
}

TEST(ZeroedBlocks, TakeNoMemoryBeforeTheyAreWrittenWhereTheyAreLarge) {
  if (!has_zeroed_blocks()) GTEST_SKIP() << "a sanitizer has its own";
  constexpr std::size_t large = std::size_t{256} << 20;
  const auto resident = [] {
    std::ifstream statm("/proc/self/statm");
    std::size_t all = 0;
    std::size_t pages = 0;
    statm >> all >> pages;
    return pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  };
  const std::size_t before = resident();
  const Block block = zeroed(large, 1);
  ASSERT_NE(block, nullptr);
  EXPECT_LT(resident(), before + large / 8);
}

TEST(ZeroedBlocks, AreNotGivenWhereTheirSizeIsNoNumber) {
  if (!has_zeroed_blocks()) GTEST_SKIP() << "a sanitizer ends the program";
  // Hidden from the compiler, which warns of such sizes.
  const volatile std::size_t half = std::numeric_limits<std::size_t>::max() / 2 + 1;
  errno = 0;
  EXPECT_EQ(zeroed(half, 2), nullptr);
  EXPECT_EQ(errno, ENOMEM);
}

}  // namespace
}  // namespace geminga::rdf
