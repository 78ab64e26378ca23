// Models where there are some, and none where there are none: each construct and each trap.
#include "reasoning/dl/hypertableau/tableau.hpp"

#include <gtest/gtest.h>

#include "reasoning/dl/clauses/clausify.hpp"
#include "reasoning/dl/hypertableau/values/value_ranges.hpp"
#include "support/written.hpp"

namespace geminga::hypertableau {
namespace {

std::string to_string(const Answer& answer) {
  return answer.verdict == Verdict::yes ? "yes" : answer.verdict == Verdict::no ? "no" : "unknown: " + answer.reason;
}

struct Case {
  const char* name;
  const char* axioms;
  /// Of the ontology, and of class A where there is one in it.
  const char* consistent;
  const char* satisfiable;
};
void PrintTo(const Case& one, std::ostream* out) { *out << one.name; }

class Models : public testing::TestWithParam<Case> {};

TEST_P(Models, AreFoundExactlyWhereThereAreSome) {
  const owl::Ontology source = owl::written(GetParam().axioms);
  const auto set = clauses::clausify(source, std::nullopt, {});
  ASSERT_TRUE(set);
  EXPECT_TRUE(set->unused.empty());
  Tableau tableau(source, *set);
  EXPECT_EQ(to_string(tableau.is_consistent()), GetParam().consistent) << GetParam().axioms;
  for (std::uint32_t at = 0; at < set->concepts.size(); ++at) {
    const clauses::Concept& entry = set->concepts[at];
    if (entry.kind != clauses::ConceptKind::named || !source.name_of(entry.term).ends_with("#A")) continue;
    EXPECT_EQ(to_string(tableau.is_satisfiable({clauses::ConceptId{at}})), GetParam().satisfiable) << GetParam().axioms;
    // The same again: questions leave nothing behind.
    EXPECT_EQ(to_string(tableau.is_satisfiable({clauses::ConceptId{at}})), GetParam().satisfiable) << GetParam().axioms;
  }
}

const std::vector<Case> cases = {
    {"Subclass", "SubClassOf(A B)", "yes", "yes"},
    {"Disjoint", "SubClassOf(A B)\nSubClassOf(A C)\nDisjointClasses(B C)", "yes", "no"},
    // There is at least one thing.
    {"NothingAtAll", "SubClassOf(Thing Nothing)", "no", ""},
    {"Union", "SubClassOf(A ObjectUnionOf(B C))\nSubClassOf(B Nothing)\nSubClassOf(C ObjectSomeValuesFrom(r B))", "yes",
     "no"},
    {"UnionWithOneWay", "SubClassOf(A ObjectUnionOf(B C))\nSubClassOf(B Nothing)", "yes", "yes"},
    {"UniversalAgainstExistential",
     "SubClassOf(A ObjectSomeValuesFrom(r B))\nSubClassOf(A ObjectAllValuesFrom(r ObjectComplementOf(B)))", "yes",
     "no"},
    {"InfiniteByExistentials", "SubClassOf(A ObjectSomeValuesFrom(r A))", "yes", "yes"},
    // A model needs an infinite chain: r- is functional and A has no r-predecessor in B.
    {"InfiniteModelOnly",
     "SubClassOf(A ObjectSomeValuesFrom(r B))\nSubClassOf(B ObjectSomeValuesFrom(r B))\n"
     "InverseFunctionalObjectProperty(r)\nSubClassOf(A ObjectMaxCardinality(0 ObjectInverseOf(r)))\n"
     "DisjointClasses(A B)",
     "yes", "yes"},
    // Blocking must see the parent: what is passed back along r- differs at the second level.
    {"InverseSeesTheParent",
     "SubClassOf(A ObjectSomeValuesFrom(r B))\nSubClassOf(B ObjectSomeValuesFrom(r B))\n"
     "SubClassOf(B ObjectAllValuesFrom(ObjectInverseOf(r) C))\nSubClassOf(A ObjectComplementOf(C))",
     "yes", "no"},
    {"InverseThroughTwoLevels",
     "SubClassOf(A ObjectSomeValuesFrom(r ObjectSomeValuesFrom(r D)))\n"
     "SubClassOf(D ObjectAllValuesFrom(ObjectInverseOf(r) ObjectAllValuesFrom(ObjectInverseOf(r) "
     "ObjectComplementOf(A))))",
     "yes", "no"},
    // Horrocks, Sattler: not C and some f-.D and all f-.(some f-.D): satisfiable by a single loop only if f is
    // functional and the chain upwards goes on; here the unravelled chain contradicts C.
    {"PairwiseBlocking",
     "FunctionalObjectProperty(f)\nTransitiveObjectProperty(r)\nSubObjectPropertyOf(f r)\n"
     "EquivalentClasses(D ObjectIntersectionOf(C ObjectSomeValuesFrom(f ObjectComplementOf(C))))\n"
     "SubClassOf(A ObjectIntersectionOf(ObjectComplementOf(C) ObjectSomeValuesFrom(ObjectInverseOf(f) D) "
     "ObjectAllValuesFrom(ObjectInverseOf(r) ObjectSomeValuesFrom(ObjectInverseOf(f) D))))",
     "yes", "no"},
    {"FunctionalMerges",
     "FunctionalObjectProperty(r)\nSubClassOf(A ObjectSomeValuesFrom(r B))\nSubClassOf(A ObjectSomeValuesFrom(r C))\n"
     "DisjointClasses(B C)",
     "yes", "no"},
    {"FunctionalOfASuper",
     "FunctionalObjectProperty(s)\nSubObjectPropertyOf(r s)\nSubObjectPropertyOf(t s)\n"
     "SubClassOf(A ObjectSomeValuesFrom(r B))\nSubClassOf(A ObjectSomeValuesFrom(t C))\nDisjointClasses(B C)",
     "yes", "no"},
    {"AtLeastAgainstAtMost", "SubClassOf(A ObjectMinCardinality(3 r))\nSubClassOf(A ObjectMaxCardinality(2 r))", "yes",
     "no"},
    {"AtLeastWithAtMost",
     "SubClassOf(A ObjectMinCardinality(3 r B))\nSubClassOf(A ObjectMinCardinality(2 r C))\n"
     "SubClassOf(A ObjectMaxCardinality(4 r))\nDisjointClasses(B C)",
     "yes", "no"},
    {"AtLeastWithEnoughRoom",
     "SubClassOf(A ObjectMinCardinality(3 r B))\nSubClassOf(A ObjectMinCardinality(2 r C))\n"
     "SubClassOf(A ObjectMaxCardinality(3 r))",
     "yes", "yes"},
    {"LargeAtMost",
     "SubClassOf(A ObjectMinCardinality(6 r B))\nSubClassOf(A ObjectMinCardinality(2 r C))\n"
     "SubClassOf(A ObjectMaxCardinality(7 r))\nDisjointClasses(B C)",
     "yes", "no"},
    {"QualifiedAtMost", "SubClassOf(A ObjectMinCardinality(2 r B))\nSubClassOf(A ObjectMaxCardinality(1 r B))", "yes",
     "no"},
    {"AtMostOfAComplement",
     "SubClassOf(A ObjectMinCardinality(3 r))\nSubClassOf(A ObjectMaxCardinality(1 r ObjectComplementOf(B)))\n"
     "SubClassOf(A ObjectMaxCardinality(1 r B))",
     "yes", "no"},
    {"AtMostOfAComplementWithRoom",
     "SubClassOf(A ObjectMinCardinality(3 r))\nSubClassOf(A ObjectMaxCardinality(1 r ObjectComplementOf(B)))\n"
     "SubClassOf(A ObjectMaxCardinality(2 r B))",
     "yes", "yes"},
    {"AtLeastOnTheLeft",
     "SubClassOf(ObjectMinCardinality(2 r) B)\nSubClassOf(A ObjectMinCardinality(2 r))\nDisjointClasses(A B)", "yes",
     "no"},
    // The loop comes after the neighbours, by way of another property.
    {"LoopInTheGuardOfABound",
     "SubClassOf(ObjectHasSelf(r) ObjectMaxCardinality(1 s))\nSubClassOf(A ObjectMinCardinality(2 s B))\n"
     "SubClassOf(ObjectSomeValuesFrom(s B) ObjectHasSelf(t))\nSubObjectPropertyOf(t r)",
     "yes", "no"},
    {"MergingWithTheParent",
     "SubClassOf(A ObjectSomeValuesFrom(r B))\nSubClassOf(B ObjectSomeValuesFrom(ObjectInverseOf(r) C))\n"
     "InverseFunctionalObjectProperty(r)\nDisjointClasses(A C)",
     "yes", "no"},
    {"Transitive",
     "TransitiveObjectProperty(r)\nSubClassOf(A ObjectSomeValuesFrom(r ObjectSomeValuesFrom(r B)))\n"
     "SubClassOf(A ObjectAllValuesFrom(r ObjectComplementOf(B)))",
     "yes", "no"},
    {"Chain",
     "SubObjectPropertyOf(ObjectPropertyChain(r s) t)\n"
     "SubClassOf(A ObjectSomeValuesFrom(r ObjectSomeValuesFrom(s B)))\n"
     "SubClassOf(A ObjectAllValuesFrom(t ObjectComplementOf(B)))",
     "yes", "no"},
    {"ChainInTheMiddleOfNothing",
     "SubObjectPropertyOf(ObjectPropertyChain(r s) t)\n"
     "SubClassOf(A ObjectSomeValuesFrom(s ObjectSomeValuesFrom(r B)))\n"
     "SubClassOf(A ObjectAllValuesFrom(t ObjectComplementOf(B)))",
     "yes", "yes"},
    {"Self", "SubClassOf(A ObjectHasSelf(r))\nSubClassOf(A ObjectAllValuesFrom(r B))\nDisjointClasses(A B)", "yes",
     "no"},
    {"Reflexive", "ReflexiveObjectProperty(r)\nSubClassOf(A ObjectAllValuesFrom(r B))\nDisjointClasses(A B)", "yes",
     "no"},
    {"Irreflexive", "IrreflexiveObjectProperty(r)\nSubClassOf(A ObjectHasSelf(r))", "yes", "no"},
    {"Asymmetric",
     "AsymmetricObjectProperty(r)\nSubClassOf(A ObjectSomeValuesFrom(r ObjectSomeValuesFrom(s B)))\n"
     "SubObjectPropertyOf(ObjectInverseOf(s) r)\nInverseFunctionalObjectProperty(r)",
     "yes", "yes"},
    {"AsymmetricTurnedRound",
     "AsymmetricObjectProperty(r)\nSubClassOf(A ObjectSomeValuesFrom(r ObjectSomeValuesFrom(s B)))\n"
     "SubObjectPropertyOf(s r)\nInverseFunctionalObjectProperty(r)\nSymmetricObjectProperty(s)",
     "yes", "no"},
    {"AsymmetricFacts",
     "AsymmetricObjectProperty(r)\nObjectPropertyAssertion(r i:a i:b)\n"
     "ObjectPropertyAssertion(r i:b i:a)",
     "no", "no"},
    {"DisjointProperties",
     "DisjointObjectProperties(r s)\nSubObjectPropertyOf(t r)\nSubObjectPropertyOf(t s)\n"
     "SubClassOf(A ObjectSomeValuesFrom(t B))",
     "yes", "no"},
    {"Nominals",
     "SubClassOf(A ObjectOneOf(i:a i:b))\nClassAssertion(B i:a)\nClassAssertion(B i:b)\nDisjointClasses(A B)", "yes",
     "no"},
    {"NominalsAreCounted", "SubClassOf(A ObjectMinCardinality(3 r ObjectOneOf(i:a i:b)))", "yes", "no"},
    // Everything is a or b, and there are three different things.
    {"FiniteDomain", "SubClassOf(Thing ObjectOneOf(i:a i:b))\nSubClassOf(A ObjectMinCardinality(3 r))", "yes", "no"},
    // NI rule: every B points to o by r, o has at most one r-predecessor, and B needs another B.
    {"NominalIntroduction",
     "SubClassOf(B ObjectHasValue(r i:o))\nInverseFunctionalObjectProperty(r)\n"
     "SubClassOf(A ObjectIntersectionOf(B ObjectSomeValuesFrom(s ObjectIntersectionOf(B ObjectComplementOf(A)))))",
     "yes", "no"},
    {"NominalIntroductionWithTwo",
     "SubClassOf(B ObjectHasValue(r i:o))\n"
     "SubClassOf(ObjectOneOf(i:o) ObjectMaxCardinality(2 ObjectInverseOf(r)))\n"
     "SubClassOf(A ObjectIntersectionOf(B ObjectSomeValuesFrom(s ObjectIntersectionOf(B ObjectComplementOf(A)))))",
     "yes", "yes"},
    {"NominalIntroductionInALoop",
     "SubClassOf(B ObjectHasValue(r i:o))\n"
     "SubClassOf(ObjectOneOf(i:o) ObjectMaxCardinality(2 ObjectInverseOf(r)))\n"
     "SubClassOf(A B)\nSubClassOf(B ObjectSomeValuesFrom(s B))\nIrreflexiveObjectProperty(s)\n"
     "AsymmetricObjectProperty(s)",
     "yes", "no"},
    {"NominalIntroductionInALoopOfThree",
     "SubClassOf(B ObjectHasValue(r i:o))\n"
     "SubClassOf(ObjectOneOf(i:o) ObjectMaxCardinality(3 ObjectInverseOf(r)))\n"
     "SubClassOf(A B)\nSubClassOf(B ObjectSomeValuesFrom(s B))\nIrreflexiveObjectProperty(s)\n"
     "AsymmetricObjectProperty(s)",
     "yes", "yes"},
    {"SameAndDifferent", "SameIndividual(i:a i:b)\nDifferentIndividuals(i:a i:b)", "no", ""},
    {"SameIndividualsShareClasses",
     "SameIndividual(i:a i:b)\nClassAssertion(B i:a)\nClassAssertion(C i:b)\nDisjointClasses(B C)", "no", ""},
    {"FunctionalFacts",
     "FunctionalObjectProperty(r)\nObjectPropertyAssertion(r i:a i:b)\nObjectPropertyAssertion(r i:a i:c)\n"
     "DifferentIndividuals(i:b i:c)",
     "no", ""},
    {"NegativeFact",
     "SubObjectPropertyOf(r s)\nObjectPropertyAssertion(r i:a i:b)\nNegativeObjectPropertyAssertion(s i:a i:b)", "no",
     ""},
    {"NegativeFactOfATransitiveProperty",
     "TransitiveObjectProperty(r)\nObjectPropertyAssertion(r i:a i:b)\nObjectPropertyAssertion(r i:b i:c)\n"
     "NegativeObjectPropertyAssertion(r i:a i:c)",
     "no", ""},
    {"TopObjectProperty",
     "SubClassOf(A ObjectAllValuesFrom(owl:topObjectProperty B))\nClassAssertion(ObjectComplementOf(B) i:a)", "yes",
     "no"},
    {"BottomObjectProperty", "SubClassOf(A ObjectSomeValuesFrom(owl:bottomObjectProperty B))", "yes", "no"},
    {"Key",
     "HasKey(B r)\nClassAssertion(B i:a)\nClassAssertion(B i:b)\nObjectPropertyAssertion(r i:a i:c)\n"
     "ObjectPropertyAssertion(r i:b i:c)\nDifferentIndividuals(i:a i:b)",
     "no", ""},
    {"Backjumping",
     // Twenty choices that do not matter before one that does.
     "SubClassOf(A ObjectIntersectionOf(ObjectUnionOf(C1 D1) ObjectUnionOf(C2 D2) ObjectUnionOf(C3 D3) "
     "ObjectUnionOf(C4 D4) ObjectUnionOf(C5 D5) ObjectUnionOf(C6 D6) ObjectUnionOf(C7 D7) ObjectUnionOf(C8 D8) "
     "ObjectUnionOf(C9 D9) ObjectUnionOf(E1 F1) ObjectUnionOf(E2 F2) ObjectUnionOf(E3 F3) ObjectUnionOf(E4 F4) "
     "ObjectUnionOf(E5 F5) ObjectUnionOf(E6 F6) ObjectUnionOf(E7 F7) ObjectUnionOf(E8 F8) ObjectUnionOf(E9 F9) "
     "ObjectSomeValuesFrom(r ObjectIntersectionOf(G ObjectUnionOf(H I))) "
     "ObjectAllValuesFrom(r ObjectComplementOf(H)) ObjectAllValuesFrom(r ObjectComplementOf(I))))",
     "yes", "no"},
};

INSTANTIATE_TEST_SUITE_P(Each, Models, testing::ValuesIn(cases),
                         [](const auto& one) { return std::string(one.param.name); });

const std::vector<Case> value_cases = {
    {"BooleanHasTwoValues", "SubClassOf(A DataMinCardinality(3 d:u x:boolean))", "yes", "no"},
    {"BooleanHasTwo", "SubClassOf(A DataMinCardinality(2 d:u x:boolean))", "yes", "yes"},
    {"BytesAreCounted", "SubClassOf(A DataMinCardinality(256 d:u x:byte))", "yes", "yes"},
    {"IntervalOfIntegers",
     "SubClassOf(A DataMinCardinality(3 d:u DatatypeRestriction(x:integer x:minExclusive \"1\"^x:integer "
     "x:maxExclusive \"4\"^x:integer)))",
     "yes", "no"},
    {"IntervalOfDecimals",
     "SubClassOf(A DataMinCardinality(3 d:u DatatypeRestriction(x:decimal x:minExclusive \"1\"^x:integer "
     "x:maxExclusive \"1.1\"^x:decimal)))",
     "yes", "yes"},
    {"EmptyInterval",
     "SubClassOf(A DataSomeValuesFrom(d:u DatatypeRestriction(x:integer x:minInclusive \"5\"^x:integer)))\n"
     "SubClassOf(A DataAllValuesFrom(d:u DatatypeRestriction(x:integer x:maxInclusive \"4\"^x:integer)))",
     "yes", "no"},
    {"DisjointDatatypes", "SubClassOf(A DataSomeValuesFrom(d:u x:integer))\nDataPropertyRange(d:u x:string)", "yes",
     "no"},
    {"FloatsAreNotDoubles", "SubClassOf(A DataSomeValuesFrom(d:u x:float))\nDataPropertyRange(d:u x:double)", "yes",
     "no"},
    {"FloatsBetweenNeighbours",
     "SubClassOf(A DataSomeValuesFrom(d:u DatatypeRestriction(x:float x:minExclusive \"0.0\"^x:float x:maxExclusive "
     "\"1.401298464324817e-45\"^x:float)))",
     "yes", "no"},
    {"ZerosAreDifferent",
     "FunctionalDataProperty(d:u)\nSubClassOf(A DataHasValue(d:u \"0.0\"^x:float))\n"
     "SubClassOf(A DataHasValue(d:u \"-0.0\"^x:float))",
     "yes", "no"},
    {"EqualNumbersOfTwoTypes",
     "FunctionalDataProperty(d:u)\nSubClassOf(A DataHasValue(d:u \"1\"^x:integer))\n"
     "SubClassOf(A DataHasValue(d:u \"1.0\"^x:decimal))",
     "yes", "yes"},
    {"FunctionalValues",
     "FunctionalDataProperty(d:u)\nSubClassOf(A DataHasValue(d:u \"1\"^x:integer))\n"
     "SubClassOf(A DataHasValue(d:u \"2\"^x:integer))",
     "yes", "no"},
    {"OneOf", "SubClassOf(A DataMinCardinality(3 d:u DataOneOf(\"1\"^x:integer \"1.0\"^x:decimal \"2\"^x:integer)))",
     "yes", "no"},
    {"Complement",
     "SubClassOf(A DataSomeValuesFrom(d:u DataIntersectionOf(x:nonNegativeInteger "
     "DataComplementOf(x:positiveInteger) DataComplementOf(DataOneOf(\"0\"^x:integer)))))",
     "yes", "no"},
    {"Union",
     "SubClassOf(A DataSomeValuesFrom(d:u DataUnionOf(x:byte x:boolean)))\n"
     "SubClassOf(A DataAllValuesFrom(d:u DataComplementOf(x:byte)))\n"
     "SubClassOf(A DataAllValuesFrom(d:u DataComplementOf(DataOneOf(\"true\"^x:boolean))))",
     "yes", "yes"},
    {"Lengths", "SubClassOf(A DataMinCardinality(2 d:u DatatypeRestriction(x:string x:maxLength \"0\"^x:integer)))",
     "yes", "no"},
    {"SubProperty",
     "SubDataPropertyOf(d:u d:v)\nSubClassOf(A DataSomeValuesFrom(d:u x:integer))\n"
     "SubClassOf(A DataAllValuesFrom(d:v DataComplementOf(x:integer)))",
     "yes", "no"},
    {"DisjointDataProperties",
     "DisjointDataProperties(d:u d:v)\nSubClassOf(A DataHasValue(d:u \"1\"^x:integer))\n"
     "SubClassOf(A DataHasValue(d:v \"01\"^x:integer))",
     "yes", "no"},
    {"AtMostValues",
     "SubClassOf(A DataMinCardinality(2 d:u x:integer))\nSubClassOf(A DataMinCardinality(2 d:u x:string))\n"
     "SubClassOf(A DataMaxCardinality(3 d:u))",
     "yes", "no"},
    {"AtMostValuesOfARange",
     "SubClassOf(A DataMinCardinality(3 d:u x:integer))\n"
     "SubClassOf(A DataMaxCardinality(1 d:u x:nonNegativeInteger))\n"
     "SubClassOf(A DataMaxCardinality(1 d:u x:negativeInteger))",
     "yes", "no"},
    {"ValueOnTheLeft",
     "SubClassOf(DataHasValue(d:u \"1\"^x:integer) B)\nDataPropertyAssertion(d:u i:a \"01\"^x:integer)\n"
     "ClassAssertion(ObjectComplementOf(B) i:a)",
     "no", ""},
    {"NegativeValue",
     "DataPropertyAssertion(d:u i:a \"1.0\"^x:decimal)\nNegativeDataPropertyAssertion(d:u i:a \"1\"^x:integer)", "no",
     ""},
    {"ValueOutsideTheRange", "DataPropertyRange(d:u x:byte)\nDataPropertyAssertion(d:u i:a \"128\"^x:integer)", "no",
     ""},
    {"KeyOfValues",
     "HasKey(B d:u)\nClassAssertion(B i:a)\nClassAssertion(B i:b)\nDataPropertyAssertion(d:u i:a \"1\"^x:integer)\n"
     "DataPropertyAssertion(d:u i:b \"1\"^x:integer)\nDifferentIndividuals(i:a i:b)",
     "no", ""},
    {"TimesWithAndWithoutZones",
     "SubClassOf(A DataHasValue(d:u \"2020-01-01T00:00:00\"^x:dateTime))\nDataPropertyRange(d:u "
     "DatatypeRestriction(x:dateTime x:minInclusive \"2020-01-01T12:00:00Z\"^x:dateTime))",
     "yes", "no"},
    // No string is in a pattern like [a-[a]]; which are is not worked out.
    {"PatternsMayBeEmpty",
     "SubClassOf(A DataSomeValuesFrom(d:u DatatypeRestriction(x:string x:pattern \"[a-[a]]\"^x:string)))", "yes",
     "unknown: the facet <http://www.w3.org/2001/XMLSchema#pattern> is not worked out"},
    {"ValuesAreNoThings",
     "SubClassOf(Thing ObjectOneOf(i:a))\nDataPropertyAssertion(d:u i:a \"1\"^x:integer)\n"
     "SubClassOf(A DataHasValue(d:u \"2\"^x:integer))",
     "yes", "yes"},
    {"UnknownDatatypesHaveValues", "SubClassOf(A DataSomeValuesFrom(d:u x:colour))", "yes", "yes"},
};

/// The answer for class A with limits.
std::string answer_with(const QuestionLimits& limits, std::string_view axioms) {
  const owl::Ontology source = owl::written(axioms);
  const auto set = clauses::clausify(source, std::nullopt, {});
  Tableau tableau(source, *set, limits);
  return to_string(tableau.is_consistent());
}

TEST(Limits, OfNodesGiveNoAnswerBeyondTheLastOne) {
  // Four individuals and nothing else.
  const std::string text = "DifferentIndividuals(i:a i:b i:c i:d)";
  EXPECT_EQ(answer_with({.nodes = 5}, text), "yes");
  EXPECT_EQ(answer_with({.nodes = 4}, text), "yes");
  EXPECT_EQ(answer_with({.nodes = 3}, text), "unknown: more than 3 nodes were needed");
}

TEST(Limits, OfStepsGiveNoAnswerBeyondTheLastOne) {
  // Three facts.
  const std::string text = "ClassAssertion(A i:a)\nClassAssertion(B i:a)\nClassAssertion(C i:a)";
  EXPECT_EQ(answer_with({.steps = 4}, text), "yes");
  EXPECT_EQ(answer_with({.steps = 3}, text), "yes");
  EXPECT_EQ(answer_with({.steps = 2}, text), "unknown: more than 2 steps were needed");
}

TEST(Limits, OfStepsOfTheWorldComeOnTopOfThoseOfAQuestion) {
  const std::string text = "ClassAssertion(A i:a)\nClassAssertion(B i:a)\nClassAssertion(C i:a)";
  EXPECT_EQ(answer_with({.steps = 1, .world_steps = 3}, text), "yes");
  EXPECT_EQ(answer_with({.steps = 1, .world_steps = 2}, text), "yes");
  EXPECT_EQ(answer_with({.steps = 1, .world_steps = 1}, text), "unknown: more than 2 steps were needed");
}

TEST(Limits, OfFactsGiveNoAnswerBeyondTheLastOne) {
  const std::string text = "ClassAssertion(A i:a)\nClassAssertion(B i:a)\nClassAssertion(C i:a)";
  EXPECT_EQ(answer_with({.facts = 4}, text), "yes");
  EXPECT_EQ(answer_with({.facts = 3}, text), "yes");
  EXPECT_EQ(answer_with({.facts = 2}, text), "unknown: more than 2 facts were needed");
}

TEST(Limits, OfABudgetAreThoseOfAllQuestionsTogether) {
  const owl::Ontology source = owl::written("SubClassOf(A ObjectUnionOf(B C))\nClassAssertion(A i:a)");
  const auto set = clauses::clausify(source, std::nullopt, {});
  base::Budget budget(1'000'000, [] { return true; });
  Tableau tableau(source, *set, {.budget = &budget});
  EXPECT_FALSE(budget.spend(1));
  EXPECT_EQ(to_string(tableau.is_consistent()), "unknown: the time limit was reached");
}

/// Whether A can have a value of an enumeration of so many, which is not 0.
std::string answer_of_enumeration(std::size_t values) {
  std::string text = "SubClassOf(A DataSomeValuesFrom(d:u DataOneOf(";
  for (std::size_t at = 0; at < values; ++at) text += "\"" + std::to_string(at) + "\"^x:integer ";
  return answer_with({}, text + ")))\nClassAssertion(A i:a)\nDataPropertyRange(d:u x:string)");
}

TEST(Limits, OfEnumerationsLeaveOpenWhichValuesThereAre) {
  EXPECT_EQ(answer_of_enumeration(max_enumerated_values - 1), "no");
  EXPECT_EQ(answer_of_enumeration(max_enumerated_values), "no");
  EXPECT_EQ(answer_of_enumeration(max_enumerated_values + 1), "unknown: an enumeration has more than 20000 values");
}

std::string answer_of_facets(std::size_t facets) {
  std::string text = "SubClassOf(A DataSomeValuesFrom(d:u DatatypeRestriction(x:integer";
  for (std::size_t at = 0; at < facets; ++at) text += " x:minInclusive \"" + std::to_string(at) + "\"^x:integer";
  return answer_with({}, text + ")))\nClassAssertion(A i:a)\n" +
                             "DataPropertyRange(d:u DatatypeRestriction(x:integer x:maxInclusive \"5\"^x:integer))");
}

TEST(Limits, OfFacetsLeaveOpenWhichValuesThereAre) {
  EXPECT_EQ(answer_of_facets(max_facets - 1), "no");
  EXPECT_EQ(answer_of_facets(max_facets), "no");
  EXPECT_EQ(answer_of_facets(max_facets + 1), "unknown: a restriction has more than 1000 facets");
}

INSTANTIATE_TEST_SUITE_P(OfValues, Models, testing::ValuesIn(value_cases),
                         [](const auto& one) { return std::string(one.param.name); });

}  // namespace
}  // namespace geminga::hypertableau
