// The parts of a file beside its axioms: head, annotations, lines, counts and omissions.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reasoning/owl/loaded_file.hpp"
#include "reasoning/owl/unit.hpp"
#include "reasoning/syntax/functional/reading.hpp"
#include "reasoning/syntax/rdf/functional.hpp"

namespace geminga::functional {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

TEST(Document, NamesItsOntologyItsVersionItsImportsAndItsPrefixes) {
  const Reading reading(
      "Prefix(:=<http://e/>)\nPrefix(rdfs:=<http://www.w3.org/2000/01/rdf-schema#>)\n"
      "Prefix( b\n: = <http://b/#> )\nPrefix(b:=<http://b/#>)\n"
      "Ontology(<http://e> b:1\nImport(<http://x>)\nImport(b:y)\nImport(<http://x>)\n"
      "Annotation(rdfs:comment \"c\")\nSubClassOf(:A :B))");
  EXPECT_THAT(reading.error, HasSubstr("t.ofn:3: expected a prefix that ends in a colon, found b"));
  const Reading good(
      "Prefix(:=<http://e/>)\nPrefix(rdfs:=<http://www.w3.org/2000/01/rdf-schema#>)\n"
      "Prefix( b: = <http://b/#> )\nPrefix(b:=<http://b/#>)\n"
      "Ontology(<http://e> b:1\nImport(<http://x>)\nImport(b:y)\nImport(<http://x>)\n"
      "Annotation(rdfs:comment \"c\")\nSubClassOf(:A :B))");
  ASSERT_EQ(good.error, "");
  EXPECT_EQ(good.document.ontology_iri, "http://e");
  EXPECT_EQ(good.source.files()[0].ontology_iri, "http://e");
  EXPECT_EQ(good.document.version_iri, "http://b/#1");
  ASSERT_EQ(good.document.imports.size(), 2U);
  EXPECT_EQ(good.document.imports[0].iri, "http://x");
  EXPECT_EQ(good.document.imports[0].line, 6U);
  EXPECT_EQ(good.document.imports[1].iri, "http://b/#y");
  ASSERT_EQ(good.document.prefixes.size(), 3U);
  EXPECT_EQ(good.document.prefixes[0].prefix, "");
  EXPECT_EQ(good.document.prefixes[1].prefix, "rdfs");
  EXPECT_EQ(good.document.prefixes[2].prefix, "b");
  EXPECT_EQ(good.document.prefixes[2].iri, "http://b/#");
  EXPECT_TRUE(good.source.prefixes().empty());
}

TEST(Document, MayHoldNothing) {
  for (const char* text : {"Ontology()", " Ontology ( ) ", "# a comment\r\nOntology(<http://e>)# another"}) {
    const Reading reading(text);
    EXPECT_EQ(reading.error, "") << text;
    EXPECT_THAT(reading.axioms(), IsEmpty()) << text;
  }
}

TEST(Document, MayBeginWithAByteOrderMark) { EXPECT_EQ(Reading("\xef\xbb\xbfOntology()").error, ""); }

TEST(Document, KnowsFourPrefixesWithoutDeclaringThem) {
  const Reading reading("Ontology(SubClassOf(owl:Nothing owl:Thing) DataPropertyRange(<http://e/d> xsd:int))");
  ASSERT_EQ(reading.error, "");
  EXPECT_THAT(reading.axioms(), ElementsAre("SubClassOf(owl:Nothing owl:Thing)", "DataPropertyRange(:d xsd:int)"));
  EXPECT_TRUE(reading.document.prefixes.empty());
}

TEST(Document, IsRefusedWhereAPrefixMeansTwoThings) {
  EXPECT_EQ(Reading("Prefix(a:=<http://e/>)\nPrefix(a:=<http://f/>)\nOntology()").error,
            "t.ofn:2: the prefix a: already stands for <http://e/>");
  EXPECT_EQ(Reading("Prefix(owl:=<http://e/>) Ontology()").error,
            "t.ofn:1: the prefix owl: already stands for <http://www.w3.org/2002/07/owl#>");
  EXPECT_EQ(Reading("Ontology(\n\nDeclaration(Class(b:A)))").error, "t.ofn:3: the prefix b: is not declared");
}

TEST(Document, EndsWithItsOntology) {
  EXPECT_EQ(Reading("Ontology()\nOntology()").error,
            "t.ofn:2: holds a second ontology: put each into a file of its own");
  EXPECT_EQ(Reading("Ontology())").error, "t.ofn:1: expected the end of the file behind the ontology, found ')'");
  EXPECT_EQ(Reading("Ontology(").error,
            "t.ofn:1: expected an axiom, or ')' at the end of the ontology, found the end of the file");
  EXPECT_EQ(Reading("").error, "t.ofn:1: expected Prefix or Ontology, found the end of the file");
}

TEST(Document, LosesAWrongAxiomAndNoOther) {
  const std::vector<std::pair<std::string, std::string>> faults = {
      {"SubClasOf(:A :B)",
       "expected an axiom, or ')' at the end of the ontology, found SubClasOf, which is no word of this syntax"},
      {"SubClassOf(:A ObjectSomeValueFrom(:r :B))",
       "expected a class expression, found ObjectSomeValueFrom, which is no word of this syntax"},
      {"SubClassOf(:A)", "expected a class expression, found ')'"},
      {"SubClassOf(:A :B :C)", "expected ')' behind the operands, found :C"},
      {"SubClassOf(Annotation(:n) :A :B)", "expected an IRI, a blank node or a literal, found ')'"},
      {"SubClassOf(:A b:B)", "the prefix b: is not declared"},
      {"SubClassOf(:A ObjectSomeValuesFrom(:r :B)", "expected ')' behind the operands, found Declaration"},
      {"Annotation(:n)", "expected an IRI, a blank node or a literal, found ')'"},
  };
  for (const auto& [wrong, fault] : faults) {
    const Reading reading(ontology("SubClassOf(:C :D)\n" + wrong + "\nDeclaration(Class(:E))"), FunctionalLimits());
    ASSERT_EQ(reading.error, "") << wrong;
    const std::string line = fault.ends_with("found Declaration") ? "4" : "3";
    EXPECT_THAT(reading.axioms(),
                ElementsAre("SubClassOf(:C :D)", "Declaration(:E)",
                            "left out: an axiom that cannot be read (" + fault + "), 1, line " + line))
        << wrong;
  }
}

TEST(Document, IsRefusedWhereTheEndOfAWrongAxiomIsNotKnown) {
  for (const char* const wrong :
       {"SubClassOf(:A", "SubClassOf(:A :B) :A", "SubClassOf(:A :B))", "SubClassOf(:A \"b)", "Import(:A :B)"})
    EXPECT_THAT(Reading(ontology(wrong), FunctionalLimits()).error, StartsWith("t.ofn:")) << wrong;
}

TEST(Document, GivesEveryAxiomTheLineInWhichItBegins) {
  const Reading reading(
      "Prefix(:=<http://e/>)\nOntology(\n# a comment\nSubClassOf(:A\n  :B)  SubClassOf(:B :C)\r\n"
      "AnnotationAssertion(rdfs:comment :A \"two\nlines\")\nEquivalentClasses\n(\n:A ObjectUnionOf(\n:B :C))\n)");
  ASSERT_EQ(reading.error, "");
  ASSERT_EQ(reading.source.axiom_count(), 3U);
  EXPECT_EQ(reading.source.axiom(0).line, 4U);
  EXPECT_EQ(reading.source.axiom(1).line, 5U);
  EXPECT_EQ(reading.source.axiom(2).line, 8U);
  EXPECT_EQ(reading.source.axiom(2).file, owl::FileId{0});
}

TEST(Document, DeclaresAnEntityOnce) {
  const Reading reading(ontology("Declaration(Class(:A))\nDeclaration(Class(:A))\nDeclaration(NamedIndividual(:A))"));
  ASSERT_EQ(reading.error, "");
  EXPECT_THAT(reading.axioms(), ElementsAre("Declaration(:A)", "Declaration(:A)"));
  EXPECT_EQ(reading.source.kind(reading.source.axiom(0).arguments[0]), owl::TermKind::named_class);
  EXPECT_EQ(reading.source.kind(reading.source.axiom(1).arguments[0]), owl::TermKind::individual);
}

TEST(Document, CollectsConversionsWithTheirCosts) {
  const Reading reading(
      "Prefix(:=<http://e/>) Prefix(g:=<https://geminga.example/core#>) Ontology(<http://e>\n"
      "AnnotationAssertion(g:convertsTo :A :B)\n"
      "AnnotationAssertion(Annotation(g:conversionCost \"7\"^^xsd:integer) g:convertsTo :A <http://e/C>)\n"
      "AnnotationAssertion(g:convertsTo :B :A)\nAnnotationAssertion(g:convertsTo _:b :A)\n"
      "AnnotationAssertion(g:convertsTo :A _:b)\nAnnotationAssertion(g:convertsTo :A \"x\")\n"
      "SubClassOf(Annotation(g:conversionCost \"3\") :A :B)\nAnnotationAssertion(g:convertsTo :C :A))");
  ASSERT_EQ(reading.error, "");
  EXPECT_THAT(rdf::conversions(reading.source),
              ElementsAre("http://e/A > http://e/B 1, line 2", "http://e/A > http://e/C 7, line 3",
                          "http://e/B > http://e/A 1, line 4", "http://e/C > http://e/A 1, line 9"));
  ASSERT_EQ(reading.source.omissions().size(), 2U) << "what has no name, and a literal";
  EXPECT_EQ(reading.source.omissions()[0].line, 5U);
  EXPECT_EQ(reading.source.omissions()[0].count, 2U);
  EXPECT_EQ(reading.source.omissions()[1].line, 7U);
}

TEST(Document, NamesAConversionOfNoCostWhereItStands) {
  const Reading reading(
      "Prefix(:=<http://e/>) Prefix(g:=<https://geminga.example/core#>) Ontology(<http://e>\n"
      "AnnotationAssertion(\nAnnotation(g:conversionCost\n\"0\"^^xsd:integer)\ng:convertsTo :A :B))");
  ASSERT_EQ(reading.error, "");
  ASSERT_EQ(reading.source.omissions().size(), 1U);
  EXPECT_EQ(reading.source.omissions()[0].line, 4U);
}

TEST(Document, HasUnitsWhetherTheirPropertiesAreAnnotationsOrNot) {
  const Reading reading(
      "Prefix(:=<http://e/>) Prefix(q:=<http://qudt.org/schema/qudt/>) Ontology(<http://e>\n"
      "DataPropertyAssertion(q:conversionMultiplier :Pitch \"105\"^^xsd:decimal)\n"
      "ObjectPropertyAssertion(q:hasDimensionVector :Pitch <http://v/A0E0L1I0M0H0T0D0>)\n"
      "AnnotationAssertion(q:symbol :Pitch \"pitch\")\n"
      "AnnotationAssertion(q:conversionMultiplier :Rod \"5\")\nAnnotationAssertion(q:conversionMultiplier _:b \"5\")\n"
      "AnnotationAssertion(q:hasDimensionVector :Rod <http://v/A0E0L1I0M0H0T0D0>)\n"
      "ClassAssertion(q:Unit :Empty) NegativeDataPropertyAssertion(q:conversionMultiplier :Pitch \"1\"^^xsd:decimal))");
  ASSERT_EQ(reading.error, "");
  EXPECT_THAT(rdf::unit_names(reading.source), ElementsAre("http://e/Pitch 105", "http://e/Rod 5", "pitch 105"));
  ASSERT_EQ(owl::units_of(reading.source).left_out.size(), 1U);
  EXPECT_THAT(owl::units_of(reading.source).left_out[0].first, testing::EndsWith(":8"));
}

TEST(Document, CollectsLabels) {
  const Reading reading(
      "Prefix(:=<http://e/>) Prefix(skos:=<http://www.w3.org/2004/02/skos/core#>) Ontology(<http://e>\n"
      "Annotation(rdfs:label \"the ontology\")\n"
      "AnnotationAssertion(rdfs:label :A \"ball\")\nAnnotationAssertion(skos:prefLabel :A \"Ball\"@de-CH)\n"
      "AnnotationAssertion(Annotation(rdfs:label \"no\") rdfs:label <http://e/B> \"an \\\"x\\\" \\\\\"^^xsd:string)\n"
      "AnnotationAssertion(rdfs:comment :A \"no\")\nAnnotationAssertion(rdfs:label _:b \"no\")\n"
      "AnnotationAssertion(<https://geminga.example/core#dnsServiceType> :B \"_b._tcp\")\n"
      "AnnotationAssertion(rdfs:label :A :B)\nSubClassOf(Annotation(rdfs:label \"no\") :A :B))");
  ASSERT_EQ(reading.error, "");
  EXPECT_THAT(reading.labels(),
              ElementsAre("http://e/A ball", "http://e/A Ball@de-ch", "http://e/B an \"x\" \\", "http://e/B _b._tcp"));
  EXPECT_EQ(reading.document.annotations, 10U);
  EXPECT_EQ(reading.document.axioms, 1U);
}

TEST(Document, TellsBlankNodesOfDifferentFilesApart) {
  owl::Ontology source;
  const std::string first = ontology("ClassAssertion(:A _:x) ClassAssertion(:B _:x)");
  const std::string second = ontology("ClassAssertion(:C _:x)");
  ASSERT_TRUE(read(first, source.add_file("a.ofn"), source));
  ASSERT_TRUE(read(second, source.add_file("b.ofn"), source));
  ASSERT_EQ(source.axiom_count(), 3U);
  EXPECT_EQ(source.axiom(0).arguments[1], source.axiom(1).arguments[1]);
  EXPECT_NE(source.axiom(0).arguments[1], source.axiom(2).arguments[1]);
  EXPECT_THAT(std::string(source.name_of(source.axiom(0).arguments[1])), StartsWith("_:"));
}

TEST(Document, LeavesOutByNameWhatNoTermCanExpress) {
  const Reading reading(
      ontology("SubClassOf(:A DataSomeValuesFrom(:d :e xsd:int))\nSubClassOf(:A :B)\n"
               "SubClassOf(:A ObjectUnionOf(:B DataAllValuesFrom(:d :e :f DataUnionOf(xsd:int xsd:byte))))\n"
               "SubClassOf(:A ObjectMinCardinality(4294967296 :p))\n"
               "DLSafeRule(Annotation(:n \")\") Body(ClassAtom(:A Variable(<urn:x>)))Head(SameAsAtom(:i :i) "
               "DifferentFromAtom(:i :j) ClassAtom(:B Variable(<urn:x>))))\n"
               "DGRule(Body()Head())\nDescriptionGraph(:g Nodes() Edges() MainClasses())\nHasKey(:A () ())"));
  ASSERT_EQ(reading.error, "");
  EXPECT_THAT(
      reading.axioms(),
      ElementsAre(
          "SubClassOf(:A :B)",
          "DLSafeRule(Atoms(ClassAtom(:A ?<urn:x>)) Atoms(SameIndividualAtom(:i :i) DifferentIndividualsAtom(:i :j) "
          "ClassAtom(:B ?<urn:x>)))",
          "left out: owl:onProperties, 2, line 2", "left out: a cardinality above 4294967295, 1, line 5",
          "left out: DGRule, 1, line 7", "left out: DescriptionGraph, 1, line 8",
          "left out: malformed HasKey, 1, line 9"));
  EXPECT_EQ(reading.document.axioms, 2U);
}

TEST(Document, ReadsOneOperandWhereTwoAreWantedAsWhatItSays) {
  const Reading reading(ontology(
      "SubClassOf(ObjectIntersectionOf(:A) ObjectUnionOf(:B))\nSubObjectPropertyOf(ObjectPropertyChain(:p) :q)\n"
      "DataPropertyRange(:d DataUnionOf(DataIntersectionOf(xsd:int)))\nSubClassOf(ObjectOneOf(:i) :A)\n"
      "DisjointUnion(:A :B)\nEquivalentClasses(:A) DisjointClasses(:A) DifferentIndividuals(:i)"));
  ASSERT_EQ(reading.error, "");
  EXPECT_THAT(reading.axioms(),
              ElementsAre("SubClassOf(:A :B)", "SubObjectPropertyOf(:p :q)", "DataPropertyRange(:d xsd:int)",
                          "SubClassOf(ObjectOneOf(:i) :A)", "DisjointUnion(:A :B)"));
  EXPECT_EQ(reading.document.vacuous, 3U);
  EXPECT_EQ(reading.document.axioms, 5U);
}

TEST(Document, HasExpressionsWithoutOperandsThatMeanWhatTheyMean) {
  const Reading reading(ontology(
      "SubClassOf(:A ObjectIntersectionOf())\nSubClassOf(:A ObjectUnionOf())\nSubClassOf(:A ObjectOneOf())\n"
      "DataPropertyRange(:d DataOneOf())\nDataPropertyRange(:d DataIntersectionOf())\n"
      "DatatypeDefinition(:T DatatypeRestriction(xsd:int))\nDisjointUnion(:C)\nDisjointClasses() EquivalentClasses()"));
  ASSERT_EQ(reading.error, "");
  EXPECT_THAT(reading.axioms(),
              ElementsAre("SubClassOf(:A owl:Thing)", "SubClassOf(:A owl:Nothing)", "SubClassOf(:A owl:Nothing)",
                          "DataPropertyRange(:d DataComplementOf(rdfs:Literal))", "DataPropertyRange(:d rdfs:Literal)",
                          "DatatypeDefinition(:T xsd:int)", "EquivalentClasses(:C owl:Nothing)"));
  EXPECT_EQ(reading.document.vacuous, 2U);
  EXPECT_EQ(reading.source.remarks().size(), 8U) << "an empty union and an empty enumeration are two remarks";
  EXPECT_EQ(Reading(ontology("SubObjectPropertyOf(ObjectPropertyChain() :p)")).error,
            "t.ofn:2: expected an object property, found ')'")
      << "the identity, which OWL has not";
}

TEST(Document, MayImportAndAnnotateBetweenAxioms) {
  const Reading reading(
      ontology("SubClassOf(:A :B)\nImport(<http://x>)\nAnnotation(rdfs:comment \"c\")\nSubClassOf(:B :C)"));
  EXPECT_EQ(reading.error, "");
  EXPECT_EQ(reading.document.imports.size(), 1U);
  EXPECT_EQ(reading.document.axioms, 2U);
}

}  // namespace
}  // namespace geminga::functional
