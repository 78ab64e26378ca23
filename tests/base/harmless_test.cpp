#include "base/harmless.hpp"

#include <gtest/gtest.h>

#include "base/text.hpp"

namespace geminga::base {
namespace {

TEST(Harmless, NamesWhatATerminalObeysAndNothingElse) {
  for (const char32_t harmful : {U'\0', U'\x1f', U'\x7f', U'\x80', U'\x9b', U'\x9f', U'\u061c', U'\u200e', U'\u200f',
                                 U'\u2028', U'\u2029', U'\u202a', U'\u202e', U'\u2066', U'\u2069'})
    EXPECT_TRUE(is_harmful(harmful)) << static_cast<unsigned>(harmful);
  for (const char32_t harmless :
       {U' ', U'~', U'\u00a0', U'\u061b', U'\u200d', U'\u2010', U'\u2027', U'\u202f', U'\u2065', U'\u206a', U'😀'})
    EXPECT_FALSE(is_harmful(harmless)) << static_cast<unsigned>(harmless);
}

TEST(Harmless, ALineKeepsItsLettersAndNothingThatATerminalObeys) {
  EXPECT_EQ(harmless("plain"), "plain");
  EXPECT_EQ(harmless("Ölstand 球 😀"), "Ölstand 球 😀");
  EXPECT_EQ(harmless("a\nb\tc\u009b31m\u202ex\xff"), "a\ufffdb\ufffdc\ufffd31m\ufffdx\ufffd");
}

TEST(Harmless, LinesKeepTheirEndsAndTabs) {
  EXPECT_EQ(harmless_lines("a\tb\nc\r\nd\re\x1b[2J\u2028"), "a\tb\nc\r\nd\ufffde\ufffd[2J\ufffd");
  EXPECT_EQ(harmless_lines("end\r"), "end\ufffd");
}

TEST(Harmless, JsonMeansTheSame) {
  EXPECT_EQ(harmless_json("{\"a\": \"\u009b\u202e\x7f球\"}\n"), "{\"a\": \"\\u009b\\u202e\\u007f球\"}\n");
  EXPECT_EQ(harmless_json("{\"a\":\"\\u0000\"}"), "{\"a\":\"\\u0000\"}");
}

TEST(Harmless, HoldsForEachTextThatIsShown) { EXPECT_EQ(printable("\u009b31m \u202e \u2028 \u2066x"), "?31m ? ? ?x"); }

}  // namespace
}  // namespace geminga::base
