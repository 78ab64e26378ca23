// The lemmas of src/reasoning/el/model/README.md: each with a case that satisfies its premises, so that el alone is
// complete, and a case in which one premise fails, so that the check must refuse.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "entailed.hpp"
#include "reasoning/el/closure/limits.hpp"
#include "saturated.hpp"

namespace geminga::el {
namespace {

class ModelCheckLemmas : public testing::TestWithParam<Entailed> {};
TEST_P(ModelCheckLemmas, HoldOfAnOntology) { expect_exactly(GetParam()); }

TEST(ModelCheckLemma1, ClosedContextsAreAModelOfWhatTheRulesUse) {
  const owl::Ontology source = owl::written(
      "SubClassOf(A ObjectSomeValuesFrom(r B))\nSubClassOf(ObjectSomeValuesFrom(r B) C)\nSubClassOf(C D)\n"
      "SubClassOf(D ObjectSomeValuesFrom(r C))");
  const Saturated closed(source, 1);
  EXPECT_EQ(rule_left_to_fire(closed.index, *closed.saturation), "");
  const Saturated cut_off(source, 1, {.conclusions = 3});
  EXPECT_NE(rule_left_to_fire(cut_off.index, *cut_off.saturation), "");
}

/// The names of the classes whose subsumers are all known, sorted.
std::vector<std::string> settled(const std::string& axioms) {
  const owl::Ontology source = owl::written(axioms);
  const taxonomy::Classification found = owl::classified(source);
  std::vector<std::string> names;
  for (std::size_t at = 0; at < found.is_settled.size(); ++at) {
    const std::string_view iri = source.name(found.classes[at]);
    if (found.is_settled[at]) names.emplace_back(iri.substr(iri.find('#') + 1));
  }
  std::ranges::sort(names);
  return names;
}

TEST(ModelCheckLemma2, AClassIsOpenIfItLeadsToAFailingContextAndOnlyThen) {
  // An element with an r successor must be in C, which the rules do not find.
  const std::vector<std::string> names = settled(
      "InverseObjectProperties(r s)\nObjectPropertyRange(s C)\nSubClassOf(Fails ObjectSomeValuesFrom(r B))\n"
      "SubClassOf(LeadsToIt ObjectSomeValuesFrom(t Fails))\nSubClassOf(Beside ObjectSomeValuesFrom(t B))");
  EXPECT_TRUE(std::ranges::binary_search(names, "Beside"));
  EXPECT_TRUE(std::ranges::binary_search(names, "B"));
  EXPECT_FALSE(std::ranges::binary_search(names, "Fails"));
  EXPECT_FALSE(std::ranges::binary_search(names, "LeadsToIt"));
}

TEST(ModelCheckLemma9, AClassThatLeadsToAnIndividualIsOpenIfAnotherIndividualIsOpen) {
  const std::vector<std::string> names = settled(
      "SubClassOf(A ObjectHasValue(r i:a))\nClassAssertion(B i:a)\nClassAssertion(U i:b)\n"
      "SubClassOf(U ObjectUnionOf(P Q))\nSubClassOf(Beside ObjectSomeValuesFrom(t B))");
  EXPECT_TRUE(std::ranges::binary_search(names, "Beside"));
  EXPECT_FALSE(std::ranges::binary_search(names, "A"));
}

const Entailed successors_in_unions[] = {
    {"Lemma3OnePartTellsTheSourceNothing",
     "SubClassOf(A ObjectSomeValuesFrom(r U))\nSubClassOf(U ObjectUnionOf(P Q))\nSubClassOf(ObjectSomeValuesFrom(r P) "
     "F)",
     {}},
    {"Lemma3EachPartTellsTheSourceSomething",
     "SubClassOf(A ObjectSomeValuesFrom(r U))\nSubClassOf(U ObjectUnionOf(P Q))\nSubClassOf(ObjectSomeValuesFrom(r P) "
     "F)\nSubClassOf(ObjectSomeValuesFrom(r Q) G)\nSubClassOf(ObjectUnionOf(F G) H)",
     {"F < H", "G < H"},
     false},
    {"Lemma3PartIsNotBelowAllThatFollows",
     "SubClassOf(A ObjectSomeValuesFrom(r U))\nSubClassOf(U ObjectUnionOf(P Q))\nSubClassOf(U V)\n"
     "SubClassOf(V ObjectSomeValuesFrom(t W))",
     {"U < V"},
     false},
    {"Lemma3PartFails",
     "SubClassOf(A ObjectSomeValuesFrom(r U))\nSubClassOf(U ObjectUnionOf(P P))\nInverseObjectProperties(q s)\n"
     "ObjectPropertyRange(s C)\nSubClassOf(P ObjectSomeValuesFrom(q B))",
     {"U < P"},
     false},
};
INSTANTIATE_TEST_SUITE_P(Lemma3, ModelCheckLemmas, testing::ValuesIn(successors_in_unions), name_of);

const Entailed classes_in_unions[] = {
    {"Lemma4NothingElseIsAboveAllParts",
     "SubClassOf(U ObjectUnionOf(P Q))\nSubClassOf(P Z)\nSubClassOf(Q Z)\nSubClassOf(P Y)",
     {"P < Y", "P < Z", "Q < Z", "U < Z"}},
    {"Lemma4OnePartIsExcluded", "SubClassOf(U ObjectUnionOf(P Q))\nDisjointClasses(U P)", {}, false},
};
INSTANTIATE_TEST_SUITE_P(Lemma4, ModelCheckLemmas, testing::ValuesIn(classes_in_unions), name_of);

const Entailed heard[] = {
    {"Lemma5NothingHearsTheInverse", "InverseObjectProperties(r s)\nSubClassOf(A ObjectSomeValuesFrom(r B))", {}},
    {"Lemma5ASubPropertyHearsTheInverse",
     "InverseObjectProperties(r s)\nSubObjectPropertyOf(s t)\nSubClassOf(A ObjectSomeValuesFrom(r B))\n"
     "SubClassOf(ObjectIntersectionOf(B ObjectSomeValuesFrom(t A)) C)",
     {},
     false},
};
INSTANTIATE_TEST_SUITE_P(Lemma5, ModelCheckLemmas, testing::ValuesIn(heard), name_of);

const Entailed inverses[] = {
    {"Lemma6BothEndsKnowWhatTheyLearn",
     "InverseObjectProperties(r s)\nSubClassOf(A ObjectSomeValuesFrom(r B))\nObjectPropertyDomain(s C)\n"
     "ObjectPropertyRange(r C)",
     {}},
    {"Lemma6NothingFollowsFromWhatTheTargetLearns",
     "InverseObjectProperties(r s)\nSubClassOf(A ObjectSomeValuesFrom(r B))\nObjectPropertyDomain(s C)",
     {}},
    {"Lemma6TheTargetLearns",
     "InverseObjectProperties(r s)\nSubClassOf(A ObjectSomeValuesFrom(r B))\nObjectPropertyDomain(s C)\n"
     "SubClassOf(C ObjectSomeValuesFrom(t D))",
     {},
     false},
    {"Lemma6TheSourceLearns",
     "InverseObjectProperties(r s)\nSubClassOf(A ObjectSomeValuesFrom(r B))\nObjectPropertyRange(s C)",
     {},
     false},
    {"Lemma6WhatTheTargetLearnsIsHandedOn",
     "InverseObjectProperties(p h)\nTransitiveObjectProperty(p)\nSubClassOf(A ObjectSomeValuesFrom(h Y))\n"
     "SubClassOf(Y E)\nSubClassOf(Y ObjectSomeValuesFrom(h W))\nSubClassOf(ObjectSomeValuesFrom(p A) E)\n"
     "SubClassOf(ObjectIntersectionOf(W E) F)\nSubClassOf(ObjectSomeValuesFrom(h F) G)",
     {"A < G", "Y < E"},
     false},
    {"Lemma6AWalkComesBackAlongTheSameLink",
     "SymmetricObjectProperty(r)\nTransitiveObjectProperty(r)\nSubClassOf(A ObjectSomeValuesFrom(r B))\n"
     "SubClassOf(ObjectSomeValuesFrom(r A) C)",
     {"A < C"},
     false},
};
INSTANTIATE_TEST_SUITE_P(Lemma6, ModelCheckLemmas, testing::ValuesIn(inverses), name_of);

const Entailed conclusions[] = {
    {"Lemma7TheSourceHearsWhatItsSuccessorLearns",
     "InverseObjectProperties(r s)\nSubClassOf(A ObjectSomeValuesFrom(r B))\nSubClassOf(ObjectSomeValuesFrom(s A) C)\n"
     "SubClassOf(ObjectSomeValuesFrom(r C) D)",
     {"A < D"},
     false},
    {"Lemma7WithoutAnInverseTheSuccessorLearnsNothing",
     "SubClassOf(A ObjectSomeValuesFrom(r B))\nSubClassOf(ObjectSomeValuesFrom(s A) C)\n"
     "SubClassOf(ObjectSomeValuesFrom(r C) D)",
     {}},
};
INSTANTIATE_TEST_SUITE_P(Lemma7, ModelCheckLemmas, testing::ValuesIn(conclusions), name_of);

const Entailed counts[] = {
    {"Lemma8AtLeastIsMetByCopies", "SubClassOf(A ObjectMinCardinality(3 r B))", {}},
    {"Lemma8AtLeastIsCounted",
     "SubClassOf(A ObjectMinCardinality(3 r B))\nSubClassOf(A ObjectMaxCardinality(2 r B))",
     {},
     false},
    {"Lemma8AtMostIsNotReached",
     "SubClassOf(A ObjectSomeValuesFrom(r B))\nSubClassOf(A ObjectSomeValuesFrom(r C))\n"
     "SubClassOf(ObjectSomeValuesFrom(r B) B2)\nSubClassOf(ObjectSomeValuesFrom(r C) C2)\n"
     "SubClassOf(A ObjectMaxCardinality(2 r Thing))",
     {"A < B2", "A < C2"}},
    {"Lemma8AtMostIsPassed",
     "SubClassOf(A ObjectSomeValuesFrom(r B))\nSubClassOf(A ObjectSomeValuesFrom(r C))\n"
     "SubClassOf(A ObjectSomeValuesFrom(r D))\nSubClassOf(ObjectSomeValuesFrom(r B) B2)\n"
     "SubClassOf(ObjectSomeValuesFrom(r C) C2)\nSubClassOf(ObjectSomeValuesFrom(r D) D2)\n"
     "SubClassOf(A ObjectMaxCardinality(2 r Thing))",
     {"A < B2", "A < C2", "A < D2"},
     false},
};
INSTANTIATE_TEST_SUITE_P(Lemma8, ModelCheckLemmas, testing::ValuesIn(counts), name_of);

const Entailed worlds[] = {
    {"Lemma9AllIndividualsAreSettled",
     "InverseObjectProperties(q t)\nSubClassOf(A ObjectHasValue(r i:a))\nClassAssertion(U i:a)\n"
     "ObjectPropertyAssertion(q i:a i:b)",
     {}},
    {"Lemma9OneIndividualIsOpen",
     "SubClassOf(A ObjectHasValue(r i:a))\nClassAssertion(B i:a)\nClassAssertion(U i:b)\nSubClassOf(U ObjectUnionOf(P "
     "Q))\nDisjointClasses(U P)\nDisjointClasses(U Q)",
     {},
     false},
};
INSTANTIATE_TEST_SUITE_P(Lemma9, ModelCheckLemmas, testing::ValuesIn(worlds), name_of);

}  // namespace
}  // namespace geminga::el
