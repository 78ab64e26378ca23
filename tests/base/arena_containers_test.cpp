// Lists and sets in the memory of an arena.
#include "base/arena_containers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace geminga::base {
namespace {

/// The members of a set into which the numbers up to `known` were inserted one by one, and the numbers from `first` to
/// `last` at once.
std::vector<std::uint32_t> members(std::uint32_t known, std::uint32_t first, std::uint32_t last) {
  Arena arena;
  ArenaSet<std::uint32_t> set;
  for (std::uint32_t key = 0; key < known; ++key) EXPECT_TRUE(set.insert(key, arena));
  std::vector<std::uint32_t> keys;
  for (std::uint32_t key = first; key < last; ++key) keys.push_back(key);
  set.insert_all(keys, arena);
  for (std::uint32_t key = 0; key < last + 20; ++key)
    EXPECT_EQ(set.contains(key), key < known || (key >= first && key < last));
  for (const std::uint32_t key : keys) EXPECT_FALSE(set.insert(key, arena));
  EXPECT_TRUE(set.insert(1000, arena));
  return {set.items().begin(), set.items().end() - 1};
}

TEST(ArenaSet, TakesManyKeysInTheirOrderWithoutThoseThatItHas) {
  for (const std::uint32_t known : {0U, 1U, 4U, 15U, 16U, 17U, 40U}) {
    for (const std::uint32_t count : {0U, 1U, 11U, 12U, 13U, 16U, 17U, 100U}) {
      for (const std::uint32_t first : {0U, known / 2, known}) {
        const auto found = members(known, first, first + count);
        ASSERT_EQ(found.size(), std::max(known, first + count)) << known << ' ' << first << ' ' << count;
        for (std::uint32_t at = 0; at < found.size(); ++at) EXPECT_EQ(found[at], at);
      }
    }
  }
}

}  // namespace
}  // namespace geminga::base
