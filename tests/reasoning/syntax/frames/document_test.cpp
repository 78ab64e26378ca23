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

TEST(Document, IsRefusedWithTheLineAndWhatWasExpected) {
  const auto refusal = [](std::string_view lines) { return Reading(ontology(lines)).error; };
  EXPECT_EQ(refusal("Class: A\nSubClassOf: B,"),
            "t.omn:4: expected a class, a property, 'not', 'inverse', '(' or '{', "
            "found the end");
  EXPECT_EQ(refusal("\nClass: x:A"), "t.omn:3: the prefix x: is not declared");
  EXPECT_EQ(refusal("Class: 'a label'"),
            "t.omn:2: names in single quotation marks are not read in documents: write prefix:Name");
  EXPECT_EQ(refusal("ObjectProperty: p Characteristics: Transient"),
            "t.omn:2: expected Functional, InverseFunctional, Reflexive, Irreflexive, Symmetric, Asymmetric or "
            "Transitive, found 'Transient'");
  EXPECT_EQ(refusal("DataProperty: d Characteristics: Transitive"), "t.omn:2: expected Functional, found 'Transitive'");
  EXPECT_EQ(refusal("Class: A Domain: B"),
            "t.omn:2: expected a frame like Class:, an axiom like DisjointClasses:, or the end, found 'Domain:'");
  EXPECT_EQ(refusal("Class: A SubClasOf: B"),
            "t.omn:2: expected a frame like Class:, an axiom like DisjointClasses:, or the end, found 'SubClasOf:'");
  EXPECT_EQ(refusal("Individual: a Facts: p \"x\"@1"), "t.omn:2: a language tag that is none: @1");
  EXPECT_EQ(refusal("Class: A SubClassOf: p some \"x"), "t.omn:2: a text that begins with \" does not end");
  EXPECT_EQ(Reading("Class: A").error, "t.omn:1: expected Prefix: or Ontology:, found 'Class:'");
  EXPECT_EQ(Reading("Ontology: Class: A").error, "t.omn:1: 'A' has no prefix, and no default one is declared");
  EXPECT_EQ(Reading("Prefix: a: <http://a/>\nPrefix: a: <http://b/>\nOntology:").error,
            "t.omn:2: the prefix a: already stands for <http://a/>");
  EXPECT_EQ(Reading("Prefix: a <http://a/>\nOntology:").error,
            "t.omn:1: expected a prefix that ends in a colon, found 'a'");
}

}  // namespace
}  // namespace geminga::frames
