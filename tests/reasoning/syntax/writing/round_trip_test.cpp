// A document in each of OWL's own syntaxes is read again as it was written: every construct of OWL 2, annotations of
// names, axioms, annotations and the ontology, and names and texts that need care.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reasoning/owl/canonical.hpp"
#include "reasoning/syntax/writing/reading_again.hpp"
#include "support/random_ontology.hpp"

namespace geminga::writing {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::SizeIs;

constexpr std::string_view constructs = R"(
Prefix(:=<http://e/>)
Prefix(odd:=<http://e/odd#>)
Ontology(<http://e/o> <http://e/o/2>
Import(<http://e/other>)
Annotation(rdfs:comment "of the ontology")
Annotation(Annotation(rdfs:label "why") rdfs:seeAlso :doc)
Declaration(Class(:A)) Declaration(Class(:B)) Declaration(Class(:Unused))
Declaration(ObjectProperty(:p)) Declaration(ObjectProperty(:q)) Declaration(DataProperty(:u))
Declaration(DataProperty(:w)) Declaration(AnnotationProperty(:note)) Declaration(Datatype(:small))
Declaration(NamedIndividual(:i))
SubClassOf(:A :B)
SubClassOf(Annotation(:note "a \"quoted\" back\\slash
and a line"@en-gb) Annotation(Annotation(:note :inner) rdfs:comment "5"^^xsd:integer) :A ObjectSomeValuesFrom(:p :B))
SubClassOf(ObjectIntersectionOf(:A ObjectUnionOf(:B ObjectComplementOf(:A))) ObjectOneOf(:i _:x))
SubClassOf(:A ObjectAllValuesFrom(ObjectInverseOf(:p) ObjectIntersectionOf(:A ObjectIntersectionOf(:B :C))))
SubClassOf(:A ObjectHasValue(:p :i)) SubClassOf(:A ObjectHasValue(ObjectInverseOf(:p) :i)) SubClassOf(:A ObjectHasSelf(:p))
SubClassOf(:A ObjectMinCardinality(2 :p)) SubClassOf(:A ObjectMaxCardinality(3 :p :B))
SubClassOf(:A ObjectExactCardinality(4294967295 ObjectInverseOf(:p) ObjectComplementOf(:B)))
SubClassOf(:A DataSomeValuesFrom(:u :small)) SubClassOf(:A DataAllValuesFrom(:u DataComplementOf(xsd:string)))
SubClassOf(:A DataHasValue(:u "t"@de)) SubClassOf(:A DataMinCardinality(1 :u)) SubClassOf(:A DataMaxCardinality(2 :u xsd:integer))
SubClassOf(:A DataExactCardinality(2 :u DataUnionOf(xsd:integer DataIntersectionOf(xsd:string :small))))
SubClassOf(:A DataSomeValuesFrom(:u DataOneOf("1"^^xsd:integer "" "x"^^:small)))
SubClassOf(:A DataSomeValuesFrom(:u DatatypeRestriction(xsd:integer xsd:minInclusive "1"^^xsd:integer xsd:maxExclusive "7"^^xsd:integer)))
SubClassOf(:A DataSomeValuesFrom(:u DatatypeRestriction(xsd:string xsd:length "3"^^xsd:nonNegativeInteger xsd:pattern "[a-z]<&>\"\\.*")))
SubClassOf(:A DataSomeValuesFrom(:u DatatypeRestriction(rdf:PlainLiteral rdf:langRange "en")))
EquivalentClasses(:A :B) EquivalentClasses(:A :B ObjectSomeValuesFrom(:p owl:Thing)) EquivalentClasses(ObjectComplementOf(:A) ObjectHasSelf(:q))
DisjointClasses(:A :B) DisjointClasses(Annotation(:note "n-ary") :A :B :C) DisjointUnion(:A :B ObjectComplementOf(:B))
SubObjectPropertyOf(:p :q) SubObjectPropertyOf(ObjectPropertyChain(:p ObjectInverseOf(:q) :p) :q) SubObjectPropertyOf(ObjectInverseOf(:p) :q)
EquivalentObjectProperties(:p :q) EquivalentObjectProperties(:p :q ObjectInverseOf(:r)) DisjointObjectProperties(:p :q) DisjointObjectProperties(:p :q :r)
InverseObjectProperties(:p :q) ObjectPropertyDomain(:p :A) ObjectPropertyDomain(ObjectInverseOf(:p) :A) ObjectPropertyRange(:p ObjectUnionOf(:A :B))
FunctionalObjectProperty(:p) InverseFunctionalObjectProperty(:p) ReflexiveObjectProperty(:p) IrreflexiveObjectProperty(:p)
SymmetricObjectProperty(:p) AsymmetricObjectProperty(:p) TransitiveObjectProperty(Annotation(:note "t") :p) FunctionalObjectProperty(ObjectInverseOf(:q))
SubDataPropertyOf(:u :w) EquivalentDataProperties(:u :w) EquivalentDataProperties(:u :w :z) DisjointDataProperties(:u :w) DisjointDataProperties(:u :w :z)
DataPropertyDomain(:u :A) DataPropertyRange(:u DataOneOf("a" "b")) FunctionalDataProperty(:u)
DatatypeDefinition(:small DatatypeRestriction(xsd:integer xsd:maxInclusive "9"^^xsd:integer))
HasKey(:A (:p ObjectInverseOf(:q)) (:u)) HasKey(ObjectSomeValuesFrom(:p :B) () (:u :w)) HasKey(:B (:p) ())
SameIndividual(:i :j) SameIndividual(:i :j :k) DifferentIndividuals(:i _:y) DifferentIndividuals(:i :j :k)
ClassAssertion(:A :i) ClassAssertion(ObjectComplementOf(:A) _:x) ObjectPropertyAssertion(:p :i _:x)
ObjectPropertyAssertion(Annotation(:note "a fact") :p :i :j) NegativeObjectPropertyAssertion(:p :i :j)
DataPropertyAssertion(:u :i "1.5"^^xsd:decimal) DataPropertyAssertion(:u :i " spaces  and more ") NegativeDataPropertyAssertion(:u :i "x"@en)
DataPropertyAssertion(Annotation(:note "kept") :u :i "one"^^xsd:integer)
DLSafeRule(Annotation(:note "a rule") Body(ClassAtom(ObjectIntersectionOf(:A :B) Variable(<urn:swrl:var#x>)) ObjectPropertyAtom(:p Variable(<urn:swrl:var#x>) :i)
ObjectPropertyAtom(ObjectInverseOf(:p) Variable(<urn:swrl:var#x>) _:x) DataPropertyAtom(:u Variable(<urn:swrl:var#x>) Variable(:v)) DataRangeAtom(:small Variable(:v))
DataRangeAtom(DataUnionOf(xsd:string :small) "t") BuiltInAtom(<http://www.w3.org/2003/11/swrlb#add> Variable(:v) "1"^^xsd:integer "2.5"^^xsd:decimal)
BuiltInAtom(:own Variable(:v)  Variable(<urn:swrl:var#1,2>) "x"@en)) Head(SameIndividualAtom(Variable(<urn:swrl:var#x>) :i) DifferentIndividualsAtom(Variable(<urn:swrl:var#x>) :j)))
DLSafeRule(Body() Head(ClassAtom(:A :i))) DLSafeRule(Body(ClassAtom(:A Variable(<urn:swrl:var#y>))) Head())
SubClassOf(<http://e/odd#1/2> <http://other.example/no?prefix=fits&so>) SubClassOf(<urn:x:y> <http://e/>) SubClassOf(odd:some <http://e/ä>)
SubClassOf(:Class :SubClassOf) SubClassOf(:-a :a.) ClassAssertion(<http://e/odd#and> :true)
AnnotationAssertion(rdfs:label :A "the \"A\" <class> & more"@en) AnnotationAssertion(Annotation(:note "nested") :note :A :B)
AnnotationAssertion(:note :A _:x) AnnotationAssertion(:note _:x "of a blank node") AnnotationAssertion(:note <http://nowhere/declared> "7"^^xsd:int)
AnnotationAssertion(rdfs:comment :u "1"^^:small) AnnotationAssertion(:note :i "")
SubAnnotationPropertyOf(Annotation(:note "s") :note rdfs:comment) AnnotationPropertyDomain(:note :A) AnnotationPropertyRange(:note xsd:string)
)
)";

TEST(Writing, IsReadAgainInEachSyntaxAsItWasWritten) {
  const Read original = read(constructs, syntax::Syntax::functional);
  ASSERT_EQ(original.error, "");
  ASSERT_THAT(said(original), SizeIs(testing::Gt(90)));
  for (const syntax::Syntax syntax : syntaxes) {
    const std::string text = written(original, syntax);
    const Read again = read(text, syntax);
    ASSERT_EQ(again.error, "") << text;
    EXPECT_EQ(said(again), said(original)) << text;
    EXPECT_EQ(owl::digest(again.source), owl::digest(original.source)) << syntax::to_string(syntax);
    EXPECT_EQ(again.iri, "http://e/o");
    EXPECT_EQ(again.version_iri, "http://e/o/2");
    EXPECT_THAT(again.imports, testing::ElementsAre("http://e/other"));
    EXPECT_EQ(said(read(written(again, syntax), syntax)), said(original)) << "written twice";
  }
}

TEST(Writing, OfRandomOntologiesIsReadAgainAsItWasWritten) {
  for (const compare::Profile profile : compare::profiles) {
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
      Read original;
      original.source = compare::random_ontology(profile, seed, 40);
      for (const syntax::Syntax syntax : syntaxes) {
        const std::string text = written(original, syntax);
        const Read again = read(text, syntax);
        ASSERT_EQ(again.error, "") << compare::to_string(profile) << ' ' << seed << '\n' << text;
        ASSERT_EQ(said(again), said(original)) << compare::to_string(profile) << ' ' << seed << '\n' << text;
      }
    }
  }
}

TEST(Writing, UsesThePrefixesOfTheFiles) {
  const Read original = read(constructs, syntax::Syntax::functional);
  EXPECT_THAT(written(original, syntax::Syntax::functional), HasSubstr("\nSubClassOf(:A :B)\n"));
  EXPECT_THAT(written(original, syntax::Syntax::owl_xml), HasSubstr("<Class abbreviatedIRI=\"odd:some\"/>"));
  EXPECT_THAT(written(original, syntax::Syntax::manchester), HasSubstr("\nClass: :A\n    SubClassOf: :B\n"));
}

TEST(Writing, MeansTheSameWhereOwl2HasNoSetsOfFewOperands) {
  Read original;
  owl::Ontology& source = original.source;
  const owl::FileId file = source.add_file("t");
  const owl::TermId a = source.named_class("http://e/A");
  const owl::TermId u = source.data_property("http://e/u");
  const auto add = [&](owl::TermId super) { source.add(owl::AxiomKind::sub_class_of, {a, super}, file, 1); };
  add(source.term(owl::TermKind::object_union_of, {}));
  add(source.term(owl::TermKind::object_one_of, {}));
  add(source.term(owl::TermKind::object_intersection_of, {source.named_class("http://e/B")}));
  add(source.term(owl::TermKind::data_some_values_from, {u, source.term(owl::TermKind::data_one_of, {})}));
  for (const syntax::Syntax syntax : syntaxes) {
    const std::string text = written(original, syntax);
    const Read again = read(text, syntax);
    ASSERT_EQ(again.error, "") << text;
    EXPECT_THAT(said(again), Contains("SubClassOf | http://e/A | http://www.w3.org/2002/07/owl#Nothing")) << text;
    EXPECT_THAT(said(again), Contains("SubClassOf | http://e/A | http://e/B")) << text;
    EXPECT_THAT(said(again), SizeIs(3)) << text;
  }
}

}  // namespace
}  // namespace geminga::writing
