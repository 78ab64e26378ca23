// Texts that are too long are found whatever stretches the file is read in.
#include "reasoning/syntax/long_text.hpp"

#include <gtest/gtest.h>

#include <string>

namespace geminga::syntax {
namespace {

/// The line that is found in a text, read in stretches of this many octets.
std::optional<std::uint32_t> found(Syntax syntax, const std::string& text, std::size_t stretch) {
  LongText watch(syntax, {.text = 10, .blank = 40, .name = 50, .xml_comment = 80});
  for (std::size_t at = 0; at < text.size(); at += stretch) {
    if (const auto line = watch.look_at(std::string_view(text).substr(at, stretch))) return line;
  }
  return std::nullopt;
}

TEST(LongText, FindsWhatIsBeyondItsLimitInAnyStretches) {
  const std::string head = "# \"more than ten octets\n<http://e/more-than-ten#octets> \n";
  for (const std::size_t stretch : {1U, 2U, 3U, 7U, 1000U}) {
    for (const Syntax syntax : {Syntax::turtle, Syntax::n_triples, Syntax::functional}) {
      EXPECT_EQ(found(syntax, head + "\"012345678\" \"\" \"x\" , 'y' .\n", stretch), std::nullopt);
      EXPECT_EQ(found(syntax, head + "\"0123456789a", stretch), 3U);
      EXPECT_EQ(found(syntax, head + "\"012\\\"56789a\"", stretch), 3U) << "an escaped mark does not end it";
      EXPECT_EQ(found(syntax, head + "\"\"\"012\"4\n6789a\"\"\"", stretch), 3U);
      EXPECT_EQ(found(syntax, head + "\"\"\"01\"3\n\"\"\" \"\"\"01\"\n\"\"\" .\n", stretch), std::nullopt);
    }
    EXPECT_EQ(
        found(Syntax::rdf_xml, "<a>0123456789</a><!-- a long comment, in which <a> counts nothing --><b>", stretch),
        std::nullopt);
    EXPECT_EQ(found(Syntax::rdf_xml, "<a>\n<b>0123456789a</b>", stretch), 2U);
    EXPECT_EQ(found(Syntax::rdf_xml, "<a b=\"0123456789\"/>", stretch), 1U);
  }
}

TEST(LongText, TakesAMarkInANameForNoText) {
  EXPECT_EQ(found(Syntax::turtle, "ex:O\\'Brien a ex:ThatIsLonger, ex:O\\#Neill , \"y\" .\n", 3), std::nullopt);
  EXPECT_EQ(found(Syntax::turtle, "ex:a\\\"0123456789a", 3), 1U) << "a quotation mark is in no name";
}

TEST(LongText, CountsTheLastOctetOfItsLimitAndNotBefore) {
  EXPECT_EQ(found(Syntax::rdf_xml, "<a>012345678</a>", 4), std::nullopt);
  EXPECT_EQ(found(Syntax::rdf_xml, "<a>0123456789</a>", 4), std::nullopt);
  EXPECT_EQ(found(Syntax::rdf_xml, "<a>0123456789a</a>", 4), 1U);
}

TEST(LongText, FindsTooMuchWhiteSpaceAndComment) {
  const auto blanks = [](std::size_t count) { return "<a>\n#" + std::string(count - 3, ' ') + "\n<b>"; };
  EXPECT_EQ(found(Syntax::n_triples, blanks(39), 7), std::nullopt);
  EXPECT_EQ(found(Syntax::n_triples, blanks(40), 7), std::nullopt);
  EXPECT_EQ(found(Syntax::n_triples, blanks(41), 7), 1U);
  EXPECT_EQ(found(Syntax::rdf_xml, blanks(41), 7), 1U) << "it is a text there";
}

TEST(LongText, FindsANameThatGoesOnAndOn) {
  const auto name = [](std::size_t size) { return "<a> <b> \n " + std::string(size, 'n') + " <c> ."; };
  const auto iri = [](std::size_t size) { return "<a> <b> \n <" + std::string(size, 'n') + "> ."; };
  for (const std::size_t stretch : {1U, 7U, 1000U}) {
    for (const Syntax syntax : {Syntax::turtle, Syntax::n_triples, Syntax::functional}) {
      EXPECT_EQ(found(syntax, name(50), stretch), std::nullopt);
      EXPECT_EQ(found(syntax, name(51), stretch), 2U);
      EXPECT_EQ(found(syntax, iri(50), stretch), std::nullopt);
      EXPECT_EQ(found(syntax, iri(51), stretch), 2U);
    }
  }
}

TEST(LongText, FindsAnXmlCommentThatLibxml2WouldKeepAsAWhole) {
  const auto comment = [](std::size_t size) { return "<a>\n<!--" + std::string(size - 3, 'c') + "--></a>"; };
  for (const std::size_t stretch : {1U, 7U, 1000U}) {
    EXPECT_EQ(found(Syntax::rdf_xml, comment(79), stretch), std::nullopt);
    EXPECT_EQ(found(Syntax::rdf_xml, comment(80), stretch), std::nullopt);
    EXPECT_EQ(found(Syntax::rdf_xml, comment(81), stretch), 2U);
    EXPECT_EQ(found(Syntax::rdf_xml, "<a>\n<!--" + std::string(78, '\n') + "--></a>", stretch), 2U)
        << "where it begins";
  }
}

}  // namespace
}  // namespace geminga::syntax
