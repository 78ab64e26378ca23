// The language of an rdf:PlainLiteral, and texts with an @ that names none.
#include "reasoning/owl/plain_literal.hpp"

#include <gtest/gtest.h>

namespace geminga::owl {
namespace {

TEST(PlainLiteral, HasTheLanguageBehindItsLastAt) {
  struct Case {
    const char* written;
    const char* text;
    const char* language;
  };
  for (const Case& one :
       {Case{"a@EN", "a", "en"}, Case{"a@b@de-CH", "a@b", "de-ch"}, Case{"a@", "a", ""}, Case{"@", "", ""},
        Case{"a@x-mine", "a", "x-mine"}, Case{"a", "a", ""}, Case{"me@example.org", "me@example.org", ""},
        Case{"//c[@level='x']/", "//c[@level='x']/", ""}, Case{"a@encodinganalog", "a@encodinganalog", ""},
        Case{"a@en-", "a@en-", ""}, Case{"a@e", "a@e", ""}, Case{"a@e1", "a@e1", ""}, Case{"a@ en", "a@ en", ""},
        Case{"a@en-123456789", "a@en-123456789", ""}}) {
    const PlainLiteral split = split_plain_literal(one.written);
    EXPECT_EQ(split.text, one.text) << one.written;
    EXPECT_EQ(split.language, one.language) << one.written;
  }
}

}  // namespace
}  // namespace geminga::owl
