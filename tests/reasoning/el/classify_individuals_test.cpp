// Individuals, functional properties and data: everything that follows, and nothing else.
#include <gtest/gtest.h>

#include "entailed.hpp"
#include "reasoning/el/normaliser/key_normaliser.hpp"

namespace geminga::el {
namespace {

class ClassifyMore : public testing::TestWithParam<Entailed> {};
TEST_P(ClassifyMore, FindsExactlyWhatFollows) { expect_exactly(GetParam()); }

const Entailed individuals[] = {
    {"Assertion", "ClassAssertion(A i:a)\nSubClassOf(A B)", {"A < B"}},
    {"Inconsistent", "ClassAssertion(A i:a)\nSubClassOf(A Nothing)", {"inconsistent"}},
    {"InconsistentThroughLinks",
     "ClassAssertion(A i:a)\nSubClassOf(A ObjectSomeValuesFrom(r B))\nSubClassOf(B Nothing)",
     {"inconsistent"}},
    {"UnsatisfiableAlone", "ClassAssertion(A i:a)\nSubClassOf(B Nothing)", {"B < Nothing"}},
    {"EnumerationHasWhatItsMembersHave",
     "ClassAssertion(C i:a)\nClassAssertion(C i:b)\nEquivalentClasses(A ObjectOneOf(i:a i:b))",
     {"A < C"}},
    {"EnumerationHasWhatItsMembersInherit",
     "ClassAssertion(B i:a)\nSubClassOf(B C)\nClassAssertion(C i:b)\nSubClassOf(A ObjectOneOf(i:a i:b))",
     {"A < C", "B < C"}},
    {"EnumerationSaysNothingThatOneMemberLacks",
     "ClassAssertion(C i:a)\nEquivalentClasses(A ObjectOneOf(i:a i:b))",
     {}},
    {"EnumerationWithinAnother",
     "EquivalentClasses(A ObjectOneOf(i:a i:b))\nEquivalentClasses(B ObjectOneOf(i:a i:c i:b))",
     {"A < B"}},
    {"EnumerationsOfEqualIndividuals",
     "SameIndividual(i:a i:c)\nEquivalentClasses(A ObjectOneOf(i:a i:b))\nEquivalentClasses(B ObjectOneOf(i:c i:b))",
     {"A < B", "B < A"}},
    {"EnumerationOfWhatHasOneValue",
     "ClassAssertion(ObjectHasValue(r i:v) i:a)\nObjectPropertyAssertion(r i:b i:v)\n"
     "EquivalentClasses(A ObjectOneOf(i:a i:b))\nEquivalentClasses(B ObjectHasValue(r i:v))",
     {"A < B"}},
    {"EnumerationOfWhichOneMemberIsImpossibleIsLeftOut",
     "ClassAssertion(C i:a)\nClassAssertion(D i:b)\nDisjointClasses(A D)\nSubClassOf(A ObjectOneOf(i:a i:b))",
     {},
     false},
    {"EnumerationOfDifferentIndividuals",
     "DifferentIndividuals(i:a i:b i:c)\nDisjointUnion(A B C)\nEquivalentClasses(B ObjectOneOf(i:a))\n"
     "EquivalentClasses(C ObjectOneOf(i:b i:c))\nClassAssertion(D i:a)\nClassAssertion(D i:b)\nClassAssertion(D i:c)",
     {"A < D", "B < A", "B < D", "C < A", "C < D"}},
    {"NominalLine", "SubClassOf(A ObjectOneOf(i:a))\nSubClassOf(ObjectOneOf(i:a) B)", {"A < B"}},
    {"NominalGetsWhatHasAnInstance",
     "ClassAssertion(A i:b)\nSubClassOf(A ObjectOneOf(i:a))\nSubClassOf(A B)\nSubClassOf(C ObjectOneOf(i:a))",
     {"A < B", "C < A", "C < B"}},
    {"NominalDoesNotGetWhatMayBeEmpty",
     "SubClassOf(A ObjectOneOf(i:a))\nSubClassOf(A B)\nSubClassOf(C ObjectOneOf(i:a))",
     {"A < B"}},
    // If G has an instance, i:a is a B, and the successor of G is below D (Kazakov et al. 2012).
    {"NominalInTheWorldOfOneClass",
     "SubClassOf(G ObjectSomeValuesFrom(r ObjectIntersectionOf(B ObjectOneOf(i:a))))\n"
     "SubClassOf(G ObjectSomeValuesFrom(s ObjectOneOf(i:a)))\nSubClassOf(ObjectSomeValuesFrom(s B) D)\n"
     "SubClassOf(H ObjectSomeValuesFrom(s ObjectOneOf(i:a)))",
     {"G < D"}},
    {"NominalClashInTheWorldOfOneClass",
     "SubClassOf(G ObjectSomeValuesFrom(r ObjectIntersectionOf(B ObjectOneOf(i:a))))\n"
     "SubClassOf(G ObjectSomeValuesFrom(s ObjectIntersectionOf(C ObjectOneOf(i:a))))\nDisjointClasses(B C)",
     {"G < Nothing"}},
    {"HasValue",
     "SubClassOf(A ObjectHasValue(r i:a))\nClassAssertion(B i:a)\nSubClassOf(ObjectSomeValuesFrom(r B) C)",
     {"A < C"}},
    {"HasValueOfSame",
     "SubClassOf(A ObjectHasValue(r i:a))\nSameIndividual(i:a i:b)\nEquivalentClasses(C ObjectHasValue(r i:b))",
     {"A < C"}},
    {"Facts",
     "ObjectPropertyAssertion(r i:a i:b)\nClassAssertion(B i:b)\nSubClassOf(ObjectSomeValuesFrom(r B) C)\n"
     "DisjointClasses(C D)\nClassAssertion(D i:a)",
     {"inconsistent"}},
    {"FactHasItsRange",
     "ObjectPropertyAssertion(r i:a i:b)\nObjectPropertyRange(r C)\nDisjointClasses(C D)\nClassAssertion(D i:b)",
     {"inconsistent"}},
    {"NegativeFact",
     "ObjectPropertyAssertion(r i:a i:b)\nNegativeObjectPropertyAssertion(r i:a i:b)",
     {"inconsistent"}},
    {"NegativeFactOfOther", "ObjectPropertyAssertion(r i:a i:b)\nNegativeObjectPropertyAssertion(r i:b i:a)", {}},
    {"DifferentAndSame", "SameIndividual(i:a i:b)\nDifferentIndividuals(i:a i:c i:b)", {"inconsistent"}},
    {"SelfOfIndividual", "ObjectPropertyAssertion(r i:a i:a)\nIrreflexiveObjectProperty(r)", {"inconsistent"}},
    {"InverseFact",
     "ObjectPropertyAssertion(ObjectInverseOf(r) i:b i:a)\nNegativeObjectPropertyAssertion(r i:a i:b)",
     {"inconsistent"}},
};

const char* const three_with_keys =
    "ClassAssertion(P i:a)\nClassAssertion(P i:b)\nClassAssertion(P i:c)\nEquivalentClasses(A ObjectOneOf(i:a))\n"
    "EquivalentClasses(B ObjectOneOf(i:b))\nEquivalentClasses(C ObjectOneOf(i:c))\n";
const std::string data_key =
    "HasKey(P d:p)\nDataPropertyAssertion(d:p i:a \"1\"^x:integer)\nDataPropertyAssertion(d:p i:b \"1.0\"^x:decimal)\n"
    "DataPropertyAssertion(d:p i:c \"2\"^x:integer)\n";
const std::string object_key =
    "HasKey(P r)\nSubObjectPropertyOf(s r)\nObjectPropertyAssertion(r i:a i:x)\nObjectPropertyAssertion(s i:b i:y)\n"
    "ObjectPropertyAssertion(r i:c i:z)\nSameIndividual(i:x i:y)\n";
const std::string key_of_two =
    "HasKey(P r d:p)\nObjectPropertyAssertion(r i:a i:x)\nObjectPropertyAssertion(r i:b i:x)\n"
    "ObjectPropertyAssertion(r i:c i:x)\nDataPropertyAssertion(d:p i:a \"1\")\nDataPropertyAssertion(d:p i:b \"1\")\n"
    "DataPropertyAssertion(d:p i:c \"2\")\n";
const std::vector<std::string> first_two_are_one = {"A < B", "A < P", "B < A", "B < P", "C < P"};
const std::vector<std::string> all_are_different = {"A < P", "B < P", "C < P"};
const std::string keys_of_no_use =
    "HasKey(P d:p)\nSubClassOf(A P)\nSubClassOf(A DataHasValue(d:p \"1\"))\nSubClassOf(B P)\n"
    "SubClassOf(B DataHasValue(d:p \"1\"))\nDisjointClasses(A B)";

struct KeyCase {
  const char* name;
  std::string axioms;
  std::vector<std::string> closure;
};

TEST(Keys, MakeNamedIndividualsOne) {
  const KeyCase cases[] = {
      {"data", data_key + three_with_keys, first_two_are_one},
      {"objects", object_key + three_with_keys, first_two_are_one},
      {"two", key_of_two + three_with_keys, first_two_are_one},
      {"not of the class",
       data_key + std::string(three_with_keys).substr(std::string("ClassAssertion(P i:a)\n").size()),
       {"B < P", "C < P"}},
      {"different", data_key + "DifferentIndividuals(i:a i:b)\n" + three_with_keys, {"inconsistent"}},
      {"anonymous value",
       "HasKey(P r)\nObjectPropertyAssertion(r i:a _:x)\nObjectPropertyAssertion(r i:b _:x)\n" +
           std::string(three_with_keys),
       all_are_different},
      {"derived membership",
       "HasKey(Q d:p)\nSubClassOf(P Q)\nSubClassOf(P DataHasValue(d:p \"1\"))\n" + std::string(three_with_keys),
       {"A < B", "A < C", "A < P", "A < Q", "B < A", "B < C", "B < P", "B < Q", "C < A", "C < B", "C < P", "C < Q",
        "P < Q"}},
      {"no individuals", keys_of_no_use, {"A < P", "B < P"}},
      {"one individual", keys_of_no_use + "\nClassAssertion(A i:a)", {"A < P", "B < P"}},
  };
  for (const KeyCase& one : cases) {
    const owl::Ontology source = owl::written(one.axioms);
    EXPECT_EQ(owl::closure(owl::loaded(source)), one.closure) << one.name;
    EXPECT_TRUE(owl::classified(source).unused.empty()) << one.name;
  }
}

TEST(Keys, OfTooManyCombinationsAreLeftOutAndNamed) {
  const auto of = [](std::size_t named_ones) {
    std::string text = "HasKey(P r s)\n";
    for (std::size_t at = 0; at < named_ones; ++at) text += "ClassAssertion(P i:a" + std::to_string(at) + ")\n";
    return text;
  };
  static_assert(max_key_tuples == 256 * 256);
  EXPECT_TRUE(owl::classified(owl::written(of(256))).unused.empty());
  const taxonomy::Classification over = owl::classified(owl::written(of(257)));
  ASSERT_EQ(over.unused.size(), 1U);
  EXPECT_EQ(over.unused.front().axiom, 0U);
  EXPECT_EQ(over.unused.front().construct, "owl:hasKey");
}

std::vector<std::string> left_out_of(const std::string& text) {
  std::vector<std::string> found;
  for (const taxonomy::UnusedAxiom& unused : owl::classified(owl::written(text)).unused)
    found.push_back(std::to_string(unused.axiom) + " " + std::string(unused.construct));
  return found;
}

TEST(LeftOut, NamesWhatIsForSimplePropertiesOnly) {
  const std::string not_simple = "SubObjectPropertyOf(r s)\nTransitiveObjectProperty(r)\n";
  using Lines = std::vector<std::string>;
  EXPECT_EQ(left_out_of(not_simple + "FunctionalObjectProperty(s)"),
            Lines{"2 owl:FunctionalProperty of a property that is not simple"});
  EXPECT_EQ(left_out_of(not_simple + "InverseFunctionalObjectProperty(ObjectInverseOf(s))"),
            Lines{"2 owl:InverseFunctionalProperty of a property that is not simple"});
  EXPECT_EQ(left_out_of(not_simple + "IrreflexiveObjectProperty(r)"),
            Lines{"2 owl:IrreflexiveProperty of a property that is not simple"});
  EXPECT_EQ(left_out_of(not_simple + "SubClassOf(ObjectHasSelf(r) A)"),
            Lines{"2 owl:hasSelf of a property that is not simple"});
  EXPECT_EQ(left_out_of("SubObjectPropertyOf(ObjectPropertyChain(q r) r)\nSubClassOf(A ObjectMaxCardinality(1 r))\n"
                        "SubClassOf(B ObjectSomeValuesFrom(q ObjectMaxCardinality(1 r)))\n"
                        "SubClassOf(C ObjectExactCardinality(1 r))\nSubClassOf(C ObjectMaxCardinality(1 q))\n"
                        "SubClassOf(C ObjectMaxCardinality(0 r))"),
            (Lines{"1 owl:maxCardinality of a property that is not simple",
                   "2 owl:maxCardinality of a property that is not simple",
                   "3 owl:maxCardinality of a property that is not simple"}));
}

TEST(LeftOut, NamesEveryAxiomOverOneDatatypeThatOverlaps) {
  const std::string some = "DataSomeValuesFrom(d:p x:nonNegativeInteger)";
  const auto found = left_out_of("DataPropertyRange(d:p x:nonPositiveInteger)\nSubClassOf(A " + some +
                                 ")\nSubClassOf(B " + some + ")\nSubClassOf(C ObjectSomeValuesFrom(r " + some +
                                 "))\nSubClassOf(D ObjectSomeValuesFrom(r " + some + "))\nSubClassOf(" + some + " E)");
  EXPECT_EQ(found, (std::vector<std::string>{"0 datatypes that overlap", "1 datatypes that overlap",
                                             "2 datatypes that overlap", "3 datatypes that overlap",
                                             "4 datatypes that overlap"}));
}

const Entailed functional[] = {
    {"Functional",
     "FunctionalObjectProperty(r)\nSubClassOf(A ObjectSomeValuesFrom(r B))\nSubClassOf(A ObjectSomeValuesFrom(r C))\n"
     "SubClassOf(ObjectSomeValuesFrom(r ObjectIntersectionOf(B C)) D)",
     {"A < D"}},
    {"FunctionalClash",
     "FunctionalObjectProperty(r)\nSubClassOf(A ObjectSomeValuesFrom(r B))\nSubClassOf(A ObjectSomeValuesFrom(r C))\n"
     "DisjointClasses(B C)",
     {"A < Nothing"}},
    {"NotFunctional",
     "SubClassOf(A ObjectSomeValuesFrom(r B))\nSubClassOf(A ObjectSomeValuesFrom(r C))\nDisjointClasses(B C)",
     {}},
    {"FunctionalSuperRole",
     "FunctionalObjectProperty(f)\nSubObjectPropertyOf(r f)\nSubObjectPropertyOf(s f)\n"
     "SubClassOf(A ObjectSomeValuesFrom(r B))\nSubClassOf(A ObjectSomeValuesFrom(s C))\n"
     "SubClassOf(ObjectSomeValuesFrom(r C) D)",
     {"A < D"}},
    {"FunctionalThreeSuccessors",
     "FunctionalObjectProperty(r)\nSubClassOf(A ObjectSomeValuesFrom(r B))\nSubClassOf(A ObjectSomeValuesFrom(r C))\n"
     "SubClassOf(A ObjectSomeValuesFrom(r D))\nSubClassOf(ObjectSomeValuesFrom(r ObjectIntersectionOf(B C D)) E)",
     {"A < E"}},
    {"FunctionalInheritsWhatFollowsTogether",
     "FunctionalObjectProperty(r)\nSubClassOf(A ObjectSomeValuesFrom(r B))\nSubClassOf(A ObjectSomeValuesFrom(r C))\n"
     "SubClassOf(ObjectIntersectionOf(B C) ObjectSomeValuesFrom(r D))\n"
     "SubClassOf(ObjectSomeValuesFrom(r ObjectSomeValuesFrom(r D)) E)",
     {"A < E"}},
    {"FunctionalSelf",
     "FunctionalObjectProperty(r)\nSubClassOf(A ObjectHasSelf(r))\nSubClassOf(A ObjectSomeValuesFrom(r B))",
     {"A < B"}},
    {"FunctionalFacts",
     "FunctionalObjectProperty(r)\nObjectPropertyAssertion(r i:a i:b)\nObjectPropertyAssertion(r i:a i:c)\n"
     "DifferentIndividuals(i:b i:c)",
     {"inconsistent"}},
    {"AtMostOneHere",
     "SubClassOf(A ObjectMaxCardinality(1 r))\nSubClassOf(A ObjectSomeValuesFrom(r B))\n"
     "SubClassOf(A ObjectSomeValuesFrom(r C))\nSubClassOf(E ObjectSomeValuesFrom(r B))\n"
     "SubClassOf(E ObjectSomeValuesFrom(r C))\nSubClassOf(ObjectSomeValuesFrom(r ObjectIntersectionOf(B C)) D)",
     {"A < D"}},
    {"ExactlyOneUnqualified",
     "SubClassOf(A ObjectExactCardinality(1 r))\nSubClassOf(A ObjectSomeValuesFrom(r B))\n"
     "SubClassOf(A ObjectSomeValuesFrom(r C))\nDisjointClasses(B C)",
     {"A < Nothing"}},
    {"AtMostOneQualifiedOfNone", "SubClassOf(A ObjectMaxCardinality(1 r B))", {}},
    {"AtMostOneQualifiedOfTwoIsLeftOut",
     "SubClassOf(A ObjectMaxCardinality(1 r B))\nSubClassOf(A ObjectSomeValuesFrom(r ObjectIntersectionOf(B C)))\n"
     "SubClassOf(A ObjectSomeValuesFrom(r ObjectIntersectionOf(B D)))\nDisjointClasses(C D)",
     {},
     false},
    {"InverseFunctionalIsLeftOut", "InverseFunctionalObjectProperty(r)", {}, false},
    {"DataFunctional",
     "FunctionalDataProperty(d:p)\nSubClassOf(A DataHasValue(d:p \"5\"^x:integer))\n"
     "SubClassOf(A DataHasValue(d:p \"6\"^x:integer))\nSubClassOf(B DataHasValue(d:p \"5\"^x:integer))\n"
     "SubClassOf(B DataHasValue(d:p \"5.0\"^x:decimal))",
     {"A < Nothing"}},
    {"DataFunctionalValueIsOfBothTypes",
     "FunctionalDataProperty(d:p)\nSubClassOf(A DataSomeValuesFrom(d:p x:integer))\n"
     "SubClassOf(A DataSomeValuesFrom(d:p x:string))",
     {"A < Nothing"}},
};

const Entailed data[] = {
    {"DataExistential",
     "SubClassOf(A DataSomeValuesFrom(d:p x:integer))\nSubClassOf(DataSomeValuesFrom(d:p x:decimal) B)",
     {"A < B"}},
    {"DataHasValueInDatatype",
     "SubClassOf(A DataHasValue(d:p \"5\"^x:integer))\nSubClassOf(DataSomeValuesFrom(d:p x:integer) B)",
     {"A < B"}},
    {"DataHasValueOutsideDatatype",
     "SubClassOf(A DataHasValue(d:p \"abc\"))\nSubClassOf(DataSomeValuesFrom(d:p x:integer) B)",
     {}},
    {"DataEqualValues",
     "EquivalentClasses(A DataHasValue(d:p \"5\"^x:integer))\nEquivalentClasses(B DataHasValue(d:p "
     "\"05.0\"^x:decimal))",
     {"A < B", "B < A"}},
    {"DataDifferentValues",
     "EquivalentClasses(A DataHasValue(d:p \"5\"^x:integer))\nEquivalentClasses(B DataHasValue(d:p \"5\"))",
     {}},
    {"DataRangeClash",
     "DataPropertyRange(d:p x:integer)\nSubClassOf(A DataHasValue(d:p \"abc\"))\n"
     "SubClassOf(B DataHasValue(d:p \"7\"^x:integer))\nSubClassOf(C DataSomeValuesFrom(d:p x:string))",
     {"A < Nothing", "C < Nothing"}},
    {"DataRangeOfSmallerType",
     "DataPropertyRange(d:p x:nonNegativeInteger)\nSubClassOf(A DataHasValue(d:p \"-7\"^x:integer))\n"
     "SubClassOf(B DataHasValue(d:p \"7\"^x:integer))",
     {"A < Nothing"}},
    {"DataIntersection",
     "SubClassOf(A DataSomeValuesFrom(d:p DataIntersectionOf(x:string x:integer)))\n"
     "SubClassOf(B DataSomeValuesFrom(d:p DataIntersectionOf(x:decimal x:integer)))",
     {"A < Nothing"}},
    {"DataOneOf",
     "SubClassOf(A DataSomeValuesFrom(d:p DataOneOf(\"5\"^x:integer)))\n"
     "SubClassOf(DataSomeValuesFrom(d:p DataOneOf(\"5\"^x:decimal \"6\")) B)",
     {"A < B"}},
    {"DataSubProperty",
     "SubDataPropertyOf(d:p d:q)\nSubClassOf(A DataSomeValuesFrom(d:p x:string))\nDataPropertyDomain(d:q B)",
     {"A < B"}},
    {"DataAssertions",
     "DataPropertyAssertion(d:p i:a \"5\"^x:integer)\nNegativeDataPropertyAssertion(d:p i:a \"5.0\"^x:decimal)",
     {"inconsistent"}},
    {"DataLanguages",
     "EquivalentClasses(A DataHasValue(d:p \"a\"@en))\nEquivalentClasses(B DataHasValue(d:p \"a\"@EN))\n"
     "EquivalentClasses(C DataHasValue(d:p \"a\"))",
     {"A < B", "B < A"}},
    {"DataFiniteTypeIsLeftOutWhereItMatters",
     "SubClassOf(A DataSomeValuesFrom(d:p x:boolean))\nSubClassOf(DataHasValue(d:p \"true\"^x:boolean) B)",
     {},
     false},
    {"DataFiniteTypeAlone",
     "SubClassOf(A DataSomeValuesFrom(d:p x:boolean))\nDataPropertyRange(d:p x:integer)",
     {"A < Nothing"}},
    {"DataUnknownTypeIsItself",
     "EquivalentClasses(A DataHasValue(d:p \"2020\"^x:gYear))\nEquivalentClasses(B DataHasValue(d:p \"2020\"^x:gYear))",
     {"A < B", "B < A"}},
};

INSTANTIATE_TEST_SUITE_P(Functional, ClassifyMore, testing::ValuesIn(functional), name_of);
INSTANTIATE_TEST_SUITE_P(Data, ClassifyMore, testing::ValuesIn(data), name_of);
INSTANTIATE_TEST_SUITE_P(Individuals, ClassifyMore, testing::ValuesIn(individuals), name_of);

}  // namespace
}  // namespace geminga::el
