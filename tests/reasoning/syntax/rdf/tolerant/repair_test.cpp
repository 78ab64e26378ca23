// Repairs of RDF/XML, and texts that stay as they are.
#include "reasoning/syntax/rdf/tolerant/repair.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace geminga::rdf {
namespace {

TEST(Repair, LeavesUtf8Alone) {
  EXPECT_FALSE(in_utf8("<a>caf\xc3\xa9</a>"));
  EXPECT_FALSE(in_utf8("<?xml version='1.0' encoding='UTF-8'?><a>caf\xc3\xa9</a>"));
  EXPECT_FALSE(in_utf8(""));
  EXPECT_FALSE(in_utf8("<?xml version='1.0' encoding='UTF-16'?><a/>")) << "another encoding is not guessed";
}

TEST(Repair, TakesWesternEncodingsForWindows1252) {
  EXPECT_EQ(in_utf8("<?xml version='1.0' encoding='WINDOWS-1252'?>\n<a>\xe9 \x80 \x93</a>"),
            "<?xml version='1.0'                        ?>\n<a>\xc3\xa9 \xe2\x82\xac \xe2\x80\x9c</a>");
  EXPECT_EQ(in_utf8("<?xml version=\"1.0\" encoding=\"iso-8859-1\"?><a>\xff</a>"),
            "<?xml version=\"1.0\"                      ?><a>\xc3\xbf</a>");
  EXPECT_EQ(in_utf8("<?xml version='1.0' encoding='windows-1252'?><a>\xc3\xa9</a>"),
            "<?xml version='1.0'                        ?><a>\xc3\xa9</a>")
      << "a file that is UTF-8 all through is UTF-8, whatever it says";
}

TEST(Repair, TakesOctetsThatAreNoUtf8ForWindows1252) {
  EXPECT_EQ(in_utf8("<a>caf\xe9 \xc3\xa9 \x99</a>"), "<a>caf\xc3\xa9 \xc3\xa9 \xe2\x84\xa2</a>");
}

TEST(Repair, MakesNamesThatXmlForbidsRelativeIris) {
  const std::string root = "<r xmlns:rdf='x'/>";
  const std::vector<std::pair<std::string, std::string>> cases{
      {"<c rdf:ID=\"4WheeledCar\"/>\n<c rdf:ID = 'a b'/>", "<c rdf:about=\"#4WheeledCar\"/>\n<c rdf:about='#a b'/>"},
      {"<c rdf:ID=\"Car\"/>", "<c rdf:ID=\"Car\"/>"},
      {"<c rdf:ID=\"Car\"/><c rdf:ID=\"Car\"/>", "<c rdf:ID=\"Car\"/><c rdf:about=\"#Car\"/>"},
      {"<c rdf:ID=\"open", "<c rdf:ID=\"open"},
      {"<c rdf:ID", "<c rdf:ID"}};
  for (const auto& [written, mended] : cases) EXPECT_EQ(with_legal_names(root + written), root + mended);
}

TEST(Repair, EscapesAmpersandsThatBeginNoReference) {
  EXPECT_EQ(with_legal_names("<a>B & B &amp; &xsd;x &#x41; &#65; &; AT&T</a>"),
            "<a>B &amp; B &amp; &amp;xsd;x &#x41; &#65; &amp;; AT&amp;T</a>");
  EXPECT_EQ(with_legal_names("<!DOCTYPE a [<!ENTITY xsd 'x'><!ENTITY"), "<!DOCTYPE a [<!ENTITY xsd 'x'><!ENTITY");
  EXPECT_EQ(with_legal_names("<!DOCTYPE a [<!ENTITY xsd 'x'>]><a b='&xsd;&xs;'/>"),
            "<!DOCTYPE a [<!ENTITY xsd 'x'>]><a b='&xsd;&amp;xs;'/>");
  EXPECT_EQ(with_legal_names("<!-- a & b --><![CDATA[ & ]]>&"), "<!-- a & b --><![CDATA[ & ]]>&amp;");
  EXPECT_EQ(with_legal_names("a\x01z\n"), "a z\n");
}

TEST(Repair, DeclaresPrefixesThatNobodyDeclares) {
  EXPECT_EQ(with_legal_names("<rdf:RDF>\n<x:a y:b='z:c' rdf:ID='d'/><!-- <v:w/> --></rdf:RDF>"),
            "<rdf:RDF xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\" xmlns:x=\"urn:geminga:undeclared:x#\" "
            "xmlns:y=\"urn:geminga:undeclared:y#\">\n<x:a y:b='z:c' rdf:ID='d'/><!-- <v:w/> --></rdf:RDF>");
  for (const char* whole : {"<?xml version='1.0'?><!DOCTYPE r [<!ENTITY e 'f:g'>]><r:a xmlns:r='u#' xml:lang='en'/>",
                            "<a", "<a b='", "<", "</r:a>", "no tag", "<!DOCTYPE", "<a><![CDATA[<r:b/>]]></a>"})
    EXPECT_EQ(with_legal_names(whole), whole);
}

TEST(Repair, MendsCommentsAndWhatStandsBeforeTheDeclaration) {
  EXPECT_EQ(with_legal_names("<!-- a -- b ---><c/>"), "<!-- a  - b  --><c/>");
  EXPECT_EQ(with_legal_names("<!--open"), "<!--open-->");
  EXPECT_EQ(with_legal_names("<!---->\n<!-- - -->"), "<!---->\n<!-- - -->");
  EXPECT_EQ(with_legal_names("\n <?xml version='1.0'?><c/>"), "<?xml version='1.0'?><c/>");
  EXPECT_EQ(with_legal_names("\n <c/>"), "\n <c/>");
}

}  // namespace
}  // namespace geminga::rdf
