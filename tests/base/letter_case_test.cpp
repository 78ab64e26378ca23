// Letters up to Latin-1 change their case; of what is beyond, nothing is said.
#include "base/letter_case.hpp"

#include <gtest/gtest.h>

namespace geminga::base {
namespace {

TEST(LetterCase, OfAsciiAndLatin1IsChanged) {
  EXPECT_EQ(in_case("aZ 09~", LetterCase::upper), "AZ 09~");
  EXPECT_EQ(in_case("aZ 09~", LetterCase::lower), "az 09~");
  EXPECT_EQ(in_case("àæçöøþ", LetterCase::upper), "ÀÆÇÖØÞ");
  EXPECT_EQ(in_case("ÀÆÇÖØÞ", LetterCase::lower), "àæçöøþ");
  EXPECT_EQ(in_case("÷×", LetterCase::upper), "÷×") << "these are no letters";
  EXPECT_EQ(in_case("÷×", LetterCase::lower), "÷×");
  EXPECT_EQ(in_case("ßµ", LetterCase::lower), "ßµ");
  EXPECT_EQ(in_case("", LetterCase::upper), "");
}

TEST(LetterCase, OfOtherLettersIsNotKnown) {
  for (const char* text : {"ß", "µ", "ÿ", "ő", "ж"}) EXPECT_EQ(in_case(text, LetterCase::upper), std::nullopt) << text;
  for (const char* text : {"ÿ", "Ő", "Ж"}) EXPECT_EQ(in_case(text, LetterCase::lower), std::nullopt) << text;
}

}  // namespace
}  // namespace geminga::base
