// The head of a document, its annotations and omissions, and the lines of all.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reasoning/owl/loaded_file.hpp"
#include "reasoning/syntax/frames/reading.hpp"

namespace geminga::frames {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(Document, NamesItsOntologyItsVersionItsImportsAndItsPrefixes) {
  const Reading reading(
      "\xef\xbb\xbf# a comment\nPrefix: : <http://e/>\nPrefix: oeo: <http://oeo/>\nPrefix: oeo: <http://oeo/>\n\n"
      "Ontology: <http://e> <http://e/1> # another\n\nImport: <http://x>\nImport: oeo:y\nImport: <http://x>\n"
      "Annotations: rdfs:comment \"c\"\nImport: <http://z>\nClass: A\n");
  ASSERT_EQ(reading.error, "");
  EXPECT_EQ(reading.document.ontology_iri, "http://e");
  EXPECT_EQ(reading.source.files()[0].ontology_iri, "http://e");
  EXPECT_EQ(reading.document.version_iri, "http://e/1");
  ASSERT_EQ(reading.document.imports.size(), 3U);
  EXPECT_EQ(reading.document.imports[1].iri, "http://oeo/y");
  EXPECT_EQ(reading.document.imports[1].line, 9U);
  ASSERT_EQ(reading.document.prefixes.size(), 2U);
  EXPECT_EQ(reading.document.prefixes[0].prefix, "");
  EXPECT_EQ(reading.document.prefixes[1].prefix, "oeo");
  EXPECT_EQ(reading.document.axioms, 1U);
}

TEST(Document, MayDeclareAWordOfFramesAsAPrefix) {
  EXPECT_THAT(Reading("Prefix: Annotations: <http://a/>\nPrefix: Class: <http://c/>\nOntology:\n"
                      "Class: Class:A\nSubClassOf: Annotations:B")
                  .axioms(),
              testing::Contains("SubClassOf(<http://c/A> <http://a/B>)"));
}

TEST(Document, MayHoldNothing) {
  for (const char* text : {"Ontology:", "Ontology: <http://e/>\n# a comment"}) {
    const Reading reading(text);
    EXPECT_EQ(reading.error, "") << text;
    EXPECT_THAT(reading.axioms(), IsEmpty()) << text;
  }
}

TEST(Document, GivesEachAxiomTheLineOfItsMember) {
  const Reading reading(ontology("Class: A\n  SubClassOf:\n    B,\n    # a comment\n    C\nDisjointClasses:\n  A, B"));
  std::vector<std::uint32_t> lines;
  for (std::size_t number = 0; number < reading.source.axiom_count(); ++number)
    lines.push_back(reading.source.axiom(number).line);
  EXPECT_THAT(lines, ElementsAre(2, 4, 6, 7));
}

TEST(Document, ReadsNamesInAllTheirForms) {
  EXPECT_THAT(
      said("Class: <http://f/A> SubClassOf: :B, B, owl:Thing, :B-1.x, <urn:c#d>"),
      ElementsAre("SubClassOf(<http://f/A> :B)", "SubClassOf(<http://f/A> :B)", "SubClassOf(<http://f/A> owl:Thing)",
                  "SubClassOf(<http://f/A> :B-1.x)", "SubClassOf(<http://f/A> <urn:c#d>)"));
}

/// The one thing that a document leaves out.
std::string left_out(std::string_view lines) {
  for (const std::string& line : said(lines)) {
    if (line.starts_with("left out: ")) return line;
  }
  return {};
}

TEST(Document, LeavesOutASectionWithAFaultWithItsLineAndWhatWasExpected) {
  const auto fault = [](const std::string& text, int line) {
    return "left out: a section that cannot be read (" + text + "), 1, line " + std::to_string(line);
  };
  EXPECT_EQ(left_out("Class: A\nSubClassOf: B,"),
            fault("expected a class, a property, 'not', 'inverse', '(' or '{', found the end", 4));
  EXPECT_EQ(left_out("ObjectProperty: p Characteristics: Transient"),
            fault("expected Functional, InverseFunctional, Reflexive, Irreflexive, Symmetric, Asymmetric or "
                  "Transitive, found 'Transient'",
                  2));
  EXPECT_EQ(left_out("DataProperty: d Characteristics: Transitive"),
            fault("expected Functional, found 'Transitive'", 2));
  EXPECT_EQ(left_out("Individual: a Facts: p \"x\"@1"), fault("a language tag that is none: @1", 2));
  EXPECT_THAT(said("Class: A SubClassOf: B, and, C EquivalentTo: D\nClass: E SubClassOf: F"),
              testing::IsSupersetOf({"SubClassOf(:A :B)", "EquivalentClasses(:A :D)", "SubClassOf(:E :F)"}))
      << "all but the rest of this section is read";
}

TEST(Document, LeavesOutAFrameWithoutASubjectUpToTheNextOne) {
  const auto fault = [](const std::string& text, int line) {
    return "left out: a frame that cannot be read (" + text + "), 1, line " + std::to_string(line);
  };
  EXPECT_EQ(left_out("\nClass: x:A"), fault("the prefix x: is not declared", 3));
  EXPECT_EQ(left_out("Class: 'a label'"),
            fault("names in single quotation marks are not read in documents: write prefix:Name", 2));
  EXPECT_EQ(left_out("Class: A Domain: B"),
            fault("expected a frame like Class:, an axiom like DisjointClasses:, or the end, found 'Domain:'", 2));
  EXPECT_EQ(left_out("Class: A SubClasOf: B"),
            fault("expected a frame like Class:, an axiom like DisjointClasses:, or the end, found 'SubClasOf:'", 2));
  EXPECT_THAT(said("Class: x:A SubClassOf: B Annotations: rdfs:comment \"c\"\nClass: C SubClassOf: D"),
              testing::UnorderedElementsAre("SubClassOf(:C :D)", fault("the prefix x: is not declared", 2)));
}

TEST(Document, IsRefusedWhereItsHeadATextOrAnImportIsBroken) {
  EXPECT_EQ(Reading(ontology("Class: A SubClassOf: p some \"x")).error,
            "t.omn:2: a text that begins with \" does not end");
  EXPECT_EQ(Reading("Class: A").error, "t.omn:1: expected Prefix: or Ontology:, found 'Class:'");
  EXPECT_EQ(Reading(ontology("Import: 5")).error, "t.omn:2: expected the IRI of an ontology, found '5'");
  EXPECT_EQ(Reading("Prefix: a: <http://a/>\nPrefix: a: <http://b/>\nOntology:").error,
            "t.omn:2: the prefix a: already stands for <http://a/>");
  EXPECT_EQ(Reading("Prefix: a <http://a/>\nOntology:").error,
            "t.omn:1: expected a prefix that ends in a colon, found 'a'");
}

TEST(Document, IsRefusedWhereTooMuchIsWrong) {
  FrameLimits limits;
  limits.wrong_parts = 2;
  EXPECT_EQ(Reading(ontology("Class: x:A Class: x:B Class: C"), limits).error, "");
  EXPECT_EQ(Reading(ontology("Class: x:A Class: x:B Class: x:C"), limits).error,
            "t.omn:2: the prefix x: is not declared");
}

}  // namespace
}  // namespace geminga::frames
