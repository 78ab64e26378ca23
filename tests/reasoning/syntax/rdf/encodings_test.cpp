// Files in other encodings than UTF-8.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string_view>

#include "reasoning/syntax/rdf/functional.hpp"
#include "reasoning/syntax/rdf/reading.hpp"

namespace geminga::rdf {
namespace {

using testing::ElementsAre;

/// A text of ASCII and characters beyond the basic plane, in UTF-16.
std::string wide(std::u16string_view text, bool is_little, bool has_mark) {
  std::string bytes;
  const auto add = [&](char16_t unit) {
    const auto low = static_cast<char>(unit & 0xffU);
    const auto high = static_cast<char>(unit >> 8U);
    bytes += is_little ? low : high;
    bytes += is_little ? high : low;
  };
  if (has_mark) add(u'\xfeff');
  for (const char16_t unit : text) add(unit);
  return bytes;
}

TEST(Encodings, MayBeUtf16OfEitherOrderWithAndWithoutAMark) {
  const std::u16string_view xml_text =
      u"<?xml version='1.0' encoding='UTF-16'?>\n"
      "<rdf:RDF xmlns:rdf='http://www.w3.org/1999/02/22-rdf-syntax-ns#' "
      "xmlns:rdfs='http://www.w3.org/2000/01/rdf-schema#'>\n<rdf:Description rdf:about='http://e/\u00d6\U0001F600'>\n"
      "<rdfs:subClassOf rdf:resource='http://e/B'/></rdf:Description></rdf:RDF>";
  const std::u16string_view turtle =
      u"<http://e/\u00d6\U0001F600> <http://www.w3.org/2000/01/rdf-schema#subClassOf>\n\n\n<http://e/B> .";
  for (const bool is_little : {false, true}) {
    for (const bool has_mark : {false, true}) {
      for (const auto& [name, text] : {std::pair{"a.owl", xml_text}, {"a.ttl", turtle}, {"a.owl", turtle}}) {
        const auto loaded = load_text(name, wide(text, is_little, has_mark));
        ASSERT_TRUE(loaded) << name << to_string(loaded.error());
        EXPECT_THAT(functional(loaded->source), ElementsAre("SubClassOf(:\xc3\x96\xf0\x9f\x98\x80 :B)")) << name;
        EXPECT_EQ(loaded->source.axiom(0).line, 4U);
      }
    }
  }
  EXPECT_EQ(refusal("a.owl", wide(u"<a>\n", true, true) + wide(std::u16string(1, char16_t{0xd800}), true, false)),
            "a.owl:2: is in UTF-16 and has half of a character");
  EXPECT_EQ(refusal("a.owl", std::string("\xff\xfe\0\0<\0\0\0", 8)),
            "a.owl: is in UTF-32, which is not read: convert it to UTF-8");
}

TEST(Encodings, OfXmlMayBeWindows1252) {
  const auto loaded = load_text("a.owl",
                                "<?xml version='1.0' encoding='Windows-1252'?>\n<rdf:RDF "
                                "xmlns:rdf='http://www.w3.org/1999/02/22-rdf-syntax-ns#' "
                                "xmlns:rdfs='http://www.w3.org/2000/01/rdf-schema#'><rdf:Description "
                                "rdf:about='http://e/\xe4\x80'><rdfs:subClassOf rdf:resource='http://e/B'/>"
                                "</rdf:Description></rdf:RDF>");
  ASSERT_TRUE(loaded) << to_string(loaded.error());
  EXPECT_THAT(functional(loaded->source), ElementsAre("SubClassOf(:\xc3\xa4\xe2\x82\xac :B)"));
}

}  // namespace
}  // namespace geminga::rdf
