// The closures of small ontologies: each rule of the calculus, and each known trap.
#include "reasoning/dl/consequence/closure.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reasoning/dl/consequence/written.hpp"

namespace geminga::consequence {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using Lines = std::vector<std::string>;

// Each of the individuals tells all others what it is, so that a few lines make millions of messages.
TEST(Closure, IsCutOffWhereTooManyMessagesWait) {
  std::string text = "SubClassOf(:A ObjectUnionOf(:B :C)) SameIndividual(";
  for (int number = 0; number < 1200; ++number) text += ":i" + std::to_string(number) + ' ';
  const owl::Ontology source = written(text + ")");
  const Closure closure = saturate(source, clauses_of(source), {}, {.clauses = 200'000});
  EXPECT_THAT(closure.gaps, testing::Contains("more than 1200000 messages between contexts waited"));
}

TEST(Closure, OfNothingIsEmpty) {
  EXPECT_THAT(closure_of(""), IsEmpty());
  EXPECT_THAT(gaps_of(""), IsEmpty());
}

TEST(Closure, FollowsInclusionsConjunctionsAndExistentials) {
  EXPECT_THAT(closure_of(R"(SubClassOf(:A :B) SubClassOf(:A :C) SubClassOf(ObjectIntersectionOf(:B :C) :D)
                            SubClassOf(:D ObjectSomeValuesFrom(:r :A)) SubClassOf(ObjectSomeValuesFrom(:s :B) :E)
                            SubObjectPropertyOf(:r :s))"),
              ElementsAre("A B", "A C", "A D", "A E", "D E"));
}

TEST(Closure, KnowsTransitivePropertiesAndChains) {
  EXPECT_THAT(closure_of(R"(TransitiveObjectProperty(:part) SubClassOf(:A ObjectSomeValuesFrom(:part :B))
                            SubClassOf(:B ObjectSomeValuesFrom(:part :C))
                            SubClassOf(ObjectSomeValuesFrom(:part :C) :D))"),
              ElementsAre("A D", "B D"));
  EXPECT_THAT(closure_of(R"(SubObjectPropertyOf(ObjectPropertyChain(:r :s) :t)
                            SubClassOf(:A ObjectSomeValuesFrom(:r ObjectSomeValuesFrom(:s :B)))
                            SubClassOf(ObjectSomeValuesFrom(:t :B) :C))"),
              ElementsAre("A C"));
}

TEST(Closure, CarriesUniversalsToSuccessorsAndBackThroughInverses) {
  EXPECT_THAT(closure_of(R"(SubClassOf(:A ObjectSomeValuesFrom(:r :B)) SubClassOf(:A ObjectAllValuesFrom(:r :C))
                            SubClassOf(ObjectIntersectionOf(:B :C) :D) SubClassOf(ObjectSomeValuesFrom(:r :D) :E))"),
              ElementsAre("A E"));
  EXPECT_THAT(closure_of(R"(SubClassOf(:A ObjectSomeValuesFrom(:r :B))
                            SubClassOf(:B ObjectAllValuesFrom(ObjectInverseOf(:r) :C)))"),
              ElementsAre("A C"));
}

TEST(Closure, TakesEachCaseOfAUnion) {
  EXPECT_THAT(closure_of(R"(SubClassOf(:A ObjectUnionOf(:B :C)) SubClassOf(:B :D) SubClassOf(:C :D))"),
              ElementsAre("A D", "B D", "C D"));
  EXPECT_THAT(closure_of(R"(SubClassOf(:A ObjectUnionOf(:B :C)) DisjointClasses(:A :B))"), ElementsAre("A C"));
  EXPECT_THAT(closure_of(R"(SubClassOf(:A ObjectUnionOf(ObjectSomeValuesFrom(:r :B) :C)) SubClassOf(:C :D)
                            SubClassOf(ObjectSomeValuesFrom(:r :B) :D))"),
              ElementsAre("A D", "C D"));
}

TEST(Closure, TakesEachCaseOfAUnionAtASuccessor) {
  EXPECT_THAT(closure_of(R"(SubClassOf(:A ObjectSomeValuesFrom(:r ObjectUnionOf(:B :C)))
                            SubClassOf(ObjectSomeValuesFrom(:r :B) :D) SubClassOf(ObjectSomeValuesFrom(:r :C) :D))"),
              ElementsAre("A D"));
  // The union is decided at the successor of the successor.
  EXPECT_THAT(closure_of(R"(SubClassOf(:A ObjectUnionOf(ObjectAllValuesFrom(:r :B) ObjectAllValuesFrom(:r :C)))
                            SubClassOf(:A ObjectSomeValuesFrom(:r ObjectSomeValuesFrom(:r owl:Thing)))
                            SubClassOf(:B ObjectAllValuesFrom(:r owl:Nothing))
                            SubClassOf(:C ObjectAllValuesFrom(:r owl:Nothing)))"),
              ElementsAre("A Nothing"));
}

TEST(Closure, KnowsThatEverythingIsInAClassOrInItsComplement) {
  EXPECT_THAT(closure_of(R"(EquivalentClasses(:B ObjectComplementOf(:A)) SubClassOf(:A :C) SubClassOf(:B :C))"),
              ElementsAre("A C", "B C", "Thing C"));
}

TEST(Closure, MergesSuccessorsOfFunctionalProperties) {
  EXPECT_THAT(closure_of(R"(FunctionalObjectProperty(:r) SubClassOf(:A ObjectSomeValuesFrom(:r :B))
                            SubClassOf(:A ObjectSomeValuesFrom(:r :C))
                            SubClassOf(ObjectSomeValuesFrom(:r ObjectIntersectionOf(:B :C)) :D))"),
              ElementsAre("A D"));
  EXPECT_THAT(closure_of(R"(FunctionalObjectProperty(:s) SubObjectPropertyOf(:r :s) SubObjectPropertyOf(:t :s)
                            SubClassOf(:A ObjectSomeValuesFrom(:r :B)) SubClassOf(:A ObjectSomeValuesFrom(:t :C))
                            DisjointClasses(:B :C))"),
              ElementsAre("A Nothing"));
}

TEST(Closure, MergesASuccessorWithThePredecessor) {
  EXPECT_THAT(closure_of(R"(InverseFunctionalObjectProperty(:r) SubClassOf(:A ObjectSomeValuesFrom(:r :B))
                            SubClassOf(:B ObjectSomeValuesFrom(ObjectInverseOf(:r) :C)))"),
              ElementsAre("A C"));
}

TEST(Closure, CountsSuccessors) {
  EXPECT_THAT(closure_of(R"(SubClassOf(:A ObjectMinCardinality(3 :r :B)) SubClassOf(:A ObjectMaxCardinality(2 :r)))"),
              ElementsAre("A Nothing"));
  EXPECT_THAT(closure_of(R"(SubClassOf(:A ObjectMinCardinality(2 :r :B)) SubClassOf(:A ObjectMaxCardinality(2 :r))
                            SubClassOf(:A ObjectSomeValuesFrom(:r :C)) SubClassOf(ObjectSomeValuesFrom(:r :B) :D))"),
              ElementsAre("A D"));
  EXPECT_THAT(closure_of(R"(SubClassOf(:A ObjectMinCardinality(2 :r :B)) SubClassOf(:A ObjectMaxCardinality(2 :r))
                            SubClassOf(:A ObjectSomeValuesFrom(:r :C))
                            SubClassOf(ObjectSomeValuesFrom(:r ObjectIntersectionOf(:B :C)) :D))"),
              ElementsAre("A D"));
}

TEST(Closure, CountsBeyondWhatClausesWriteOut) {
  EXPECT_THAT(closure_of(R"(SubClassOf(:A ObjectMinCardinality(6 :r :B)) SubClassOf(:A ObjectMaxCardinality(5 :r)))"),
              ElementsAre("A Nothing"));
  EXPECT_THAT(closure_of(R"(SubClassOf(:A ObjectMinCardinality(6 :r :B)) SubClassOf(:A ObjectMaxCardinality(6 :r)))"),
              IsEmpty());
  const std::string five = "SubClassOf(:A ObjectMaxCardinality(5 :r)) ";
  EXPECT_THAT(gaps_of(five + "SubClassOf(:A ObjectMinCardinality(3 :r :B)) SubClassOf(ObjectSomeValuesFrom(:r :B) :C)"),
              IsEmpty());
  EXPECT_THAT(gaps_of(five + "SubClassOf(:A ObjectMinCardinality(4 :r :B)) SubClassOf(ObjectSomeValuesFrom(:r :B) :C)"),
              ElementsAre(number_gap));
}

TEST(Closure, KnowsThingsThatAreTheirOwnNeighbours) {
  EXPECT_THAT(closure_of(R"(SubClassOf(:A ObjectHasSelf(:r)) SubClassOf(:A :B)
                            SubClassOf(ObjectSomeValuesFrom(:r :B) :C))"),
              ElementsAre("A B", "A C"));
  EXPECT_THAT(closure_of(R"(FunctionalObjectProperty(:r) SubClassOf(:A ObjectHasSelf(:r))
                            SubClassOf(:A ObjectSomeValuesFrom(:r :B)))"),
              ElementsAre("A B"));
  EXPECT_THAT(closure_of(R"(SubClassOf(:A ObjectHasSelf(:r)) IrreflexiveObjectProperty(:r))"),
              ElementsAre("A Nothing"));
}

TEST(Closure, KnowsDisjointAndAsymmetricProperties) {
  EXPECT_THAT(closure_of(R"(SubObjectPropertyOf(:t :r) SubObjectPropertyOf(:t :s) DisjointObjectProperties(:r :s)
                            SubClassOf(:A ObjectSomeValuesFrom(:t owl:Thing)))"),
              ElementsAre("A Nothing"));
  EXPECT_THAT(closure_of(R"(AsymmetricObjectProperty(:r) SymmetricObjectProperty(:r)
                            SubClassOf(:A ObjectSomeValuesFrom(:r owl:Thing)))"),
              ElementsAre("A Nothing"));
}

TEST(Closure, KnowsUnsatisfiableClassesThroughTheirSuccessors) {
  EXPECT_THAT(closure_of(R"(SubClassOf(:A ObjectSomeValuesFrom(:r :B)) SubClassOf(:B ObjectSomeValuesFrom(:r :C))
                            SubClassOf(:C ObjectIntersectionOf(:D ObjectComplementOf(:D))))"),
              ElementsAre("A Nothing", "B Nothing", "C Nothing"));
}

TEST(Closure, IsInconsistentWhereNothingCanExist) {
  EXPECT_THAT(closure_of("SubClassOf(owl:Thing :A) SubClassOf(:A owl:Nothing)"), ElementsAre("inconsistent"));
  EXPECT_THAT(closure_of("SubClassOf(owl:Thing ObjectSomeValuesFrom(:r :A)) SubClassOf(:A owl:Nothing)"),
              ElementsAre("inconsistent"));
}

TEST(Closure, IsInconsistentWhereAnIndividualCannotExist) {
  EXPECT_THAT(closure_of("ClassAssertion(:A :a) ClassAssertion(:B :a) DisjointClasses(:A :B)"),
              ElementsAre("inconsistent"));
  EXPECT_THAT(closure_of(R"(ObjectPropertyAssertion(:r :a :b) ClassAssertion(ObjectAllValuesFrom(:r :A) :a)
                            ClassAssertion(ObjectComplementOf(:A) :b))"),
              ElementsAre("inconsistent"));
  EXPECT_THAT(closure_of(R"(FunctionalObjectProperty(:r) ObjectPropertyAssertion(:r :a :b)
                            ObjectPropertyAssertion(:r :a :c) DifferentIndividuals(:b :c))"),
              ElementsAre("inconsistent"));
  EXPECT_THAT(closure_of(R"(ObjectPropertyAssertion(:r :a :b) ObjectPropertyAssertion(:s :a :b)
                            DisjointObjectProperties(:r :s))"),
              ElementsAre("inconsistent"));
  EXPECT_THAT(closure_of("IrreflexiveObjectProperty(:r) ObjectPropertyAssertion(:r :a :b) SameIndividual(:a :b)"),
              ElementsAre("inconsistent"));
}

TEST(Closure, LooksAtFactsOnlyWhenAsked) {
  const owl::Ontology source = written("ClassAssertion(:A :a) SubClassOf(:A owl:Nothing)");
  const clauses::ClauseSet clauses = clauses_of(source);
  EXPECT_FALSE(saturate(source, clauses, {}).is_consistent);
  EXPECT_TRUE(saturate(source, clauses, {}, {.facts = false}).is_consistent);
}

TEST(Closure, KnowsWhatIsSaidOfANominal) {
  EXPECT_THAT(closure_of(R"(SubClassOf(:A ObjectHasValue(:r :a)) ClassAssertion(:B :a)
                            SubClassOf(ObjectSomeValuesFrom(:r :B) :C))"),
              ElementsAre("A C"));
  // b says it of a.
  EXPECT_THAT(closure_of(R"(ObjectPropertyAssertion(:s :b :a) ClassAssertion(ObjectAllValuesFrom(:s :B) :b)
                            SubClassOf(:A ObjectHasValue(:r :a)) SubClassOf(ObjectSomeValuesFrom(:r :B) :C))"),
              ElementsAre("A C"));
}

TEST(Closure, KnowsWhichDatatypesAndValuesExcludeEachOther) {
  EXPECT_THAT(closure_of(R"(DataPropertyRange(:u xsd:string) SubClassOf(:A DataSomeValuesFrom(:u xsd:integer))
                            SubClassOf(:B DataSomeValuesFrom(:u xsd:token)))"),
              ElementsAre("A Nothing"));
  EXPECT_THAT(closure_of(R"(FunctionalDataProperty(:u) SubClassOf(:A DataHasValue(:u "1"^^xsd:int))
                            SubClassOf(:A DataHasValue(:u "1.0"^^xsd:decimal))
                            SubClassOf(:B DataHasValue(:u "1"^^xsd:int)) SubClassOf(:B DataHasValue(:u "2"^^xsd:int)))"),
              ElementsAre("B Nothing"));
}

TEST(Closure, TakesDataRangesApart) {
  EXPECT_THAT(closure_of(R"(SubClassOf(:A DataSomeValuesFrom(:u DataOneOf("1"^^xsd:int "2"^^xsd:int)))
                            SubClassOf(:B :A) SubClassOf(:B DataAllValuesFrom(:u DataComplementOf(DataOneOf("1"^^xsd:int))))
                            SubClassOf(:C :B) SubClassOf(:C DataAllValuesFrom(:u DataComplementOf(DataOneOf("2"^^xsd:int)))))"),
              ElementsAre("B A", "C Nothing"));
  EXPECT_THAT(closure_of(R"(DataPropertyRange(:u DataUnionOf(xsd:string xsd:integer))
                            SubClassOf(:A DataSomeValuesFrom(:u xsd:boolean))
                            SubClassOf(:B DataSomeValuesFrom(:u xsd:token)))"),
              ElementsAre("A Nothing"));
  EXPECT_THAT(closure_of(R"(DatatypeDefinition(:d DataIntersectionOf(xsd:integer DataComplementOf(xsd:int)))
                            SubClassOf(:A DataSomeValuesFrom(:u :d)) DataPropertyRange(:u xsd:short))"),
              ElementsAre("A Nothing"));
  EXPECT_THAT(gaps_of(R"(DataPropertyRange(:u DataUnionOf(xsd:string xsd:integer))
                         SubClassOf(:A DataSomeValuesFrom(:u DataOneOf("1"^^xsd:int "2"^^xsd:int))))"),
              IsEmpty());
}

TEST(Closure, TellsValuesApartByEachBitOfTheirNumbers) {
  Lines axioms{"FunctionalDataProperty(:u)"};
  for (int i = 0; i < 9; ++i) {
    axioms.push_back("SubClassOf(:A" + std::to_string(i) + " DataHasValue(:u \"" + std::to_string(i) + "\"^^xsd:int))");
    for (int j = 0; j < i; ++j) {
      const std::string both = ":A" + std::to_string(i) + " :A" + std::to_string(j);
      axioms.push_back("SubClassOf(:B" + std::to_string(i) + std::to_string(j) + " ObjectIntersectionOf(" + both +
                       "))");
    }
  }
  EXPECT_EQ(closure_of(joined(axioms)).size(), 36U);
  for (const std::string& line : closure_of(joined(axioms))) EXPECT_TRUE(line.ends_with(" Nothing")) << line;
}

TEST(Closure, DoesNotTakeValuesForThings) {
  // Everything is a, but neither false nor any integer is.
  EXPECT_THAT(closure_of(R"(SubClassOf(owl:Thing ObjectOneOf(:a)) DataPropertyAssertion(:u :a "false"^^xsd:boolean)
                            SubClassOf(:C DataSomeValuesFrom(:u xsd:nonNegativeInteger)))"),
              IsEmpty());
  EXPECT_THAT(closure_of(R"(SubClassOf(owl:Thing ObjectOneOf(:a)) SubClassOf(:C ObjectUnionOf(:D :E))
                            SubClassOf(:D DataSomeValuesFrom(:u xsd:integer)) SubClassOf(:D :F)
                            SubClassOf(:E DataMinCardinality(2 :u xsd:string)) SubClassOf(:E :F))"),
              ElementsAre("C F", "D F", "E F"));
  // b and the other value of a are no members of Thing, and so not the same.
  EXPECT_THAT(closure_of(R"(SubClassOf(owl:Thing ObjectOneOf(:a)) SubClassOf(:A DataHasValue(:u "b"))
                            SubClassOf(owl:Thing DataSomeValuesFrom(:u DataComplementOf(DataOneOf("b")))))"),
              IsEmpty());
}

TEST(Gaps, AreNamedWhereTheCalculusIsNotEnough) {
  EXPECT_THAT(gaps_of("SubClassOf(:A ObjectOneOf(:a :b))"), ElementsAre(nominal_gap));
  EXPECT_THAT(gaps_of("SubClassOf(:A ObjectHasValue(:r :a)) SubClassOf(ObjectSomeValuesFrom(:r :B) :C)"),
              ElementsAre(nominal_gap));
  EXPECT_THAT(gaps_of("ObjectPropertyAssertion(:r :a :b) SubClassOf(:A ObjectUnionOf(:B :C)) SubClassOf(:B :D)"),
              ElementsAre(fact_gap));
  EXPECT_THAT(gaps_of("HasKey(:A () (:u)) ClassAssertion(:A :a) ClassAssertion(:A :b)"), ElementsAre(key_gap));
  EXPECT_THAT(gaps_of(R"(DataPropertyRange(:u xsd:boolean) SubClassOf(:A DataMinCardinality(3 :u)))"),
              ElementsAre(value_gap));
  EXPECT_THAT(gaps_of(R"(SubClassOf(:A DataSomeValuesFrom(:u xsd:nonNegativeInteger))
                         DataPropertyRange(:u xsd:nonPositiveInteger))"),
              ElementsAre(range_gap));
}

TEST(Gaps, AreNotNamedWhereItIs) {
  EXPECT_THAT(gaps_of(R"(SubClassOf(:A ObjectUnionOf(:B :C)) SubClassOf(:A ObjectMinCardinality(2 :r :B))
                         InverseObjectProperties(:r :s) SubClassOf(:B ObjectMaxCardinality(1 :s)))"),
              IsEmpty());
  EXPECT_THAT(gaps_of("ClassAssertion(:A :a) ObjectPropertyAssertion(:r :a :b) ObjectPropertyDomain(:r :B)"),
              IsEmpty());
  EXPECT_THAT(gaps_of("DataPropertyRange(:u xsd:string) SubClassOf(:A DataSomeValuesFrom(:u xsd:integer))"), IsEmpty());
}

TEST(Closure, IsCutOffAtItsLimitAndSaysSo) {
  const owl::Ontology source = written("SubClassOf(:A :B) SubClassOf(:B :C) SubClassOf(:C :D)");
  const clauses::ClauseSet clauses = clauses_of(source);
  const std::size_t needed = saturate(source, clauses, named_classes(clauses)).derived;
  EXPECT_THAT(saturate(source, clauses, named_classes(clauses), {.clauses = needed}).gaps, IsEmpty());
  EXPECT_THAT(saturate(source, clauses, named_classes(clauses), {.clauses = needed - 1}).gaps,
              ElementsAre("more than " + std::to_string(needed - 1) + " clauses were derived"));
}

TEST(Closure, OfOneConceptBuildsOnlyWhatItLeadsTo) {
  Lines axioms{"SubClassOf(:A :B)"};
  for (int i = 0; i < 50; ++i) {
    axioms.push_back("SubClassOf(:X" + std::to_string(i) + " ObjectSomeValuesFrom(:r :X" + std::to_string(i + 1) +
                     "))");
  }
  axioms.emplace_back("SubClassOf(ObjectSomeValuesFrom(:r :X3) :Y)");
  const owl::Ontology source = written(joined(axioms));
  const clauses::ClauseSet clauses = clauses_of(source);
  for (const clauses::ConceptId asked : named_classes(clauses)) {
    if (source.name_of(clauses.concepts[number(asked)].term) != "https://t.example/#A") continue;
    // Its own, and that of owl:Thing.
    EXPECT_EQ(saturate(source, clauses, std::span(&asked, 1)).contexts, 2U);
  }
}

TEST(Closure, OfAQueryIsWhatItsExpressionIsUnder) {
  owl::Ontology source = written("SubClassOf(ObjectSomeValuesFrom(:r :B) :C) DisjointClasses(:B :D)");
  const owl::TermId r = source.object_property("https://t.example/#r");
  const owl::TermId b = source.named_class("https://t.example/#B");
  const owl::TermId d = source.named_class("https://t.example/#D");
  const owl::TermId some = source.term(owl::TermKind::object_some_values_from, {r, b});
  const owl::TermId both = source.term(owl::TermKind::object_intersection_of, {b, d});
  const clauses::ClauseSet clauses = clauses_of(source, std::vector{some, both});
  const Closure closure = saturate(source, clauses, clauses.queries);
  ASSERT_EQ(closure.subsumers.size(), 2U);
  EXPECT_EQ(closure.subsumers[1], std::vector{clauses::nothing});
  std::vector<std::string_view> names;
  for (const clauses::ConceptId above : closure.subsumers[0]) {
    if (clauses.concepts[number(above)].kind == clauses::ConceptKind::named) {
      names.push_back(source.name_of(clauses.concepts[number(above)].term));
    }
  }
  EXPECT_THAT(names, testing::UnorderedElementsAre("http://www.w3.org/2002/07/owl#Thing", "https://t.example/#C"));
}

}  // namespace
}  // namespace geminga::consequence
