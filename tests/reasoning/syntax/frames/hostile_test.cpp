// Limits at their last value and one beyond, octets that are no text, and depths beyond any stack.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reasoning/syntax/frames/reading.hpp"

namespace geminga::frames {
namespace {

using std::string_view_literals::operator""sv;
using testing::ElementsAre;
using testing::HasSubstr;

std::string times(std::size_t count, std::string_view text) {
  std::string all;
  for (std::size_t at = 0; at < count; ++at) all += text;
  return all;
}

TEST(Limits, OfNesting) {
  FrameLimits limits;
  limits.expression.nesting = 20;
  const auto nested = [&](std::size_t levels) {
    return Reading(ontology("Class: A SubClassOf: " + times(levels, "not ") + "B"), limits).error;
  };
  EXPECT_EQ(nested(19), "");
  EXPECT_EQ(nested(20), "");
  EXPECT_EQ(nested(21), "t.omn:2: more than 20 levels of nesting");
  EXPECT_THAT(Reading(ontology("Class: A SubClassOf: " + times(1'000'000, "(") + "B")).error,
              HasSubstr("more than 512 levels of nesting"));
}

TEST(Limits, OfNestedAnnotations) {
  FrameLimits limits;
  limits.annotation_levels = 3;
  const auto nested = [&](std::size_t levels) {
    return Reading(ontology("Class: A " + times(levels, "Annotations: ") + times(levels, ":n \"x\" ")), limits).error;
  };
  EXPECT_EQ(nested(2), "");
  EXPECT_EQ(nested(3), "");
  EXPECT_EQ(nested(4), "t.omn:2: more than 3 levels of annotations");
}

TEST(Limits, OfNamesTextsPrefixesImportsPartsAndTheFile) {
  FrameLimits limits;
  limits.iri_bytes = 12;
  for (const std::string_view name : {"<http://e/abc>", ":abc"})
    EXPECT_THAT(Reading(ontology("Class: " + std::string(name)), limits).axioms(),
                ElementsAre(HasSubstr("Declaration")));
  for (const std::string_view name : {"<http://e/abcd>", ":abcd"})
    EXPECT_THAT(Reading(ontology("Class: " + std::string(name)), limits).axioms(),
                ElementsAre(HasSubstr("(an IRI of more than 12 bytes), 1, line 2")));
  limits = {};
  limits.literal_bytes = 3;
  EXPECT_EQ(Reading(ontology("Individual: a Facts: d \"abc\""), limits).error, "");
  EXPECT_EQ(Reading(ontology("Individual: a Facts: d \"abcd\""), limits).error, "t.omn:2: a text of more than 3 bytes");
  limits = {};
  limits.prefixes = 1;
  EXPECT_EQ(Reading("Prefix: a: <http://a/> Ontology:", limits).error, "");
  EXPECT_EQ(Reading("Prefix: a: <http://a/>\nPrefix: b: <http://b/> Ontology:", limits).error,
            "t.omn:2: more than 1 prefixes");
  limits.imports = 1;
  EXPECT_EQ(Reading("Ontology: Import: <a:a> Import: <a:a>", limits).error, "");
  EXPECT_EQ(Reading("Ontology: Import: <a:a>\nImport: <a:b>", limits).error, "t.omn:2: more than 1 imports");
  limits = {};
  limits.expression.parts = 3;
  EXPECT_EQ(Reading(ontology("Class: A SubClassOf: B and C and D, E and F"), limits).error, "");
  EXPECT_EQ(Reading(ontology("Class: A SubClassOf: B and C and D and E"), limits).error,
            "t.omn:2: more than 3 names and values");
  limits = {};
  limits.file_bytes = 9;
  EXPECT_EQ(Reading("Ontology:", limits).error, "");
  EXPECT_EQ(Reading("Ontology: ", limits).error, "t.omn: larger than 9 bytes: split it");
}

TEST(Hostile, BytesThatAreNoTextAreRefusedWithTheirLine) {
  EXPECT_EQ(Reading("Ontology:\n\nClass: \xff").error, "t.omn:3: bytes that are no UTF-8: save the file as UTF-8");
  EXPECT_EQ(Reading("Ontology:\n\0"sv).error, "t.omn:2: a NUL byte");
  EXPECT_THAT(Reading(ontology("Class: A\x01")).axioms(),
              ElementsAre(HasSubstr("has a character that no IRI may have")));
  EXPECT_THAT(Reading(ontology("Class: <http://e/\x01>")).axioms(), ElementsAre(HasSubstr("an IRI with a control")));
  EXPECT_THAT(Reading("Prefix:").error, HasSubstr("t.omn:1: expected a prefix that ends in a colon"));
  EXPECT_THAT(Reading("Prefix: :").error, HasSubstr("t.omn:1: expected an IRI in angle brackets"));
}

}  // namespace
}  // namespace geminga::frames
