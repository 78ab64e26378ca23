// Hostile and damaged files.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/random.hpp"
#include "reasoning/syntax/functional/reading.hpp"

namespace geminga::functional {
namespace {

using testing::StartsWith;

TEST(Hostile, NulIsRefusedWithItsLineWhereverItStands) {
  for (const std::string_view place : {"<http://e/%>", ":A%", "\"%\"", "#%", "%"}) {
    std::string lines = "\nAnnotationAssertion(rdfs:comment :A " + std::string(place) + ")";
    lines.replace(lines.find('%'), 1, std::string_view("\0", 1));
    EXPECT_EQ(Reading(ontology(lines)).error, "t.ofn:3: a NUL byte") << place;
  }
}

TEST(Hostile, BadUtf8IsRefusedWithItsLineWhereverItStands) {
  const std::string padding(50, ' ');  // past the words that are looked at as a whole
  for (const char* bytes :
       {"\xff", "\xc3", "\xc0\x80", "\xe2\x82", "\xed\xa0\x80", "\xf4\x90\x80\x80", "\x80", "\xf8\x88\x80\x80\x80"}) {
    const std::string text = "Ontology(\n" + padding + "# " + bytes + "\n)" + padding;
    EXPECT_EQ(Reading(text).error, "t.ofn:2: bytes that are no UTF-8: save the file as UTF-8");
    EXPECT_EQ(Reading(std::string("Ontology()#") + bytes).error,
              "t.ofn:1: bytes that are no UTF-8: save the file as UTF-8");
  }
  EXPECT_EQ(Reading("Ontology()#é€𝒜").error, "");
}

TEST(Hostile, EndlessNestingIsRefusedAtTheLimit) {
  std::string open = "Prefix(:=<http://e/>)\nOntology(SubClassOf(:A ";
  for (int i = 0; i < 200'000; ++i) open += "ObjectComplementOf(";
  EXPECT_EQ(Reading(open).error, "t.ofn:2: more than 512 levels of nesting");
  std::string annotations = "Ontology(\n";
  for (int i = 0; i < 200'000; ++i) annotations += "Annotation(";
  EXPECT_EQ(Reading(annotations).error, "t.ofn:2: more than 512 levels of nesting");
}

TEST(Hostile, WhatIsSkippedMayNestWithoutEnd) {
  const std::string rule = "DGRule(" + std::string(1'000'000, '(') + std::string(1'000'000, ')') + ")";
  EXPECT_EQ(Reading(ontology(rule)).error, "");
  EXPECT_THAT(Reading(ontology("DGRule(" + std::string(1'000'000, '('))).error, StartsWith("t.ofn:4: expected ')'"));
}

TEST(Hostile, QuotesWithoutEndCostOnePassEach) {
  // A careless reader would take quadratic time for each of these.
  std::string escapes = "Ontology(Annotation(rdfs:comment \"";
  for (int i = 0; i < 1'000'000; ++i) escapes += "\\\"";
  EXPECT_THAT(Reading(escapes).error, StartsWith("t.ofn:1: a text that is never closed"));
  EXPECT_THAT(Reading("Ontology(\n" + std::string(4'000'000, '<')).error, StartsWith("t.ofn:2: an IRI with"));
  EXPECT_THAT(Reading("Ontology(\n<" + std::string(4'000'000, 'a')).error, StartsWith("t.ofn:2: an IRI of more than"));
  EXPECT_EQ(
      Reading("Ontology()" + std::string(4'000'000, '\n') + "x").error,
      "t.ofn:4000001: expected the end of the file behind the ontology, found x, which is no word of this syntax");
}

TEST(Hostile, ErrorsAreOneShortLineOfUtf8) {
  const std::string long_word(5000, 'x');
  const std::vector<std::string> texts = {"Ontology(" + long_word, "Ontology(\x1b[31m", "Ontology(<\n>", "\x01"};
  for (const std::string& text : texts) {
    const std::string error = Reading(text).error;
    EXPECT_THAT(error, StartsWith("t.ofn:1: "));
    EXPECT_LT(error.size(), 200U);
    for (const char c : error) EXPECT_GE(static_cast<unsigned char>(c), 0x20U);
  }
}

const std::string sample = ontology(
    "Import(<http://x>) Annotation(rdfs:comment \"c \\\" d\"@en-GB)\nDeclaration(Annotation(:n _:b) Class(:A))\n"
    "SubClassOf(:A ObjectIntersectionOf(:B ObjectSomeValuesFrom(ObjectInverseOf(:p) ObjectMinCardinality(2 :q :C))))\n"
    "SubObjectPropertyOf(ObjectPropertyChain(:p :q) :r) # comment\nHasKey(:A (:p) (:d))\n"
    "DataPropertyRange(:d DatatypeRestriction(xsd:int xsd:minInclusive \"1\"^^xsd:int))\n"
    "SubClassOf(:A DataSomeValuesFrom(:d :e xsd:int)) ClassAssertion(:A _:b1)\n"
    "AnnotationAssertion(rdfs:label :Bälle \"Bälle\") DLSafeRule(Body()Head())\n");

TEST(Hostile, ATruncatedFileIsRefused) {
  ASSERT_EQ(Reading(sample).error, "");
  const std::size_t end = sample.rfind(')');
  for (std::size_t size = 0; size <= end; ++size)
    EXPECT_THAT(Reading(std::string_view(sample).substr(0, size)).error, StartsWith("t.ofn:")) << size;
}

TEST(Hostile, ABentFileIsReadOrRefusedWithALine) {
  constexpr std::uint64_t seeds = 3000;
  static constexpr std::string_view likely = "()<>\":=^@_\\# \nAaOo0";
  std::size_t refused = 0;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    base::Random random(seed);
    std::string bent = sample;
    for (auto edits = 1 + random.below(4); edits > 0; --edits) {
      const auto place = static_cast<std::size_t>(random.below(bent.size()));
      const char byte = random.below(4) == 0 ? static_cast<char>(random.next())
                                             : likely[static_cast<std::size_t>(random.below(likely.size()))];
      switch (random.below(3)) {
        case 0:
          bent[place] = byte;
          break;
        case 1:
          bent.insert(place, 1, byte);
          break;
        default:
          bent.erase(place, 1 + static_cast<std::size_t>(random.below(20)));
      }
    }
    const std::string error =
        Reading(bent, seed % 2 == 0 ? FunctionalLimits() : FunctionalLimits{.wrong_axioms = 0}).error;
    if (error.empty()) continue;
    ++refused;
    EXPECT_THAT(error, StartsWith("t.ofn:")) << "seed " << seed;
    EXPECT_NE(error.substr(6, 1), " ") << "seed " << seed << ": " << error;
  }
  EXPECT_GT(refused, seeds / 3);
  EXPECT_LT(refused, seeds);
}

}  // namespace
}  // namespace geminga::functional
