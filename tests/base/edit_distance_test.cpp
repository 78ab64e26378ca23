// Distances of mistyped words, at the limits of compared words.
#include "base/edit_distance.hpp"

#include <gtest/gtest.h>

#include <string>

namespace geminga::base {
namespace {

TEST(EditDistance, CountsWrongMissingAddedAndSwappedLetters) {
  EXPECT_EQ(edit_distance("BallInfo", "BallInfo", 3), 0U);
  EXPECT_EQ(edit_distance("BallInfo", "ballinfo", 3), 0U) << "case is no letter";
  EXPECT_EQ(edit_distance("BalInfo", "BallInfo", 3), 1U);
  EXPECT_EQ(edit_distance("BalllInfo", "BallInfo", 3), 1U);
  EXPECT_EQ(edit_distance("BellInfo", "BallInfo", 3), 1U);
  EXPECT_EQ(edit_distance("wehre", "where", 3), 1U);
  EXPECT_EQ(edit_distance("BallInof", "BlalInfo", 3), 2U);
  EXPECT_EQ(edit_distance("", "abc", 3), 3U);
  EXPECT_EQ(edit_distance("", "", 0), 0U);
}

TEST(EditDistance, StopsAtItsLimit) {
  EXPECT_EQ(edit_distance("abcdef", "uvwxyz", 5), 6U);
  EXPECT_EQ(edit_distance("abcdef", "uvwxyz", 6), 6U);
  EXPECT_EQ(edit_distance("ab", "abcdef", 3), 4U);
  EXPECT_EQ(edit_distance("ab", "abcdef", 4), 4U);
}

TEST(EditDistance, ComparesWordsUpToTheirLimit) {
  const std::string last(max_compared_bytes, 'a');
  EXPECT_EQ(edit_distance(last, last.substr(1), 1), 1U);
  EXPECT_EQ(edit_distance(last, last, 1), 0U);
  EXPECT_EQ(edit_distance(last, std::string(max_compared_bytes, 'b'), 250), 200U);
  EXPECT_EQ(edit_distance(last + 'a', last + 'a', 1), 2U) << "no slip of the keyboard";
}

TEST(EditDistance, AThirdOfAWordMayBeWrongButAtMostThreeLetters) {
  EXPECT_EQ(tolerated_slips("ab"), 0U);
  EXPECT_EQ(tolerated_slips("abc"), 1U);
  EXPECT_EQ(tolerated_slips("abcdefgh"), 2U);
  EXPECT_EQ(tolerated_slips("abcdefghi"), 3U);
  EXPECT_EQ(tolerated_slips("abcdefghijklmno"), 3U);
}

}  // namespace
}  // namespace geminga::base
