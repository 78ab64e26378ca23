// What follows from individuals, functional properties and data, and what does not.
#include <gtest/gtest.h>

#include "entailed.hpp"

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
    {"NominalLine", "SubClassOf(A ObjectOneOf(i:a))\nSubClassOf(ObjectOneOf(i:a) B)", {"A < B"}},
    {"NominalGetsWhatHasAnInstance",
     "ClassAssertion(A i:b)\nSubClassOf(A ObjectOneOf(i:a))\nSubClassOf(A B)\nSubClassOf(C ObjectOneOf(i:a))",
     {"A < B", "C < A", "C < B"}},
    {"NominalDoesNotGetWhatMayBeEmpty",
     "SubClassOf(A ObjectOneOf(i:a))\nSubClassOf(A B)\nSubClassOf(C ObjectOneOf(i:a))",
     {"A < B"}},
    // Only where G has an instance must i:a be a B, and then what G leads to is below D (Kazakov et al. 2012).
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
    {"AtMostOneQualifiedIsLeftOut", "SubClassOf(A ObjectMaxCardinality(1 r B))", {}, false},
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
    {"DataIllFormedIsLeftOut", "SubClassOf(A DataHasValue(d:p \"abc\"^x:integer))", {}, false},
    {"DataUnknownTypeIsItself",
     "EquivalentClasses(A DataHasValue(d:p \"2020\"^x:gYear))\nEquivalentClasses(B DataHasValue(d:p \"2020\"^x:gYear))",
     {"A < B", "B < A"}},
};

INSTANTIATE_TEST_SUITE_P(Functional, ClassifyMore, testing::ValuesIn(functional), name_of);
INSTANTIATE_TEST_SUITE_P(Data, ClassifyMore, testing::ValuesIn(data), name_of);
INSTANTIATE_TEST_SUITE_P(Individuals, ClassifyMore, testing::ValuesIn(individuals), name_of);

}  // namespace
}  // namespace geminga::el
