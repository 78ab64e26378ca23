// Names of XML mean what the innermost declaration of their prefix says, although raptor is spared most of its search
// for namespaces that end.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <tuple>

#include "reasoning/syntax/rdf/functional.hpp"
#include "reasoning/syntax/rdf/reading.hpp"
#include "reasoning/syntax/rdf/triples/namespace_ends.hpp"

namespace geminga::rdf {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::EndsWith;
using testing::Ge;
using testing::StartsWith;
using testing::UnorderedElementsAreArray;

std::vector<std::string> axioms_of(std::string_view content) {
  const auto loaded = load_text("a.rdf", xml(content));
  if (!loaded) return {to_string(loaded.error())};
  return functional(loaded->source);
}

TEST(Namespaces, AreNotLookedForAtTheEndOfElementsThatDeclareNone) {
  const std::uint64_t before = spared_namespace_ends();
  const auto read = axioms_of(times(100, "<e:C rdf:about='http://e/a'/>\n"));
  EXPECT_THAT(read, ElementsAre("ClassAssertion(:C :a)"));
  EXPECT_THAT(spared_namespace_ends() - before, Ge(95U));
}

/// `<e:TYPE rdf:about="http://e/NAME"/>` as a value.
std::string see(std::string_view type, std::string_view name) {
  return "<rdfs:seeAlso><e:" + std::string(type) + " rdf:about='http://e/" + std::string(name) + "'/></rdfs:seeAlso>\n";
}

TEST(Namespaces, DeclaredAnewHoldUpToTheEndOfTheirElementAtEveryDepth) {
  // Nodes in each other, of which every third declares the prefix anew, and behind each a node that is named by what
  // holds around it.
  std::vector<std::string> expected;
  std::string content;
  std::string ends;
  std::string space;
  for (int level = 0; level < 40; ++level) {
    const std::string number = std::to_string(level);
    const std::string outer = space;
    if (level % 3 == 0) space = number + "/";
    content += "<rdf:Description>\n" + see("A", "a" + number) + "<rdfs:seeAlso>\n<rdf:Description" +
               (level % 3 == 0 ? " xmlns:e='http://e/" + space + "'" : "") + ">\n" + see("B", "b" + number) +
               "<rdfs:seeAlso>\n";
    ends = "</rdfs:seeAlso>\n" + see("C", "c" + number) + "</rdf:Description></rdfs:seeAlso>\n" +
           see("D", "d" + number) + "</rdf:Description>\n" + ends;
    for (const auto& [around, type, name] :
         {std::tuple{outer, "A", "a"}, {space, "B", "b"}, {space, "C", "c"}, {outer, "D", "d"}})
      expected.push_back("ClassAssertion(:" + around + type + " :" + name + number + ")");
  }
  EXPECT_THAT(axioms_of(content + ends), UnorderedElementsAreArray(expected));
}

TEST(Namespaces, AreUnknownBehindTheElementThatDeclaresThem) {
  const std::string inner = "<x:C xmlns:x='http://x/' rdf:about='http://e/a'/>\n";
  EXPECT_THAT(axioms_of(inner), ElementsAre("ClassAssertion(<http://x/C> :a)"));
  EXPECT_THAT(axioms_of("<e:C rdf:about='http://e/a'/>\n" + inner + "<x:C rdf:about='http://e/b'/>\n"),
              ElementsAre(AllOf(StartsWith("a.rdf:5: "), EndsWith("\"x:C\" was not declared."))));
}

TEST(Namespaces, OfXmlLiteralsAreDeclaredInEachOfThem) {
  const std::string literal =
      "<e:note rdf:parseType='Literal'><x:b xmlns:x='http://x/'><x:c/></x:b><e:d><e:f/></e:d></e:note>\n";
  const auto read = axioms_of(
      "<rdf:Description rdf:about='http://e/note'><rdf:type "
      "rdf:resource='http://www.w3.org/2002/07/owl#DatatypeProperty'/></rdf:Description>\n" +
      times(3, "<rdf:Description rdf:about='http://e/a'><rdfs:label>a</rdfs:label>\n" + literal +
                   "<e:note>b</e:note></rdf:Description>\n"));
  EXPECT_THAT(
      read,
      ElementsAre(
          "DataPropertyAssertion(:note :a \"<x:b xmlns:x=\"http://x/\"><x:c></x:c></x:b><e:d xmlns:e=\"http://e/\">"
          "<e:f></e:f></e:d>\"^^rdf:XMLLiteral)",
          "DataPropertyAssertion(:note :a \"b\")"));
}

}  // namespace
}  // namespace geminga::rdf
