// Each element becomes what the structural specification says, and where it does not, the file is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reasoning/owl/annotation.hpp"
#include "reasoning/owl/loaded_file.hpp"
#include "reasoning/syntax/owlxml/reading.hpp"
#include "reasoning/syntax/rdf/functional.hpp"

namespace geminga::owlxml {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> said(std::string_view lines) {
  const Reading reading(ontology(lines));
  return reading.error.empty() ? reading.axioms() : std::vector{reading.error};
}

TEST(Elements, MayHaveTheNamespaceThatTheOntologyHas) {
  for (const char* space : {"", " xmlns='http://www.w3.org/2006/12/owl2-xml#'"}) {
    const Reading reading("<Ontology" + std::string(space) +
                          " ontologyIRI='http://e/o'><SubClassOf><Class IRI='http://e/A'/><Class IRI='http://e/B'/>"
                          "</SubClassOf></Ontology>");
    EXPECT_THAT(reading.axioms(), ElementsAre("SubClassOf(:A :B)")) << space;
    ASSERT_EQ(reading.source.remarks().size(), 1U);
    EXPECT_EQ(reading.source.name(reading.source.remarks()[0].construct),
              "an Ontology in another namespace than OWL's, read as OWL/XML");
  }
}

TEST(Elements, OfTheHead) {
  const Reading reading(
      "\xef\xbb\xbf<?xml version=\"1.0\"?>\n<!DOCTYPE Ontology [ <!ENTITY e \"http://e/\" > ]>\n"
      "<Ontology xmlns=\"http://www.w3.org/2002/07/owl#\" xml:base=\"http://e/base\"\n"
      "  xmlns:xsi=\"http://x\" xsi:schemaLocation=\"x\" ontologyIRI=\"&e;o\" versionIRI=\"&e;o/1\">\n"
      "<Prefix name=\"\" IRI=\"http://e/\"/><Prefix name=\"f\" IRI=\"http://f/\"/><Prefix name=\"f\" "
      "IRI=\"http://f/\"/>\n"
      "<Import> http://x </Import><Import>y</Import><Import>http://x</Import>\n"
      "<Annotation><AnnotationProperty abbreviatedIRI=\"rdfs:comment\"/><Literal>c</Literal></Annotation>\n"
      "<Declaration><Class IRI=\"#A\"/></Declaration>\n<Declaration><Class IRI=\"#A\"/></Declaration>\n"
      "<SubClassOf><Class abbreviatedIRI=\"f:A\"/><Class IRI=\"other\"/></SubClassOf></Ontology>");
  ASSERT_EQ(reading.error, "");
  EXPECT_EQ(reading.document.ontology_iri, "http://e/o");
  EXPECT_EQ(reading.source.files()[0].ontology_iri, "http://e/o");
  EXPECT_EQ(reading.document.version_iri, "http://e/o/1");
  ASSERT_EQ(reading.document.imports.size(), 2U);
  EXPECT_EQ(reading.document.imports[0].iri, "http://x");
  EXPECT_EQ(reading.document.imports[1].iri, "http://e/basey");
  EXPECT_EQ(reading.document.imports[1].line, 6U);
  ASSERT_EQ(reading.document.prefixes.size(), 2U);
  EXPECT_EQ(reading.document.annotations, 1U);
  EXPECT_THAT(reading.axioms(), ElementsAre("Declaration(:base#A)", "SubClassOf(<http://f/A> :baseother)"));
  EXPECT_EQ(reading.source.axiom(0).line, 8U);
}

TEST(Elements, WithoutABaseAreRelativeToTheNameOfTheOntology) {
  const Reading reading(
      "<Ontology xmlns=\"http://www.w3.org/2002/07/owl#\" ontologyIRI=\"http://e/o\"><Declaration><Class "
      "IRI=\"#A\"/></Declaration></Ontology>");
  EXPECT_THAT(reading.axioms(), ElementsAre("Declaration(:o#A)"));
}

TEST(Elements, OfConversionsKeepTheirCosts) {
  const std::string converts = "<AnnotationProperty IRI=\"https://geminga.example/core#convertsTo\"/>";
  const Reading reading(ontology(
      "<AnnotationAssertion>" + converts + "<IRI>A</IRI><IRI>B</IRI></AnnotationAssertion>\n" +
      "<AnnotationAssertion><Annotation><AnnotationProperty IRI=\"https://geminga.example/core#conversionCost\"/>" +
      "<Literal>7</Literal></Annotation>" + converts + "<IRI>A</IRI><IRI>C</IRI></AnnotationAssertion>\n" +
      "<AnnotationAssertion>" + converts + "<IRI>B</IRI><IRI>A</IRI></AnnotationAssertion>\n" +
      "<AnnotationAssertion>" + converts + "<IRI>B</IRI><Literal>A</Literal></AnnotationAssertion>\n" +
      "<AnnotationAssertion>" + converts + "<AnonymousIndividual nodeID=\"_:b\"/><IRI>A</IRI></AnnotationAssertion>"));
  ASSERT_EQ(reading.error, "");
  EXPECT_THAT(rdf::conversions(reading.source),
              ElementsAre("http://e/A > http://e/B 1, line 2", "http://e/A > http://e/C 7, line 3",
                          "http://e/B > http://e/A 1, line 4"));
  ASSERT_EQ(reading.source.omissions().size(), 2U) << "a literal, and what has no name";
  EXPECT_EQ(reading.source.omissions()[0].line, 5U);
  EXPECT_EQ(reading.source.omissions()[1].line, 6U);
}

TEST(Elements, HaveUnits) {
  const std::string property = "<AnnotationProperty IRI=\"http://qudt.org/schema/qudt/";
  const Reading reading(ontology(
      "<DataPropertyAssertion><DataProperty IRI=\"http://qudt.org/schema/qudt/conversionMultiplier\"/>"
      "<NamedIndividual IRI=\"A\"/><Literal datatypeIRI=\"http://www.w3.org/2001/XMLSchema#decimal\">105</Literal>"
      "</DataPropertyAssertion>\n<AnnotationAssertion>" +
      property +
      "hasDimensionVector\"/><IRI>A</IRI><IRI>http://v/A0E0L1I0M0H0T0D0</IRI></AnnotationAssertion>\n"
      "<AnnotationAssertion>" +
      property + "symbol\"/><IRI>A</IRI><Literal>pitch</Literal></AnnotationAssertion>"));
  ASSERT_EQ(reading.error, "");
  EXPECT_THAT(rdf::unit_names(reading.source), ElementsAre("http://e/A 105", "pitch 105"));
}

TEST(Elements, OfAnnotationsKeepLabelsAndNothingElse) {
  const Reading reading(ontology(
      "<SubClassOf><Annotation><Annotation><AnnotationProperty IRI=\"n\"/><IRI>#x</IRI></Annotation>"
      "<AnnotationProperty IRI=\"n\"/><AnonymousIndividual nodeID=\"_:b\"/></Annotation><Class IRI=\"A\"/><Class "
      "IRI=\"B\"/></SubClassOf>\n"
      "<AnnotationAssertion><AnnotationProperty abbreviatedIRI=\"rdfs:label\"/><IRI>A</IRI><Literal "
      "xml:lang=\"EN\">a &amp; b</Literal></AnnotationAssertion>\n"
      "<AnnotationAssertion><AnnotationProperty abbreviatedIRI=\"rdfs:label\"/><AbbreviatedIRI>owl:Thing"
      "</AbbreviatedIRI><Literal datatypeIRI=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#PlainLiteral\">all@en"
      "</Literal></AnnotationAssertion>\n"
      "<AnnotationAssertion><AnnotationProperty IRI=\"n\"/><AnonymousIndividual nodeID=\"_:b\"/><IRI>A</IRI>"
      "</AnnotationAssertion>\n"
      "<SubAnnotationPropertyOf><AnnotationProperty IRI=\"n\"/><AnnotationProperty IRI=\"m\"/>"
      "</SubAnnotationPropertyOf><AnnotationPropertyDomain><AnnotationProperty IRI=\"n\"/><IRI>A</IRI>"
      "</AnnotationPropertyDomain>"));
  ASSERT_EQ(reading.error, "");
  EXPECT_THAT(reading.axioms(), ElementsAre("SubClassOf(:A :B)"));
  EXPECT_THAT(reading.labels(), ElementsAre("http://e/A a & b@en", "http://www.w3.org/2002/07/owl#Thing all@en"));
  EXPECT_EQ(reading.document.annotations, 2U + 3U + 2U);
}

TEST(Elements, OfKeysListsAndCardinalities) {
  EXPECT_THAT(said("<HasKey><Class IRI='A'/><ObjectProperty IRI='p'/><DataProperty IRI='d'/></HasKey>"
                   "<EquivalentClasses><Class IRI='A'/></EquivalentClasses>"
                   "<SubClassOf><ObjectUnionOf><Class IRI='A'/></ObjectUnionOf><ObjectMinCardinality cardinality='02'>"
                   "<ObjectInverseOf><ObjectProperty IRI='p'/></ObjectInverseOf></ObjectMinCardinality></SubClassOf>"),
              ElementsAre("HasKey(:A :p :d)", "SubClassOf(:A ObjectMinCardinality(2 ObjectInverseOf(:p)))"));
}

TEST(Elements, HaveAttributesWithBlanksAroundThemAndCountsAsTheSchemaHasThem) {
  EXPECT_THAT(
      said("<SubClassOf><Class IRI=' A '/><ObjectMinCardinality cardinality=' +2 '><ObjectProperty IRI='p\n'/>"
           "</ObjectMinCardinality></SubClassOf>"
           "<SubClassOf><Class abbreviatedIRI=' owl:Thing '/><ObjectMaxCardinality cardinality='-0'>"
           "<ObjectProperty IRI='p'/></ObjectMaxCardinality></SubClassOf>"
           "<ClassAssertion><DataHasValue><DataProperty IRI='d'/><Literal datatypeIRI=' "
           "http://www.w3.org/2001/XMLSchema#int '> +5 </Literal></DataHasValue><NamedIndividual IRI='a'/>"
           "</ClassAssertion>"),
      ElementsAre("SubClassOf(:A ObjectMinCardinality(2 :p))", "SubClassOf(owl:Thing ObjectMaxCardinality(0 :p))",
                  "ClassAssertion(DataHasValue(:d \" +5 \"^^xsd:int) :a)"));
}

TEST(Elements, ThatNoAxiomCanExpressAreLeftOutByName) {
  EXPECT_THAT(
      said("<DGRule><Body>text</Body></DGRule>\n"
           "<SubClassOf><Class IRI='A'/><DataSomeValuesFrom><DataProperty IRI='d'/><DataProperty IRI='e'/>"
           "<Datatype IRI='T'/></DataSomeValuesFrom></SubClassOf>\n"
           "<SubClassOf><Class IRI='A'/><ObjectMaxCardinality cardinality='4294967296'><ObjectProperty IRI='p'/>"
           "</ObjectMaxCardinality></SubClassOf>\n"
           "<ClassAssertion><DataHasValue><DataProperty IRI='d'/><Literal "
           "datatypeIRI='http://www.w3.org/2001/XMLSchema#int'>x</Literal></DataHasValue><NamedIndividual IRI='a'/>"
           "</ClassAssertion>"),
      ElementsAre("left out: DGRule, 1, line 2", "left out: owl:onProperties, 1, line 3",
                  "left out: a cardinality above 4294967295, 1, line 4",
                  "left out: a literal that is not of its datatype, 1, line 5"));
}

TEST(Elements, OfRules) {
  EXPECT_THAT(said("<DLSafeRule><Body><ClassAtom><Class IRI='A'/><Variable IRI='x'/></ClassAtom>"
                   "<DataPropertyAtom><DataProperty IRI='d'/><Variable IRI='x'/><Variable IRI='v'/></DataPropertyAtom>"
                   "<BuiltInAtom IRI='http://www.w3.org/2003/11/swrlb#lessThan'><Variable IRI='v'/><Literal "
                   "datatypeIRI='http://www.w3.org/2001/XMLSchema#int'>5</Literal></BuiltInAtom></Body>"
                   "<Head><ObjectPropertyAtom><ObjectProperty IRI='p'/><Variable IRI='x'/><NamedIndividual IRI='a'/>"
                   "</ObjectPropertyAtom></Head></DLSafeRule>"),
              ElementsAre("DLSafeRule(Atoms(ClassAtom(:A ?:x) DataPropertyAtom(:d ?:x ?:v) "
                          "BuiltInAtom(<http://www.w3.org/2003/11/swrlb#lessThan> ?:v \"5\"^^xsd:int)) "
                          "Atoms(ObjectPropertyAtom(:p ?:x :a)))"));
}

std::string unread(std::string_view fault, int line) {
  return "left out: an axiom that cannot be read (" + std::string(fault) + "), 1, line " + std::to_string(line);
}

TEST(Elements, OfRulesThatDoNotFitCostTheirRule) {
  EXPECT_THAT(said("<DLSafeRule><Body/></DLSafeRule>"),
              ElementsAre(unread("expected the head of a rule in <DLSafeRule>, found the end of the element", 2)));
  EXPECT_THAT(said("<DLSafeRule><Body><Class IRI='A'/></Body><Head/></DLSafeRule>"),
              ElementsAre(unread("expected an atom of a rule in <Body>, found Class", 2)));
}

TEST(Elements, ThatDoNotFitCostTheirAxiomAndNoOther) {
  struct Case {
    std::string_view written;
    std::string_view fault;
  };
  for (const Case& one : {
           Case{"<SubClassOf><Class IRI='A'/></SubClassOf>",
                "expected a class expression in <SubClassOf>, found the end of the element"},
           Case{"<SubClassOf><Class IRI='A'/><ObjectProperty IRI='p'/></SubClassOf>",
                "expected a class expression in <SubClassOf>, found ObjectProperty"},
           Case{"<SubClassOf><Class IRI='A'/><Class IRI='A'/><Class IRI='A'/></SubClassOf>",
                "expected no more in <SubClassOf>, found Class"},
           Case{"<SubClassOf><ObjectSomeValuesFrom><ObjectComplementOf/></ObjectSomeValuesFrom><Class/></SubClassOf>",
                "expected a class expression in <ObjectComplementOf>, found the end of the element"},
           Case{"<Class IRI='A'/>", "expected an axiom, found <Class>"},
           Case{"<Declaration><SubClassOf/></Declaration>", "the axiom <SubClassOf> within another element"},
           Case{"<Nonsense/>", "<Nonsense> is no element of OWL/XML"},
           Case{"<x xmlns='http://x'><y/>text</x>", "<x> is no element of OWL/XML"},
           Case{"<Declaration><Class/></Declaration>", "expected the IRI of <Class>"},
           Case{"<Declaration><Class abbreviatedIRI='x:A'/></Declaration>", "the prefix x: is not declared"},
           Case{"<Declaration><Class IRI='a&lt;b'/></Declaration>",
                "an IRI with an angle bracket or a control character"},
           Case{"<Declaration><Class IRI='A'><Class IRI='B'/></Class></Declaration>",
                "an element where none may stand"},
           Case{"<SubClassOf><Class IRI='A'/><ObjectMinCardinality><ObjectProperty IRI='p'/>"
                "</ObjectMinCardinality></SubClassOf>",
                "expected a number as the cardinality of <ObjectMinCardinality>"},
           Case{"<IRI>x</IRI>", "an <IRI> outside of annotations"},
           Case{"<IRI><Annotation><AnnotationProperty IRI='n'/><IRI/></Annotation><Class IRI='A'/></IRI>",
                "an <IRI> outside of annotations"},
           Case{"<FacetRestriction facet='f'><Annotation><AnnotationProperty IRI='n'/><Literal/></Annotation>"
                "</FacetRestriction>",
                "expected one <Literal> in <FacetRestriction>"},
           Case{"<Literal><Declaration><Class IRI='A'/></Declaration></Literal>",
                "the axiom <Declaration> within another element"},
       })
    EXPECT_THAT(said("\n" + std::string(one.written) + "\n<Declaration><Class IRI='B'/></Declaration>"),
                ElementsAre("Declaration(:B)", unread(one.fault, 3)));
  EXPECT_EQ(Reading("<rdf:RDF xmlns:rdf='http://www.w3.org/1999/02/22-rdf-syntax-ns#'/>").error,
            "t.owx:1: expected <Ontology>, found <RDF>");
  EXPECT_THAT(said(""), IsEmpty());
}

TEST(Elements, OfManyDifferentFaultsAreNotNamedOneByOne) {
  std::string lines;
  for (int number = 0; number < 300; ++number)
    lines += "<Declaration><Class abbreviatedIRI='p" + std::to_string(number) + ":A'/></Declaration>";
  const Reading reading(ontology(lines));
  EXPECT_EQ(reading.source.omissions().size(), 251U);
  EXPECT_EQ(reading.source.omissions().back().count, 50U);
}

TEST(Elements, ThatAreReadAlthoughNotOfTheGrammarAreRemarked) {
  const Reading reading(
      ontology("<Prefix name='a:' IRI='http://a/'/><Prefix name='b' IRI='http://b/'/>\n"
               "<Prefix name='a' IRI='http://c/'/><Prefix name='rdfs' IRI='http://r/'/><Prefix/>\n"
               "<Declaration>A<Class IRI='A' iri='B'/></Declaration>\n"
               "<Declaration><Class abbreviatedIRI='a:A'/></Declaration>"
               "<Declaration><Class abbreviatedIRI='rdfs:A'/></Declaration>"
               "<Declaration><Class IRI='a b|c'/></Declaration>"));
  EXPECT_THAT(reading.axioms(), ElementsAre("Declaration(:A)", "Declaration(<http://c/A>)", "Declaration(<http://r/A>)",
                                            "Declaration(:a b|c)"));
  EXPECT_THAT(reading.remarks(), ElementsAre("a prefix with several IRIs, of which the last is used, 2, line 3",
                                             "text that stands in no <Literal>, 1, line 4",
                                             "an attribute that OWL/XML does not have, 1, line 4"));
}

TEST(Elements, OfBrokenAnnotationsCostNoAxiom) {
  const std::string comment = "<AnnotationProperty abbreviatedIRI='rdfs:comment'/>";
  std::vector<owl::Annotation> kept;
  owl::Ontology source;
  const auto document =
      read(ontology("<SubClassOf><Annotation><Annotation>" + comment + "<Literal>nested</Literal></Annotation>" +
                    comment + "<AbbreviatedIRI>no:such</AbbreviatedIRI></Annotation><Annotation>" + comment +
                    "<Literal>good</Literal></Annotation><Class IRI='A'/><Class IRI='B'/></SubClassOf>\n"
                    "<AnnotationAssertion>" +
                    comment + "<AnonymousIndividual/><Literal>x</Literal></AnnotationAssertion>\n<Annotation>" +
                    comment + "<Nonsense/></Annotation>\n<Declaration><Class IRI='C'/></Declaration>"),
           source.add_file("t.owx"), source, {}, &kept);
  ASSERT_TRUE(document.has_value());
  EXPECT_EQ(source.axiom_count(), 2U);
  EXPECT_TRUE(source.omissions().empty());
  ASSERT_EQ(kept.size(), 1U) << "the annotation of a broken annotation goes with it";
  EXPECT_EQ(kept.front().value, "good");
  ASSERT_EQ(source.remarks().size(), 3U);
  EXPECT_EQ(source.name(source.remarks()[0].construct),
            "an annotation that cannot be read (the prefix no: is not declared)");
  EXPECT_EQ(source.remarks()[1].line, 3U);
  EXPECT_EQ(source.remarks()[2].line, 4U);
}

TEST(Elements, MeanTheDocumentWhereTheirIriIsEmpty) {
  const Reading reading(
      ontology("<AnnotationAssertion><AnnotationProperty abbreviatedIRI='rdfs:label'/><IRI></IRI><Literal>all</Literal>"
               "</AnnotationAssertion><Declaration><Class IRI=''/></Declaration>"));
  EXPECT_EQ(reading.error, "");
  EXPECT_THAT(reading.axioms(), ElementsAre("Declaration(:)"));
  EXPECT_THAT(reading.labels(), ElementsAre("http://e/ all"));
  EXPECT_THAT(reading.remarks(), IsEmpty());
}

TEST(Elements, OverTooFewOperandsMeanWhatTheyMean) {
  const auto sub = [](std::string_view super) {
    return "<SubClassOf><Class IRI='A'/>" + std::string(super) + "</SubClassOf>";
  };
  const auto some = [&](std::string_view range) {
    return sub("<DataSomeValuesFrom><DataProperty IRI='d'/>" + std::string(range) + "</DataSomeValuesFrom>");
  };
  const Reading reading(ontology(sub("<ObjectUnionOf/>") + sub("<ObjectIntersectionOf/>") + sub("<ObjectOneOf/>") +
                                 sub("<ObjectUnionOf><Class IRI='B'/></ObjectUnionOf>") + some("<DataOneOf/>") +
                                 some("<DataIntersectionOf/>") +
                                 "<DisjointClasses/><DisjointClasses><Class IRI='A'/>"
                                 "</DisjointClasses><DisjointUnion><Class IRI='C'/></DisjointUnion>"));
  ASSERT_EQ(reading.error, "");
  EXPECT_THAT(reading.axioms(),
              ElementsAre("SubClassOf(:A owl:Nothing)", "SubClassOf(:A owl:Thing)", "SubClassOf(:A owl:Nothing)",
                          "SubClassOf(:A :B)", "SubClassOf(:A DataSomeValuesFrom(:d DataComplementOf(rdfs:Literal)))",
                          "SubClassOf(:A DataSomeValuesFrom(:d rdfs:Literal))", "EquivalentClasses(:C owl:Nothing)"));
  EXPECT_EQ(reading.remarks().size(), 8U) << "the two disjointnesses say nothing, alike";
}

}  // namespace
}  // namespace geminga::owlxml
