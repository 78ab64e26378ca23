// Inverse and symmetric properties: everything that el derives.
#include <gtest/gtest.h>

#include "entailed.hpp"

namespace geminga::el {
namespace {

class ClassifyInverses : public testing::TestWithParam<Entailed> {};
TEST_P(ClassifyInverses, FindsExactlyWhatFollows) { expect_exactly(GetParam()); }

const Entailed inverses[] = {
    {"UniversalOfInverse",
     "SubClassOf(A ObjectAllValuesFrom(ObjectInverseOf(r) B))\nSubClassOf(C ObjectSomeValuesFrom(r A))",
     {"C < B"}},
    {"DomainOfInverse",
     "ObjectPropertyDomain(ObjectInverseOf(r) C)\nSubClassOf(A ObjectSomeValuesFrom(r B))\n"
     "SubClassOf(ObjectSomeValuesFrom(r C) D)",
     {"A < D"}},
    {"InverseThatNothingHears", "InverseObjectProperties(r s)\nSubClassOf(A ObjectSomeValuesFrom(r B))", {}},
    {"InverseThatADomainHears",
     "InverseObjectProperties(r s)\nSubClassOf(A ObjectSomeValuesFrom(r B))\nObjectPropertyDomain(s C)\n"
     "SubClassOf(ObjectSomeValuesFrom(r C) D)",
     {"A < D"},
     false},
    {"InverseWithARangeSaysOfTheSourceIsLeftOut",
     "InverseObjectProperties(r s)\nSubClassOf(A ObjectSomeValuesFrom(r B))\nObjectPropertyRange(s C)",
     {},
     false},
    {"InverseThatSaysWhatIsKnown",
     "InverseObjectProperties(r s)\nSubClassOf(A ObjectSomeValuesFrom(r B))\nObjectPropertyDomain(s C)\n"
     "ObjectPropertyRange(r C)",
     {}},
    {"SymmetricThatSaysMore",
     "SymmetricObjectProperty(r)\nSubClassOf(A ObjectSomeValuesFrom(r B))\nSubClassOf(ObjectSomeValuesFrom(r A) C)\n"
     "SubClassOf(ObjectSomeValuesFrom(r C) D)",
     {"A < D"},
     false},
    {"InverseOfATransitiveThatTellsNobody",
     "InverseObjectProperties(p h)\nTransitiveObjectProperty(p)\nTransitiveObjectProperty(h)\n"
     "SubClassOf(A ObjectSomeValuesFrom(p B))\n"
     "EquivalentClasses(C ObjectIntersectionOf(D ObjectSomeValuesFrom(p B)))",
     {"C < D"}},
    {"SuccessorMayBeInMoreThanItsClass",
     "InverseObjectProperties(p h)\nTransitiveObjectProperty(p)\nTransitiveObjectProperty(h)\n"
     "SubClassOf(A ObjectSomeValuesFrom(h B))\n"
     "EquivalentClasses(C ObjectIntersectionOf(B ObjectSomeValuesFrom(p A)))\n"
     "SubClassOf(C ObjectSomeValuesFrom(r G))",
     {"C < B"},
     false},
    {"SourceHearsWhatItsSuccessorLearnsOfIt",
     "InverseObjectProperties(p h)\nTransitiveObjectProperty(p)\nSubClassOf(A ObjectSomeValuesFrom(h B))\n"
     "EquivalentClasses(C ObjectIntersectionOf(B ObjectSomeValuesFrom(p A)))\n"
     "SubClassOf(ObjectSomeValuesFrom(h C) E)",
     {"A < E", "C < B"},
     false},
    {"SuccessorThatLearnsAClashIsLeftOut",
     "InverseObjectProperties(p h)\nSubClassOf(A ObjectSomeValuesFrom(h B))\n"
     "SubClassOf(ObjectSomeValuesFrom(p A) F)\nDisjointClasses(B F)",
     {},
     false},
    {"InverseOfATransitiveIsTransitive",
     "InverseObjectProperties(p h)\nTransitiveObjectProperty(p)\nSubClassOf(A ObjectSomeValuesFrom(h B))\n"
     "SubClassOf(B ObjectSomeValuesFrom(h C))\nSubClassOf(ObjectSomeValuesFrom(h C) D)",
     {"A < D", "B < D"}},
    {"InverseOfAChainIsTheChainOfInversesBackwards",
     "InverseObjectProperties(p h)\nInverseObjectProperties(q i)\nSubObjectPropertyOf(ObjectPropertyChain(q p) q)\n"
     "SubClassOf(A ObjectSomeValuesFrom(h ObjectSomeValuesFrom(i B)))\nSubClassOf(ObjectSomeValuesFrom(i B) C)\n"
     "SubClassOf(D ObjectSomeValuesFrom(i B))",
     {"A < C", "D < C"}},
    {"SuccessorLearnsThroughTwoInverses",
     "InverseObjectProperties(p h)\nTransitiveObjectProperty(p)\nSubClassOf(A ObjectSomeValuesFrom(h B))\n"
     "SubClassOf(B ObjectSomeValuesFrom(h C))\nSubClassOf(ObjectIntersectionOf(C ObjectSomeValuesFrom(p A)) D)\n"
     "SubClassOf(ObjectSomeValuesFrom(h D) E)",
     {"A < E"},
     false},
    {"ChainWithAnInverseIsLeftOut",
     "InverseObjectProperties(r s)\nSubObjectPropertyOf(ObjectPropertyChain(s r) t)\n"
     "SubClassOf(A ObjectSomeValuesFrom(r ObjectSomeValuesFrom(r B)))\nSubClassOf(ObjectSomeValuesFrom(t B) C)",
     {},
     false},
};

INSTANTIATE_TEST_SUITE_P(Inverses, ClassifyInverses, testing::ValuesIn(inverses), name_of);

}  // namespace
}  // namespace geminga::el
