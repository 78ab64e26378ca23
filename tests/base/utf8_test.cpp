#include "base/utf8.hpp"

#include <gtest/gtest.h>

#include <string>

namespace geminga::base {
namespace {

TEST(Utf8, IsFoundInvalidWhereItIs) {
  const std::string ascii(70, 'a');
  EXPECT_EQ(find_invalid_utf8(""), std::nullopt);
  EXPECT_EQ(find_invalid_utf8(ascii + "ä€😀"), std::nullopt);
  EXPECT_EQ(find_invalid_utf8(ascii + "\x80"), 70U);
  EXPECT_EQ(find_invalid_utf8("ä\xe2\x82"), 2U) << "cut off";
  EXPECT_EQ(find_invalid_utf8("\xc0\x80"), 0U) << "too long for its number";
  EXPECT_EQ(find_invalid_utf8("\xed\xa0\x80"), 0U) << "half of a pair of UTF-16";
}

TEST(Utf8, IsReadAsCharacters) {
  EXPECT_EQ(count_characters("aä€😀"), 4U);
  EXPECT_EQ(character_at("aä"), U'a');
  EXPECT_EQ(character_at("ä"), U'ä');
  EXPECT_EQ(character_at("€"), U'€');
  EXPECT_EQ(character_at("😀"), U'😀');
}

TEST(Utf8, IsCutBetweenCharacters) {
  EXPECT_EQ(first_characters("a€b", 5), "a€b");
  EXPECT_EQ(first_characters("a€b", 4), "a€");
  EXPECT_EQ(first_characters("a€b", 3), "a");
  EXPECT_EQ(first_characters("€", 2), "");
}

}  // namespace
}  // namespace geminga::base
