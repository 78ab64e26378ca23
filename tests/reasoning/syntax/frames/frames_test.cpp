// Each frame and each section becomes the axiom of the structural specification.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reasoning/syntax/frames/reading.hpp"
#include "reasoning/syntax/rdf/functional.hpp"

namespace geminga::frames {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(Frames, OfClasses) {
  EXPECT_THAT(said("Class: A SubClassOf: B, p some C EquivalentTo: not D DisjointWith: E DisjointUnionOf: F, G\n"
                   "HasKey: p, d DataProperty: d"),
              ElementsAre("SubClassOf(:A :B)", "SubClassOf(:A ObjectSomeValuesFrom(:p :C))",
                          "EquivalentClasses(:A ObjectComplementOf(:D))", "DisjointClasses(:A :E)",
                          "DisjointUnion(:A :F :G)", "HasKey(:A :p :d)"));
  EXPECT_THAT(said("Class: A SuperClassOf: B"), ElementsAre("SubClassOf(:B :A)"));
}

TEST(Frames, OfClassExpressionsAreGeneralInclusions) {
  EXPECT_THAT(said("Class: A and (p some B)\n SubClassOf: C"),
              ElementsAre("SubClassOf(ObjectIntersectionOf(:A ObjectSomeValuesFrom(:p :B)) :C)"));
}

TEST(Frames, OfObjectProperties) {
  EXPECT_THAT(
      said("ObjectProperty: p Domain: A, B or C Range: D SubPropertyOf: q, inverse r EquivalentTo: inverse (s)\n"
           "DisjointWith: t InverseOf: u SubPropertyChain: p o inverse q o r, q o q\n"
           "Characteristics: Functional, InverseFunctional, Reflexive, Irreflexive, Symmetric, Asymmetric, Transitive"),
      ElementsAre("ObjectPropertyDomain(:p :A)", "ObjectPropertyDomain(:p ObjectUnionOf(:B :C))",
                  "ObjectPropertyRange(:p :D)", "SubObjectPropertyOf(:p :q)",
                  "SubObjectPropertyOf(:p ObjectInverseOf(:r))", "EquivalentObjectProperties(:p ObjectInverseOf(:s))",
                  "DisjointObjectProperties(:p :t)", "InverseObjectProperties(:p :u)",
                  "SubObjectPropertyOf(ObjectPropertyChain(:p ObjectInverseOf(:q) :r) :p)",
                  "SubObjectPropertyOf(ObjectPropertyChain(:q :q) :p)", "FunctionalObjectProperty(:p)",
                  "InverseFunctionalObjectProperty(:p)", "ReflexiveObjectProperty(:p)", "IrreflexiveObjectProperty(:p)",
                  "SymmetricObjectProperty(:p)", "AsymmetricObjectProperty(:p)", "TransitiveObjectProperty(:p)"));
}

TEST(Frames, OfDataPropertiesAndDatatypes) {
  EXPECT_THAT(
      said("DataProperty: d Domain: A Range: integer[>= 5, < 10], xsd:string or {\"a\"@EN} SubPropertyOf: e\n"
           "EquivalentTo: f DisjointWith: g Characteristics: Functional\n"
           "Datatype: t EquivalentTo: string and not {\"b\"}"),
      ElementsAre("DataPropertyDomain(:d :A)",
                  "DataPropertyRange(:d DatatypeRestriction(xsd:integer xsd:minInclusive "
                  "\"5\"^^xsd:integer xsd:maxExclusive \"10\"^^xsd:integer))",
                  "DataPropertyRange(:d DataUnionOf(xsd:string DataOneOf(\"a\"@en)))", "SubDataPropertyOf(:d :e)",
                  "EquivalentDataProperties(:d :f)", "DisjointDataProperties(:d :g)", "FunctionalDataProperty(:d)",
                  "DatatypeDefinition(:t DataIntersectionOf(xsd:string DataComplementOf(DataOneOf(\"b\"))))"));
}

TEST(Frames, OfIndividuals) {
  EXPECT_THAT(
      said("Individual: a Types: A, p value b SameAs: c DifferentFrom: _:x\n"
           "Facts: p b, not p _:x, d 5, not d \"t\"\nIndividual: _:x Types: B"),
      ElementsAre("ClassAssertion(:A :a)", "ClassAssertion(ObjectHasValue(:p :b) :a)", "SameIndividual(:a :c)",
                  "DifferentIndividuals(:a _:1)", "ObjectPropertyAssertion(:p :a :b)",
                  "NegativeObjectPropertyAssertion(:p :a _:1)", "DataPropertyAssertion(:d :a \"5\"^^xsd:integer)",
                  "NegativeDataPropertyAssertion(:d :a \"t\")", "ClassAssertion(:B _:1)"));
}

TEST(Frames, OfSeveralThingsAtOnce) {
  EXPECT_THAT(said("EquivalentClasses: A, p some B, C DisjointClasses: A, B, C SameIndividual: a, b\n"
                   "DifferentIndividuals: a, b, c EquivalentProperties: p, inverse q DisjointProperties: d, e\n"
                   "DataProperty: d DataProperty: e DisjointClasses: A"),
              ElementsAre("EquivalentClasses(:A ObjectSomeValuesFrom(:p :B) :C)", "DisjointClasses(:A :B :C)",
                          "SameIndividual(:a :b)", "DifferentIndividuals(:a :b :c)",
                          "EquivalentObjectProperties(:p ObjectInverseOf(:q))", "DisjointDataProperties(:d :e)"));
}

TEST(Frames, DeclareTheirSubjectsOnceAndAnonymousOnesNot) {
  const Reading reading(
      ontology("Class: A\nClass: A SubClassOf: B\nObjectProperty: p DataProperty: d\n"
               "AnnotationProperty: n Datatype: t Individual: a Individual: _:b Class: not A"));
  ASSERT_EQ(reading.error, "");
  EXPECT_THAT(reading.axioms(),
              ElementsAre("Declaration(:A)", "SubClassOf(:A :B)", "Declaration(:p)", "Declaration(:d)",
                          "Declaration(:n)", "Declaration(:t)", "Declaration(:a)"));
}

TEST(Frames, ThatComeLaterSayOfWhichKindAPropertyIs) {
  EXPECT_THAT(said("Class: A SubClassOf: d some T, d min 2, p some T, d only (not T) HasKey: d p\n"
                   "DataProperty: d ObjectProperty: p Datatype: T"),
              ElementsAre("SubClassOf(:A DataSomeValuesFrom(:d :T))", "SubClassOf(:A DataMinCardinality(2 :d))",
                          "SubClassOf(:A ObjectSomeValuesFrom(:p :T))",
                          "SubClassOf(:A DataAllValuesFrom(:d DataComplementOf(:T)))", "HasKey(:A :p :d)"));
}

TEST(Frames, OfOtherFilesSayItToo) {
  Declared declared;
  declared.add(owl::TermKind::data_property, "http://e/d");
  const Reading reading(ontology("Class: A SubClassOf: d min 2"), {}, declared);
  EXPECT_THAT(reading.axioms(), ElementsAre("Declaration(:A)", "SubClassOf(:A DataMinCardinality(2 :d))"));
}

TEST(Frames, LetAnUndeclaredPropertyHaveTheKindOfItsValues) {
  EXPECT_THAT(
      said("Class: A SubClassOf: p some B, p some integer, p value 5, p value a, p only {true}, p only {a},\n"
           "p max 1 xsd:string, p max 1, p only (not ({\"a\"})), p Self"),
      ElementsAre("SubClassOf(:A ObjectSomeValuesFrom(:p :B))", "SubClassOf(:A DataSomeValuesFrom(:p xsd:integer))",
                  "SubClassOf(:A DataHasValue(:p \"5\"^^xsd:integer))", "SubClassOf(:A ObjectHasValue(:p :a))",
                  "SubClassOf(:A DataAllValuesFrom(:p DataOneOf(\"true\"^^xsd:boolean)))",
                  "SubClassOf(:A ObjectAllValuesFrom(:p ObjectOneOf(:a)))",
                  "SubClassOf(:A DataMaxCardinality(1 :p xsd:string))", "SubClassOf(:A ObjectMaxCardinality(1 :p))",
                  "SubClassOf(:A DataAllValuesFrom(:p DataComplementOf(DataOneOf(\"a\"))))",
                  "SubClassOf(:A ObjectHasSelf(:p))"));
}

TEST(Frames, OfListsThatAreTooShortMeanWhatTheyMean) {
  const Reading reading(
      ontology("ObjectProperty: p SubPropertyChain: q\nDataProperty: d\n"
               "Class: A SubClassOf: {}, d some {}\nDisjointClasses: A\n"));
  ASSERT_EQ(reading.error, "");
  EXPECT_THAT(reading.axioms(), ElementsAre("Declaration(:p)", "SubObjectPropertyOf(:q :p)", "Declaration(:d)",
                                            "Declaration(:A)", "SubClassOf(:A owl:Nothing)",
                                            "SubClassOf(:A DataSomeValuesFrom(:d DataComplementOf(rdfs:Literal)))"));
  ASSERT_EQ(reading.source.remarks().size(), 3U);
  EXPECT_EQ(reading.source.remarks()[0].line, 4U);
  EXPECT_EQ(reading.source.remarks()[2].line, 5U);
}

TEST(Frames, HaveConversionsWithTheirCosts) {
  const Reading reading(
      "Prefix: : <http://e/> Prefix: g: <https://geminga.example/core#> Ontology:\n"
      "AnnotationProperty: g:convertsTo\n"
      "Class: A\n  Annotations: g:convertsTo B, Annotations: g:conversionCost 7 g:convertsTo C,\n"
      "    Annotations: g:conversionCost \"8\"^^xsd:integer g:convertsTo D, g:convertsTo E, g:convertsTo _:x\n"
      "  SubClassOf: Annotations: g:convertsTo F B\nClass: B Class: C Class: D Class: E Class: F\n");
  ASSERT_EQ(reading.error, "");
  EXPECT_THAT(rdf::conversions(reading.source),
              ElementsAre("http://e/A > http://e/B 1, line 4", "http://e/A > http://e/C 7, line 4",
                          "http://e/A > http://e/D 8, line 5", "http://e/A > http://e/E 1, line 5"));
  ASSERT_EQ(reading.source.omissions().size(), 1U) << "of what has no name, and of an axiom";
  EXPECT_EQ(reading.source.omissions()[0].count, 2U);
  EXPECT_EQ(reading.source.omissions()[0].line, 5U);
}

TEST(Frames, HaveConversionsThatCannotBeOnesNamedWhereTheyStand) {
  const Reading reading(
      "Prefix: : <http://e/> Prefix: g: <https://geminga.example/core#> Ontology:\n"
      "Class: A\n  Annotations: g:convertsTo \"B\",\n    g:conversionCost 3\n");
  ASSERT_EQ(reading.error, "");
  ASSERT_EQ(reading.source.omissions().size(), 2U);
  EXPECT_EQ(reading.source.omissions()[0].line, 3U);
  EXPECT_EQ(reading.source.omissions()[1].line, 4U);
}

TEST(Frames, HaveConversionsOfNoCostNamedWhereItStands) {
  const Reading reading(
      "Prefix: : <http://e/> Prefix: g: <https://geminga.example/core#> Ontology:\nClass: B\n"
      "Class: A\n  Annotations:\n    Annotations: g:conversionCost 0\n    g:convertsTo\n      B\n");
  ASSERT_EQ(reading.error, "");
  ASSERT_EQ(reading.source.omissions().size(), 1U);
  EXPECT_EQ(reading.source.omissions()[0].line, 5U);
}

TEST(Frames, HaveUnits) {
  const Reading reading(
      "Prefix: : <http://e/> Prefix: q: <http://qudt.org/schema/qudt/> Ontology:\n"
      "AnnotationProperty: q:symbol DataProperty: q:conversionMultiplier\n"
      "AnnotationProperty: q:hasDimensionVector Class: q:Unit\n"
      "Individual: Pitch\n  Annotations: q:symbol \"pitch\", q:hasDimensionVector <http://v/A0E0L1I0M0H0T0D0>\n"
      "  Types: q:Unit Facts: q:conversionMultiplier 105\n");
  ASSERT_EQ(reading.error, "");
  EXPECT_THAT(rdf::unit_names(reading.source), ElementsAre("http://e/Pitch 105", "pitch 105"));
}

TEST(Frames, HaveAnnotationsThatMayNestAndKeepLabels) {
  const Reading reading(ontology(
      "Annotations: rdfs:comment \"of the ontology\"\n"
      "Class: A\n  Annotations: rdfs:label \"a \\\"label\\\"\"@EN, Annotations: n \"why\" n \"note\", n B, n _:x\n"
      "  SubClassOf: Annotations: rdfs:label \"of the axiom\", n 5 B,\n"
      "    Annotations: Annotations: n \"deep\" n \"inner\" C\n"
      "  Annotations:\n"
      "AnnotationProperty: n Domain: A Range: B SubPropertyOf: rdfs:comment\n"));
  ASSERT_EQ(reading.error, "");
  EXPECT_THAT(reading.axioms(),
              ElementsAre("Declaration(:A)", "SubClassOf(:A :B)", "SubClassOf(:A :C)", "Declaration(:n)"));
  EXPECT_THAT(reading.labels(), ElementsAre("http://e/A a \"label\"@en"));
  EXPECT_EQ(reading.document.annotations, 1U + 5U + 2U + 2U + 3U);
}

TEST(Frames, MayHaveABackslashThatEscapesNothing) {
  const Reading reading(
      "Prefix: : <http://e/> Ontology:\nClass: A\n  Annotations: rdfs:label \"C:\\new\"@en\n  SubClassOf: B\n");
  ASSERT_EQ(reading.error, "");
  EXPECT_EQ(reading.source.name(reading.source.labels().front().text), "C:\\new");
  ASSERT_EQ(reading.source.remarks().size(), 1U);
  EXPECT_EQ(reading.source.remarks().front().line, 3U);
}

TEST(Frames, MayHaveSectionsWithoutMembers) {
  EXPECT_THAT(said("Class: A SubClassOf: EquivalentTo: Class: B SubClassOf:"), IsEmpty());
}

TEST(Frames, LeaveOutLiteralsThatAreNotOfTheirDatatype) {
  EXPECT_THAT(said("Individual: a Facts: d \"x\"^^xsd:integer, d 5\nClass: A"),
              ElementsAre("DataPropertyAssertion(:d :a \"5\"^^xsd:integer)",
                          "left out: a literal that is not of its datatype, 1, line 2"));
}

}  // namespace
}  // namespace geminga::frames
