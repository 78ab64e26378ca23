// Names, literals and comments to the letter of the specification.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reasoning/syntax/document/head.hpp"
#include "reasoning/syntax/functional/reading.hpp"

namespace geminga::functional {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// The IRI that a name stands for, or the error.
std::string iri_of(const std::string& name) {
  const Reading reading(
      "Prefix(:=<http://e/>)Prefix(a.b-c:=<http://x/#>)Prefix(é:=<urn:é:>)Ontology(Declaration(Class(" + name + ")))");
  if (!reading.error.empty()) return reading.error;
  return std::string(reading.source.name_of(reading.source.axiom(0).arguments[0]));
}

TEST(Names, AreFullOrHaveAPrefix) {
  EXPECT_EQ(iri_of("<http://e/A>"), "http://e/A");
  EXPECT_EQ(iri_of("< http://e/A>").substr(0, 9), "t.ofn:1: ");
  EXPECT_EQ(iri_of(":A"), "http://e/A");
  EXPECT_EQ(iri_of(":"), "http://e/");
  EXPECT_EQ(iri_of("a.b-c:d.e-f_1"), "http://x/#d.e-f_1");
  EXPECT_EQ(iri_of(":1.0"), "http://e/1.0");
  EXPECT_EQ(iri_of("owl:Thing"), "http://www.w3.org/2002/07/owl#Thing");
}

TEST(Names, MayBeInAnyScript) {
  EXPECT_EQ(iri_of("é:Bälle"), "urn:é:Bälle");
  EXPECT_EQ(iri_of(":球"), "http://e/球");
  EXPECT_EQ(iri_of(":𝒜"), "http://e/𝒜");
  EXPECT_EQ(iri_of("<http://e/ü?#>"), "http://e/ü?#");
}

TEST(Names, HoldNoBlankOfAnyScript) {
  EXPECT_THAT(iri_of(":A\u00a0"), HasSubstr("t.ofn:1: unexpected '\u00a0'"));
  EXPECT_THAT(iri_of(":\u3000A"), HasSubstr("t.ofn:1: unexpected '\u3000'"));
}

TEST(Names, MayEscapeAndHoldColonsAsInSparql) {
  EXPECT_EQ(iri_of(":a:b"), "http://e/a:b");
  EXPECT_EQ(iri_of(":%41b"), "http://e/%41b");
  EXPECT_EQ(iri_of(R"(:a\/b\(c\))"), "http://e/a/b(c)");
  EXPECT_THAT(iri_of(":%4"), HasSubstr("unexpected '%'"));
  EXPECT_THAT(iri_of(R"(:a\n)"), HasSubstr("unexpected '\\'"));
}

TEST(Names, AreRefusedWhereTheyCannotBeIris) {
  EXPECT_EQ(iri_of("<>"), "t.ofn:1: expected an IRI, found <>");
  EXPECT_THAT(iri_of("<http://e/ A>"), HasSubstr("an IRI with a space, control character or '<' in it: <http://e/"));
  EXPECT_THAT(iri_of("<http://e/\nA>"), HasSubstr("an IRI with a space"));
  EXPECT_THAT(iri_of("<http://e/<A>"), HasSubstr("an IRI with a space"));
  EXPECT_THAT(iri_of("<http://e/\x7f>"), HasSubstr("an IRI with a space"));
  EXPECT_EQ(iri_of("A"), "t.ofn:1: expected an IRI, found A, which is no word of this syntax");
  EXPECT_EQ(iri_of("_:x"), "t.ofn:1: expected an IRI, found _:x");
  EXPECT_EQ(iri_of("7"), "t.ofn:1: expected an IRI, found 7");
  EXPECT_EQ(iri_of("\"A\""), "t.ofn:1: expected an IRI, found a text");
  EXPECT_EQ(Reading("Prefix(e:=<>) Ontology(Declaration(Class(e:)))").error,
            "t.ofn:1: a name that stands for an empty IRI");
}

/// The literal of an assertion as the writer writes it, or the error.
std::string literal(const std::string& text) {
  const Reading reading(ontology("DataPropertyAssertion(:d :i " + text + ")"));
  if (!reading.error.empty()) return reading.error;
  const std::string axiom = reading.axioms().at(0);
  return axiom.substr(28, axiom.size() - 29);
}

TEST(Literals, HaveALanguageOrADatatypeOrAreStrings) {
  EXPECT_EQ(literal("\"a\""), "\"a\"");
  EXPECT_EQ(literal("\"\""), "\"\"");
  EXPECT_EQ(literal("\"a\"^^xsd:string"), "\"a\"");
  EXPECT_EQ(literal("\"a\" ^^ <http://e/T>"), "\"a\"^^:T");
  EXPECT_EQ(literal("\"a\"@en"), "\"a\"@en");
  EXPECT_EQ(literal("\"a\"@en-GB-oxendict"), "\"a\"@en-gb-oxendict");
  EXPECT_EQ(literal("\"a\nb\tc # d\""), "\"a\nb\tc # d\"");
}

TEST(Literals, OfTypePlainLiteralAreWhatTheyAbbreviate) {
  EXPECT_EQ(literal("\"a@en-GB\"^^rdf:PlainLiteral"), "\"a\"@en-gb");
  EXPECT_EQ(literal("\"a@b@\"^^rdf:PlainLiteral"), "\"a@b\"");
  EXPECT_EQ(literal("\"a\"^^rdf:PlainLiteral"), "\"a\"");
}

TEST(Literals, WithABackslashThatEscapesNothingAreNoted) {
  const Reading reading(
      "Prefix(:=<http://e/>)Ontology(AnnotationAssertion(rdfs:label :a \"C:\\new\")\nSubClassOf(:A :B))");
  EXPECT_EQ(reading.error, "");
  EXPECT_THAT(reading.axioms(), testing::ElementsAre("SubClassOf(:A :B)"));
  ASSERT_EQ(reading.source.remarks().size(), 1U);
  EXPECT_EQ(reading.source.name(reading.source.remarks().front().construct), document::odd_backslash);
}

TEST(Literals, EscapeQuotesAndBackslashesOnly) {
  EXPECT_EQ(literal(R"("a\"b\\c\\")"), R"("a"b\c\")");
  EXPECT_EQ(literal(R"("\\\"")"), R"("\"")");
  EXPECT_EQ(literal(R"("C:\new")"), R"("C:\new")");
  EXPECT_EQ(literal("\"a\n\\é\\\\n\""), "\"a\n\\é\\n\"");
  EXPECT_EQ(literal("\"a\n\\"), "t.ofn:2: a text that is never closed by '\"'");
}

TEST(Literals, AreRefusedInTheLineInWhichTheyBegin) {
  EXPECT_EQ(Reading("Ontology(\nAnnotation(rdfs:comment \"a\n\n").error,
            "t.ofn:2: a text that is never closed by '\"'");
  EXPECT_EQ(Reading("Ontology(\nAnnotation(rdfs:comment \"a\\\"\n\n").error,
            "t.ofn:2: a text that is never closed by '\"'");
  EXPECT_EQ(literal("\"a\"@"), "t.ofn:2: a language tag that is none: @");
  EXPECT_EQ(literal("\"a\"@en-"), "t.ofn:2: a language tag that is none: @en-");
  EXPECT_EQ(literal("\"a\"@1"), "t.ofn:2: a language tag that is none: @");
  EXPECT_EQ(literal("\"a\"^xsd:int"), "t.ofn:2: a single '^'");
  EXPECT_EQ(literal("\"a\"^^\"b\""), "t.ofn:2: expected the name of a datatype behind '^^', found a text");
  EXPECT_EQ(literal("\"a\"@en^^xsd:int"), "t.ofn:2: expected ')' behind the operands, found '^^'");
}

TEST(Comments, ReachToTheEndOfTheirLineBetweenTokensOnly) {
  const Reading reading(
      "Prefix(:=<http://e/#>)#1\nOntology(#2 \"\n#3\r SubClassOf#4 (\n(#5\n:A#6\n<http://e/#B>) "
      "AnnotationAssertion(rdfs:label :A \"#7\")#8 )\n)# the end");
  ASSERT_EQ(reading.error, "");
  EXPECT_THAT(reading.axioms(), ElementsAre("SubClassOf(:#A :#B)"));
  EXPECT_THAT(reading.labels(), ElementsAre("http://e/#A #7"));
  EXPECT_EQ(reading.source.axiom(0).line, 3U);
}

TEST(Numbers, AreDigits) {
  EXPECT_EQ(Reading(ontology("SubClassOf(:A ObjectMinCardinality(-1 :p))")).error,
            "t.ofn:2: expected a number, found -1, which is no word of this syntax");
  EXPECT_EQ(Reading(ontology("SubClassOf(:A ObjectMinCardinality(:p :B))")).error,
            "t.ofn:2: expected a number, found :p");
  const Reading big(ontology("SubClassOf(:A ObjectMinCardinality(000 :p)) SubClassOf(:A ObjectMinCardinality(" +
                             std::string(1000, '9') + " :p))"));
  ASSERT_EQ(big.error, "");
  EXPECT_THAT(big.axioms(), ElementsAre("SubClassOf(:A ObjectMinCardinality(0 :p))",
                                        "left out: a cardinality above 4294967295, 1, line 2"));
}

}  // namespace
}  // namespace geminga::functional
