#include "base/text.hpp"

#include <gtest/gtest.h>

namespace geminga::base {
namespace {

TEST(ParseNumber, TakesTheWholeTextOrNothing) {
  EXPECT_EQ(parse_number<std::uint16_t>("65535"), 65535);
  for (const char* bad : {"", "65536", "-1", "+1", " 1", "1 ", "1x", "0x1"}) {
    EXPECT_FALSE(parse_number<std::uint16_t>(bad)) << bad;
  }
  EXPECT_EQ(parse_number<std::int32_t>("-5"), -5);
}

TEST(ParseId32, TakesDecimalAndHexadecimal) {
  EXPECT_EQ(parse_id32("4294967295"), 4294967295U);
  EXPECT_EQ(parse_id32("0xffffffff"), 4294967295U);
  for (const char* bad : {"", "0x", "4294967296", "0x100000000", "0xg", "-1"}) EXPECT_FALSE(parse_id32(bad)) << bad;
}

TEST(Utf8, RefusesOverlongSurrogateAndTruncated) {
  EXPECT_TRUE(is_valid_utf8("\xc3\x96lstand"));
  for (const char* bad : {"\xc0\xaf", "\xed\xa0\x80", "\xf5\x80\x80\x80", "\xc3", "\xff"})
    EXPECT_FALSE(is_valid_utf8(bad));
}

TEST(Printable, ReplacesControlsAndCutsAtACharacter) {
  EXPECT_EQ(printable("a\nb\x7f"), "a?b?");
  EXPECT_EQ(printable("ab\xc3\x96", 3), "ab...");
  EXPECT_TRUE(is_valid_utf8(printable("x\xffy")));
}

TEST(ToHex, HasExactlyItsDigits) { EXPECT_EQ(to_hex(0xabcU, 8), "00000abc"); }

}  // namespace
}  // namespace geminga::base
