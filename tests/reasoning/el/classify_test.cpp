// Each construct in an ontology of a few lines: everything that follows, and nothing else.
#include "reasoning/el/classify.hpp"

#include <gtest/gtest.h>

#include "entailed.hpp"
#include "reasoning/owl/left_out.hpp"
#include "support/written.hpp"

namespace geminga::el {
namespace {

class Classify : public testing::TestWithParam<Entailed> {};
TEST_P(Classify, FindsExactlyWhatFollows) { expect_exactly(GetParam()); }

const Entailed hierarchy[] = {
    {"Nothing", "", {}},
    {"SubClass", "SubClassOf(A B)", {"A < B"}},
    {"Transitivity", "SubClassOf(A B)\nSubClassOf(B C)", {"A < B", "A < C", "B < C"}},
    {"Cycle",
     "SubClassOf(A B)\nSubClassOf(B C)\nSubClassOf(C A)",
     {"A < B", "A < C", "B < A", "B < C", "C < A", "C < B"}},
    {"SelfCycle", "SubClassOf(A A)", {}},
    {"Equivalence",
     "EquivalentClasses(A B)\nSubClassOf(C A)\nSubClassOf(B D)",
     {"A < B", "A < D", "B < A", "B < D", "C < A", "C < B", "C < D"}},
    {"EquivalenceOfThree", "EquivalentClasses(A B C)", {"A < B", "A < C", "B < A", "B < C", "C < A", "C < B"}},
    {"IntersectionRight", "SubClassOf(A ObjectIntersectionOf(B C))", {"A < B", "A < C"}},
    {"IntersectionLeft",
     "SubClassOf(ObjectIntersectionOf(B C) D)\nSubClassOf(A B)\nSubClassOf(A C)",
     {"A < B", "A < C", "A < D"}},
    {"IntersectionOfThree",
     "SubClassOf(ObjectIntersectionOf(D B C) E)\nSubClassOf(A ObjectIntersectionOf(C D))\nSubClassOf(A B)",
     {"A < B", "A < C", "A < D", "A < E"}},
    {"IntersectionDefined",
     "EquivalentClasses(A ObjectIntersectionOf(B C))\nSubClassOf(D ObjectIntersectionOf(C B E))",
     {"A < B", "A < C", "D < A", "D < B", "D < C", "D < E"}},
    {"IntersectionNested",
     "EquivalentClasses(A ObjectIntersectionOf(B ObjectIntersectionOf(C D)))\n"
     "EquivalentClasses(E ObjectIntersectionOf(ObjectIntersectionOf(D B) C))",
     {"A < B", "A < C", "A < D", "A < E", "E < A", "E < B", "E < C", "E < D"}},
    {"IntersectionWithThing", "EquivalentClasses(A ObjectIntersectionOf(B Thing))", {"A < B", "B < A"}},
    {"IntersectionThroughEquivalents",
     "EquivalentClasses(B C)\nSubClassOf(ObjectIntersectionOf(B C) D)\nSubClassOf(A B)",
     {"A < B", "A < C", "A < D", "B < C", "B < D", "C < B", "C < D"}},
    {"ThingLeft", "SubClassOf(Thing A)\nSubClassOf(B C)", {"B < A", "B < C", "C < A", "Thing < A"}},
    {"UnionLeft", "SubClassOf(ObjectUnionOf(A B) C)", {"A < C", "B < C"}},
    {"UnionOfOneRight", "SubClassOf(A ObjectUnionOf(B))", {"A < B"}},
    {"UnionRightSaysNothingByItself", "SubClassOf(A ObjectUnionOf(B C))", {}},
    {"UnionIsItself",
     "SubClassOf(A ObjectUnionOf(B C))\nSubClassOf(ObjectUnionOf(C B) D)",
     {"A < D", "B < D", "C < D"}},
    {"UnionHasWhatItsPartsHave",
     "SubClassOf(A ObjectUnionOf(B C))\nSubClassOf(B D)\nSubClassOf(C E)\nSubClassOf(E D)",
     {"A < D", "B < D", "C < D", "C < E", "E < D"}},
    {"UnionOfUnionsHasWhatItsPartsHave",
     "SubClassOf(A ObjectUnionOf(B C))\nSubClassOf(B ObjectUnionOf(E F))\nSubClassOf(E D)\nSubClassOf(F D)\n"
     "SubClassOf(C D)",
     {"A < D", "B < D", "C < D", "E < D", "F < D"},
     false},
    {"UnionOfWhichOnePartIsPossibleIsLeftOut", "SubClassOf(A ObjectUnionOf(B C))\nDisjointClasses(A B)", {}, false},
    {"UnionAtTheEndOfALinkThatLearnsSomethingIsLeftOut",
     "SubClassOf(A ObjectSomeValuesFrom(r ObjectUnionOf(B C)))\nSubClassOf(ObjectSomeValuesFrom(r B) D)\n"
     "SubClassOf(ObjectSomeValuesFrom(r C) D)",
     {},
     false},
    {"UnionAtTheEndOfALink",
     "SubClassOf(A ObjectSomeValuesFrom(r ObjectUnionOf(B C)))\nSubClassOf(ObjectSomeValuesFrom(r B) D)",
     {}},
    {"DisjointUnion", "DisjointUnion(A B C)\nSubClassOf(D B)\nSubClassOf(D C)", {"B < A", "C < A", "D < Nothing"}},
    {"DisjointUnionsInDisjointUnions",
     "DisjointUnion(A B C)\nDisjointUnion(B D E)\nDisjointUnion(C F G)\nSubClassOf(H A)",
     {"B < A", "C < A", "D < A", "D < B", "E < A", "E < B", "F < A", "F < C", "G < A", "G < C", "H < A"}},
};

const Entailed bottom[] = {
    {"Disjoint", "DisjointClasses(A B)\nSubClassOf(C A)\nSubClassOf(C B)", {"C < Nothing"}},
    {"DisjointOfMany",
     "DisjointClasses(A B C D E F)\nSubClassOf(X A)\nSubClassOf(Y X)\nSubClassOf(Y F)\nSubClassOf(Z B)",
     {"X < A", "Y < Nothing", "Z < B"}},
    {"DisjointWithItself", "DisjointClasses(A A)\nSubClassOf(B A)", {"A < Nothing", "B < Nothing"}},
    {"DisjointEquivalents", "DisjointClasses(A B C D E F)\nEquivalentClasses(A D)", {"A < Nothing", "D < Nothing"}},
    {"DisjointWithThing", "DisjointClasses(A Thing)", {"A < Nothing"}},
    {"DisjointMembersInLine", "DisjointClasses(A B C D E F)\nSubClassOf(B A)", {"B < Nothing"}},
    {"SubClassOfNothing", "SubClassOf(A Nothing)\nSubClassOf(B A)", {"A < Nothing", "B < Nothing"}},
    {"Complement", "SubClassOf(A ObjectComplementOf(B))\nSubClassOf(C A)\nSubClassOf(C B)", {"C < Nothing"}},
    {"ComplementOfComplement", "SubClassOf(A ObjectComplementOf(ObjectComplementOf(B)))", {"A < B"}},
    {"ComplementLeftIsLeftOut", "SubClassOf(ObjectComplementOf(A) B)", {}, false},
    {"ExistentialOfNothing",
     "SubClassOf(A ObjectSomeValuesFrom(r B))\nSubClassOf(B Nothing)",
     {"A < Nothing", "B < Nothing"}},
    {"BottomGoesBack",
     "SubClassOf(A ObjectSomeValuesFrom(r B))\nSubClassOf(B ObjectSomeValuesFrom(r C))\nDisjointClasses(C "
     "D)\nSubClassOf(C D)",
     {"A < Nothing", "B < Nothing", "C < Nothing"}},
    {"OnlyNothing",
     "SubClassOf(A ObjectAllValuesFrom(r Nothing))\nSubClassOf(A ObjectSomeValuesFrom(r B))",
     {"A < Nothing"}},
    {"OnlyNot",
     "SubClassOf(A ObjectAllValuesFrom(r ObjectComplementOf(B)))\nSubClassOf(C A)\nSubClassOf(C ObjectSomeValuesFrom(r "
     "B))",
     {"C < Nothing"}},
    {"AtMostNone",
     "SubClassOf(A ObjectMaxCardinality(0 r B))\nSubClassOf(C A)\nSubClassOf(C ObjectSomeValuesFrom(r B))",
     {"C < Nothing"}},
    {"ThingIsEmpty", "SubClassOf(Thing Nothing)\nSubClassOf(A B)", {"inconsistent"}},
};

const Entailed existential[] = {
    {"Existential",
     "SubClassOf(A ObjectSomeValuesFrom(r B))\nSubClassOf(B C)\nSubClassOf(ObjectSomeValuesFrom(r C) D)",
     {"A < D", "B < C"}},
    {"ExistentialOfOtherRole", "SubClassOf(A ObjectSomeValuesFrom(r B))\nSubClassOf(ObjectSomeValuesFrom(s B) D)", {}},
    {"ExistentialDefined",
     "EquivalentClasses(A ObjectSomeValuesFrom(r B))\nEquivalentClasses(C ObjectSomeValuesFrom(r D))\nSubClassOf(B D)",
     {"A < C", "B < D"}},
    {"ExistentialInExistential",
     "SubClassOf(A ObjectSomeValuesFrom(r ObjectIntersectionOf(B ObjectSomeValuesFrom(s C))))\n"
     "SubClassOf(ObjectSomeValuesFrom(r ObjectSomeValuesFrom(s C)) D)",
     {"A < D"}},
    {"CycleOfLinks",
     "SubClassOf(A ObjectSomeValuesFrom(r A))\nSubClassOf(ObjectSomeValuesFrom(r ObjectSomeValuesFrom(r A)) B)",
     {"A < B"}},
    {"RoleHierarchy",
     "SubObjectPropertyOf(r s)\nSubObjectPropertyOf(s t)\nSubClassOf(A ObjectSomeValuesFrom(r B))\n"
     "SubClassOf(ObjectSomeValuesFrom(t B) C)",
     {"A < C"}},
    {"RoleEquivalence",
     "EquivalentObjectProperties(r s)\nSubClassOf(A ObjectSomeValuesFrom(s B))\nSubClassOf(ObjectSomeValuesFrom(r B) "
     "C)",
     {"A < C"}},
    {"Domain", "ObjectPropertyDomain(r C)\nSubClassOf(A ObjectSomeValuesFrom(r B))", {"A < C"}},
    {"DomainOfSuperRole",
     "SubObjectPropertyOf(r s)\nObjectPropertyDomain(s C)\nSubClassOf(A ObjectSomeValuesFrom(r B))",
     {"A < C"}},
    {"Range",
     "ObjectPropertyRange(r C)\nSubClassOf(A ObjectSomeValuesFrom(r B))\n"
     "SubClassOf(ObjectSomeValuesFrom(r ObjectIntersectionOf(B C)) D)",
     {"A < D"}},
    {"RangeOfSuperRole",
     "SubObjectPropertyOf(r s)\nObjectPropertyRange(s C)\nSubClassOf(A ObjectSomeValuesFrom(r Thing))\n"
     "SubClassOf(ObjectSomeValuesFrom(s C) D)",
     {"A < D"}},
    {"RangeSaysNothingOfTheFiller", "ObjectPropertyRange(r C)\nSubClassOf(A ObjectSomeValuesFrom(r B))", {}},
    {"RangeClash",
     "ObjectPropertyRange(r C)\nDisjointClasses(B C)\nSubClassOf(A ObjectSomeValuesFrom(r B))",
     {"A < Nothing"}},
    {"RangeAsUniversalOfThing",
     "SubClassOf(Thing ObjectAllValuesFrom(r C))\nSubClassOf(A ObjectSomeValuesFrom(r B))\n"
     "SubClassOf(ObjectSomeValuesFrom(r C) D)",
     {"A < D"}},
    {"Transitive",
     "TransitiveObjectProperty(r)\nSubClassOf(A ObjectSomeValuesFrom(r B))\nSubClassOf(B ObjectSomeValuesFrom(r C))\n"
     "SubClassOf(ObjectSomeValuesFrom(r C) D)",
     {"A < D", "B < D"}},
    {"TransitiveSuperOfTold",
     "TransitiveObjectProperty(s)\nSubObjectPropertyOf(r s)\nSubClassOf(A ObjectSomeValuesFrom(r B))\n"
     "SubClassOf(B ObjectSomeValuesFrom(r C))\nSubClassOf(ObjectSomeValuesFrom(s C) D)\n"
     "SubClassOf(ObjectSomeValuesFrom(r C) E)",
     {"A < D", "B < D", "B < E"}},
    {"Chain",
     "SubObjectPropertyOf(ObjectPropertyChain(r s) t)\nSubClassOf(A ObjectSomeValuesFrom(r B))\n"
     "SubClassOf(B ObjectSomeValuesFrom(s C))\nSubClassOf(ObjectSomeValuesFrom(t C) D)",
     {"A < D"}},
    {"ChainOfThree",
     "SubObjectPropertyOf(ObjectPropertyChain(r s r) t)\nSubClassOf(A ObjectSomeValuesFrom(r B))\n"
     "SubClassOf(B ObjectSomeValuesFrom(s C))\nSubClassOf(C ObjectSomeValuesFrom(r E))\n"
     "SubClassOf(ObjectSomeValuesFrom(t E) D)",
     {"A < D"}},
    {"ChainInTheOtherOrder",
     "SubObjectPropertyOf(ObjectPropertyChain(s r) t)\nSubClassOf(A ObjectSomeValuesFrom(r B))\n"
     "SubClassOf(B ObjectSomeValuesFrom(s C))\nSubClassOf(ObjectSomeValuesFrom(t C) D)",
     {}},
    {"RangeOfChainHoldsForWhatComesLast",
     "SubObjectPropertyOf(ObjectPropertyChain(r s) t)\nObjectPropertyRange(t C)\n"
     "SubClassOf(A ObjectSomeValuesFrom(r B))\nSubClassOf(B ObjectSomeValuesFrom(s D))\n"
     "SubClassOf(ObjectSomeValuesFrom(r ObjectSomeValuesFrom(s ObjectIntersectionOf(C D))) E)\n"
     "SubClassOf(ObjectSomeValuesFrom(s C) F)",
     {"A < E"}},
    {"RangeOfChainClashes",
     "SubObjectPropertyOf(ObjectPropertyChain(r s) t)\nObjectPropertyRange(t C)\nDisjointClasses(C D)\n"
     "SubClassOf(A ObjectSomeValuesFrom(r B))\nSubClassOf(B ObjectSomeValuesFrom(s D))",
     {"A < Nothing"}},
    {"RangeOfChainThatGrowsToTheRight",
     "SubObjectPropertyOf(ObjectPropertyChain(t s) t)\nObjectPropertyRange(t C)\n"
     "SubClassOf(A ObjectSomeValuesFrom(t B))\nSubClassOf(B ObjectSomeValuesFrom(s B))\n"
     "SubClassOf(ObjectSomeValuesFrom(s ObjectSomeValuesFrom(s C)) D)\nSubClassOf(ObjectSomeValuesFrom(t D) E)",
     {"A < E"}},
    {"RangeOfChainOfSuperRole",
     "SubObjectPropertyOf(ObjectPropertyChain(r s) t)\nSubObjectPropertyOf(t u)\nObjectPropertyRange(u C)\n"
     "SubClassOf(A ObjectSomeValuesFrom(r ObjectSomeValuesFrom(s D)))\n"
     "SubClassOf(ObjectSomeValuesFrom(r ObjectSomeValuesFrom(s C)) E)",
     {"A < E"}},
    {"RangeOfChainWithSelf",
     "SubObjectPropertyOf(ObjectPropertyChain(r s) t)\nObjectPropertyRange(t C)\n"
     "SubClassOf(A ObjectSomeValuesFrom(r B))\nSubClassOf(B ObjectHasSelf(s))\n"
     "SubClassOf(ObjectSomeValuesFrom(r C) E)",
     {"A < E"}},
    {"RangeOfChainWithReflexive",
     "ReflexiveObjectProperty(s)\nSubObjectPropertyOf(ObjectPropertyChain(r s) t)\nObjectPropertyRange(t C)\n"
     "SubClassOf(A ObjectSomeValuesFrom(r B))\nSubClassOf(ObjectSomeValuesFrom(r C) E)",
     {"A < E"}},
    {"RangeThatTheLastPropertyOfAChainHas",
     "SubObjectPropertyOf(ObjectPropertyChain(r s) t)\nObjectPropertyRange(t C)\nObjectPropertyRange(s C)\n"
     "SubClassOf(A ObjectSomeValuesFrom(s D))\nSubClassOf(ObjectSomeValuesFrom(s C) E)",
     {"A < E"}},
    {"RangeThatEverythingHasOfItselfInACircle",
     "ObjectPropertyRange(r ObjectSomeValuesFrom(s B))\nTransitiveObjectProperty(s)\nReflexiveObjectProperty(r)\n"
     "ObjectPropertyDomain(s C)",
     {"B < C", "Thing < C"}},
    {"RangeOfAChainThatIsNotRegular",
     "SubObjectPropertyOf(ObjectPropertyChain(r t s) t)\nObjectPropertyRange(t C)\n"
     "SubClassOf(A ObjectSomeValuesFrom(r B))",
     {}},
    {"RangeOfAChainThatIsNotRegularAndNeedsRulesIsLeftOut",
     "SubObjectPropertyOf(ObjectPropertyChain(r t s) t)\nObjectPropertyRange(t C)\n"
     "SubClassOf(A ObjectSomeValuesFrom(r ObjectSomeValuesFrom(t B)))\nSubClassOf(B ObjectSomeValuesFrom(s D))\n"
     "SubClassOf(ObjectSomeValuesFrom(s C) E)",
     {},
     false},
    {"Universal",
     "SubClassOf(A ObjectIntersectionOf(ObjectAllValuesFrom(r C) ObjectSomeValuesFrom(s B)))\n"
     "SubObjectPropertyOf(s r)\nSubClassOf(ObjectSomeValuesFrom(s ObjectIntersectionOf(B C)) D)",
     {"A < D"}},
    {"UniversalClashes",
     "SubClassOf(A ObjectAllValuesFrom(r C))\nSubClassOf(A ObjectSomeValuesFrom(r B))\nDisjointClasses(B C)",
     {"A < Nothing"}},
    {"UniversalOfTransitive",
     "TransitiveObjectProperty(r)\nSubClassOf(A ObjectAllValuesFrom(r C))\n"
     "SubClassOf(A ObjectSomeValuesFrom(r ObjectSomeValuesFrom(r B)))\nSubClassOf(B F)\n"
     "SubClassOf(ObjectSomeValuesFrom(r ObjectSomeValuesFrom(r ObjectIntersectionOf(F C))) D)",
     {"A < D", "B < F"}},
    {"UniversalOfSelf", "SubClassOf(A ObjectAllValuesFrom(r C))\nSubClassOf(A ObjectHasSelf(r))", {"A < C"}},
    {"UniversalOfFunctional",
     "FunctionalObjectProperty(r)\nSubClassOf(A ObjectAllValuesFrom(r C))\nSubClassOf(A ObjectSomeValuesFrom(r B))\n"
     "SubClassOf(A ObjectSomeValuesFrom(r E))\n"
     "SubClassOf(ObjectSomeValuesFrom(r ObjectIntersectionOf(C B E)) D)",
     {"A < D"}},
    {"UniversalSaysNothingOfOthers",
     "SubClassOf(A ObjectAllValuesFrom(r C))\nSubClassOf(A ObjectSomeValuesFrom(r B))\n"
     "SubClassOf(E ObjectSomeValuesFrom(r B))\nSubClassOf(ObjectSomeValuesFrom(r C) D)",
     {"A < D"}},
    {"UniversalFromTheFillerOfAUniversal",
     "SubClassOf(A ObjectAllValuesFrom(r ObjectAllValuesFrom(s C)))\n"
     "SubClassOf(A ObjectSomeValuesFrom(r B))\nSubClassOf(B ObjectSomeValuesFrom(s F))\n"
     "SubClassOf(ObjectSomeValuesFrom(r ObjectSomeValuesFrom(s C)) D)",
     {"A < D"}},
    {"UniversalOnTheLeftIsLeftOut", "SubClassOf(ObjectAllValuesFrom(r B) A)", {}, false},
    {"Reflexive", "ReflexiveObjectProperty(r)\nSubClassOf(ObjectSomeValuesFrom(r A) B)", {"A < B"}},
    {"ReflexiveInChain",
     "ReflexiveObjectProperty(r)\nSubObjectPropertyOf(ObjectPropertyChain(r s) t)\n"
     "SubClassOf(A ObjectSomeValuesFrom(s B))\nSubClassOf(ObjectSomeValuesFrom(t B) C)",
     {"A < C"}},
    {"ReflexiveHasItsRange", "ReflexiveObjectProperty(r)\nObjectPropertyRange(r A)", {"Thing < A"}},
    {"Self",
     "SubClassOf(A ObjectHasSelf(r))\nSubClassOf(ObjectSomeValuesFrom(r A) B)\nSubClassOf(ObjectHasSelf(r) C)",
     {"A < B", "A < C"}},
    {"SelfOfSuperRole",
     "SubObjectPropertyOf(r s)\nSubClassOf(A ObjectHasSelf(r))\nSubClassOf(ObjectHasSelf(s) C)",
     {"A < C"}},
    {"LinkToItselfIsNoSelf", "SubClassOf(A ObjectSomeValuesFrom(r A))\nSubClassOf(ObjectHasSelf(r) C)", {}},
    {"Irreflexive", "IrreflexiveObjectProperty(r)\nSubClassOf(A ObjectHasSelf(r))", {"A < Nothing"}},
    {"BottomProperty", "SubClassOf(A ObjectSomeValuesFrom(owl:bottomObjectProperty B))", {"A < Nothing"}},
    {"AtLeastOne", "SubClassOf(A ObjectMinCardinality(1 r B))\nSubClassOf(ObjectSomeValuesFrom(r B) C)", {"A < C"}},
    {"AtLeastNone", "SubClassOf(ObjectMinCardinality(0 r B) C)", {"B < C", "Thing < C"}},
    {"AtLeastTwo", "SubClassOf(A ObjectMinCardinality(2 r B))\nSubClassOf(ObjectSomeValuesFrom(r B) C)", {"A < C"}},
    {"ExactlyOne", "SubClassOf(A ObjectExactCardinality(1 r B))\nSubClassOf(ObjectSomeValuesFrom(r B) C)", {"A < C"}},
    {"ExactlyOneOfTwoThatMayBeOneIsLeftOut",
     "SubClassOf(A ObjectExactCardinality(1 r B))\nSubClassOf(A ObjectSomeValuesFrom(r ObjectIntersectionOf(B C)))\n"
     "SubClassOf(A ObjectSomeValuesFrom(r ObjectIntersectionOf(B D)))\nDisjointClasses(C D)",
     {},
     false},
    {"UniversalIsItself",
     "EquivalentClasses(A ObjectAllValuesFrom(r B))\nEquivalentClasses(C ObjectAllValuesFrom(r B))",
     {"A < C", "C < A"},
     false},
    {"ChainOverAPathOfATransitiveIsWalkedFromItsBeginning",
     "TransitiveObjectProperty(r)\nSubObjectPropertyOf(ObjectPropertyChain(s r) s)\n"
     "SubObjectPropertyOf(ObjectPropertyChain(r t) u)\nSubClassOf(A ObjectSomeValuesFrom(r B))\n"
     "SubClassOf(B ObjectSomeValuesFrom(r C))\nSubClassOf(C ObjectSomeValuesFrom(r D))\n"
     "SubClassOf(D ObjectSomeValuesFrom(t E))\nSubClassOf(F ObjectSomeValuesFrom(s A))\n"
     "SubClassOf(ObjectSomeValuesFrom(u E) G)\nSubClassOf(ObjectSomeValuesFrom(s D) H)",
     {"A < G", "B < G", "C < G", "F < H"}},
};

INSTANTIATE_TEST_SUITE_P(Hierarchy, Classify, testing::ValuesIn(hierarchy), name_of);
INSTANTIATE_TEST_SUITE_P(Bottom, Classify, testing::ValuesIn(bottom), name_of);
INSTANTIATE_TEST_SUITE_P(Existential, Classify, testing::ValuesIn(existential), name_of);

TEST(LeftOut, IsNamedByConstructWithCountAndFirstPlace) {
  owl::Ontology source;
  owl::write_into(source, "SubClassOf(A B)\nSubClassOf(ObjectAllValuesFrom(r C) B)\nDisjointObjectProperties(r s)",
                  "b.ofn");
  owl::write_into(source, "SubClassOf(ObjectAllValuesFrom(r C) D)", "a.ofn");
  source.leave_out("swrl:Imp", owl::FileId{1}, 7, 2);
  const std::vector<owl::LeftOut> left = owl::loaded(source).left_out();
  ASSERT_EQ(left.size(), 3);
  EXPECT_EQ(left[0].construct, "owl:allValuesFrom");
  EXPECT_EQ(left[0].count, 2);
  EXPECT_EQ(left[0].first, "a.ofn:1");
  EXPECT_EQ(left[1].construct, "owl:propertyDisjointWith");
  EXPECT_EQ(left[1].first, "b.ofn:3");
  EXPECT_EQ(left[2].construct, "swrl:Imp");
  EXPECT_EQ(left[2].count, 2);
}

TEST(Classify, FollowsAChainOfAHundredThousandClasses) {
  owl::Ontology source;
  const owl::FileId file = source.add_file("chain");
  source.add_prefix("t", "https://t.example/#");
  constexpr std::size_t length = 100'000;
  std::vector<owl::TermId> classes;
  for (std::size_t at = 0; at < length; ++at)
    classes.push_back(source.named_class("https://t.example/#C" + std::to_string(at)));
  for (std::size_t at = 0; at + 1 < length; ++at)
    source.add(owl::AxiomKind::sub_class_of, {classes[at], classes[at + 1]}, file, 1);
  const compiled::Ontology ontology = owl::loaded(source);
  const taxonomy::ClassNumber first = owl::named(ontology, "C0");
  const taxonomy::ClassNumber last = owl::named(ontology, "C" + std::to_string(length - 1));
  EXPECT_TRUE(ontology.is_subsumed(first, last));
  EXPECT_FALSE(ontology.is_subsumed(last, first));
  EXPECT_EQ(ontology.distance(first, last), length - 1);
}

TEST(Classify, FollowsACycleOfAHundredThousandClasses) {
  owl::Ontology source;
  const owl::FileId file = source.add_file("cycle");
  source.add_prefix("t", "https://t.example/#");
  constexpr std::size_t length = 100'000;
  std::vector<owl::TermId> classes;
  for (std::size_t at = 0; at < length; ++at)
    classes.push_back(source.named_class("https://t.example/#C" + std::to_string(at)));
  for (std::size_t at = 0; at < length; ++at) {
    source.add(owl::AxiomKind::sub_class_of, {classes[at], classes[(at + 1) % length]}, file, 1);
  }
  const compiled::Ontology ontology = owl::loaded(source);
  EXPECT_TRUE(ontology.is_equivalent(owl::named(ontology, "C0"), owl::named(ontology, "C77777")));
}

TEST(Classify, FollowsAChainOfLinksOfFiftyThousand) {
  owl::Ontology source;
  const owl::FileId file = source.add_file("links");
  source.add_prefix("t", "https://t.example/#");
  constexpr std::size_t length = 50'000;
  std::vector<owl::TermId> classes;
  const owl::TermId role = source.object_property("https://t.example/#r");
  for (std::size_t at = 0; at < length; ++at)
    classes.push_back(source.named_class("https://t.example/#C" + std::to_string(at)));
  for (std::size_t at = 0; at + 1 < length; ++at) {
    source.add(owl::AxiomKind::sub_class_of,
               {classes[at], source.term(owl::TermKind::object_some_values_from, {role, classes[at + 1]})}, file, 1);
  }
  source.add(owl::AxiomKind::sub_class_of, {classes.back(), owl::nothing_term}, file, 1);
  const compiled::Ontology ontology = owl::loaded(source);
  EXPECT_FALSE(ontology.is_satisfiable(owl::named(ontology, "C0")));
}

}  // namespace
}  // namespace geminga::el
