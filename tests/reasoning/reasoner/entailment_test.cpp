// Every kind of axiom as a conclusion: one premise from which it follows, and one from which it does not.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <vector>

#include "reasoning/reasoner/argued.hpp"
#include "reasoning/reasoner/challenge.hpp"

namespace geminga::reasoner {
namespace {

using testing::HasSubstr;

struct Case {
  const char* name;
  const char* conclusion;
  const char* sufficient;
  const char* insufficient;
};

void PrintTo(const Case& one, std::ostream* out) { *out << one.name; }

class Conclusion : public testing::TestWithParam<Case> {};

TEST_P(Conclusion, FollowsFromWhatSufficesAndNotFromLess) {
  EXPECT_EQ(answer_to(GetParam().sufficient, GetParam().conclusion), "yes") << GetParam().sufficient;
  EXPECT_EQ(answer_to(GetParam().insufficient, GetParam().conclusion), "no") << GetParam().insufficient;
}

TEST_P(Conclusion, FollowsFromItselfFromAContradictionAndNotFromNothing) {
  EXPECT_EQ(answer_to(GetParam().conclusion, GetParam().conclusion), "yes");
  EXPECT_EQ(answer_to("ClassAssertion(Nothing i:nobody)", GetParam().conclusion), "yes");
  EXPECT_EQ(answer_to("", GetParam().conclusion), "no");
}

const std::vector<Case> class_axioms = {
    {"SubClassOf", "SubClassOf(A C)", "SubClassOf(A B)\nSubClassOf(B C)", "SubClassOf(C B)\nSubClassOf(B A)"},
    {"SubClassOfUnion", "SubClassOf(ObjectUnionOf(A B) C)", "SubClassOf(A C)\nSubClassOf(B C)", "SubClassOf(A C)"},
    {"SubClassOfUniversal", "SubClassOf(A ObjectAllValuesFrom(r B))",
     "SubClassOf(ObjectSomeValuesFrom(r A) Nothing)\n"
     "SymmetricObjectProperty(r)\nSubClassOf(Thing ObjectUnionOf(A B))",
     "SubClassOf(A ObjectSomeValuesFrom(r B))"},
    {"EquivalentClasses", "EquivalentClasses(A B C)", "SubClassOf(A B)\nSubClassOf(B C)\nSubClassOf(C A)",
     "EquivalentClasses(A B)\nSubClassOf(A C)"},
    {"DisjointClasses", "DisjointClasses(A B C)",
     "DisjointClasses(X Y)\nSubClassOf(A X)\nSubClassOf(B Y)\nSubClassOf(C Y)\nSubClassOf(C ObjectComplementOf(B))",
     "DisjointClasses(A B)\nDisjointClasses(B C)"},
    {"DisjointUnion", "DisjointUnion(A B C)",
     "DisjointClasses(B C)\nSubClassOf(B A)\nSubClassOf(C A)\nSubClassOf(A ObjectUnionOf(B C))",
     "DisjointClasses(B C)\nSubClassOf(B A)\nSubClassOf(C A)"},
};

const std::vector<Case> object_property_axioms = {
    {"SubObjectPropertyOf", "SubObjectPropertyOf(r t)", "SubObjectPropertyOf(r s)\nSubObjectPropertyOf(s t)",
     "SubObjectPropertyOf(t r)"},
    {"SubObjectPropertyOfInverse", "SubObjectPropertyOf(r ObjectInverseOf(t))",
     "SubObjectPropertyOf(r s)\nInverseObjectProperties(s t)", "SubObjectPropertyOf(r t)"},
    {"SubPropertyChainOf", "SubObjectPropertyOf(ObjectPropertyChain(r s) t)",
     "SubObjectPropertyOf(r t)\nSubObjectPropertyOf(s t)\nTransitiveObjectProperty(t)", "SubObjectPropertyOf(r t)"},
    {"EquivalentObjectProperties", "EquivalentObjectProperties(r s)",
     "InverseObjectProperties(r t)\nInverseObjectProperties(s t)", "InverseObjectProperties(r t)"},
    {"DisjointObjectProperties", "DisjointObjectProperties(r s)",
     "ObjectPropertyRange(r A)\nObjectPropertyRange(s B)\nDisjointClasses(A B)",
     "ObjectPropertyRange(r A)\nObjectPropertyDomain(s B)\nDisjointClasses(A B)"},
    {"InverseObjectProperties", "InverseObjectProperties(r s)", "EquivalentObjectProperties(r ObjectInverseOf(s))",
     "SubObjectPropertyOf(r ObjectInverseOf(s))"},
    {"ObjectPropertyDomain", "ObjectPropertyDomain(r A)", "SubClassOf(ObjectSomeValuesFrom(r Thing) A)",
     "SubClassOf(ObjectSomeValuesFrom(r B) A)"},
    {"ObjectPropertyRange", "ObjectPropertyRange(r A)", "SubClassOf(Thing ObjectAllValuesFrom(r A))",
     "SubClassOf(Thing ObjectAllValuesFrom(s A))\nSubObjectPropertyOf(s r)"},
    {"FunctionalObjectProperty", "FunctionalObjectProperty(r)", "SubObjectPropertyOf(r s)\nFunctionalObjectProperty(s)",
     "SubObjectPropertyOf(s r)\nFunctionalObjectProperty(s)"},
    {"InverseFunctionalObjectProperty", "InverseFunctionalObjectProperty(r)",
     "InverseObjectProperties(r s)\nFunctionalObjectProperty(s)", "FunctionalObjectProperty(r)"},
    {"ReflexiveObjectProperty", "ReflexiveObjectProperty(r)", "SubClassOf(Thing ObjectHasSelf(r))",
     "SubClassOf(Thing ObjectSomeValuesFrom(r Thing))"},
    {"IrreflexiveObjectProperty", "IrreflexiveObjectProperty(r)", "AsymmetricObjectProperty(r)",
     "SubClassOf(A ObjectComplementOf(ObjectHasSelf(r)))"},
    {"SymmetricObjectProperty", "SymmetricObjectProperty(r)", "InverseObjectProperties(r r)",
     "InverseObjectProperties(r s)"},
    {"AsymmetricObjectProperty", "AsymmetricObjectProperty(r)",
     "ObjectPropertyDomain(r A)\nObjectPropertyRange(r B)\nDisjointClasses(A B)", "IrreflexiveObjectProperty(r)"},
    {"TransitiveObjectProperty", "TransitiveObjectProperty(r)",
     "SubObjectPropertyOf(ObjectPropertyChain(r r) s)\nSubObjectPropertyOf(s r)",
     "SubObjectPropertyOf(ObjectPropertyChain(r r) s)"},
};

const std::vector<Case> data_axioms = {
    {"SubDataPropertyOf", "SubDataPropertyOf(d:p d:q)", "EquivalentDataProperties(d:p d:q)",
     "SubDataPropertyOf(d:q d:p)"},
    {"EquivalentDataProperties", "EquivalentDataProperties(d:p d:q)",
     "SubDataPropertyOf(d:q d:p)\nSubDataPropertyOf(d:p d:q)", "SubDataPropertyOf(d:q d:p)"},
    {"DisjointDataProperties", "DisjointDataProperties(d:p d:q)",
     "DataPropertyRange(d:p x:string)\nDataPropertyRange(d:q x:integer)",
     "DataPropertyRange(d:p x:decimal)\nDataPropertyRange(d:q x:integer)"},
    {"DataPropertyDomain", "DataPropertyDomain(d:p A)", "SubDataPropertyOf(d:p d:q)\nDataPropertyDomain(d:q A)",
     "SubDataPropertyOf(d:q d:p)\nDataPropertyDomain(d:q A)"},
    {"DataPropertyRange", "DataPropertyRange(d:p x:integer)", "DataPropertyRange(d:p x:long)",
     "DataPropertyRange(d:p x:decimal)"},
    {"FunctionalDataProperty", "FunctionalDataProperty(d:p)", "SubDataPropertyOf(d:p d:q)\nFunctionalDataProperty(d:q)",
     "SubDataPropertyOf(d:q d:p)\nFunctionalDataProperty(d:q)"},
    {"HasKeyOfObjectProperties", "HasKey(A r)", "HasKey(B r)\nSubClassOf(A B)", "HasKey(A r s)"},
};

const std::vector<Case> facts = {
    {"SameIndividual", "SameIndividual(i:a i:b)",
     "FunctionalObjectProperty(r)\nObjectPropertyAssertion(r i:c i:a)\nObjectPropertyAssertion(r i:c i:b)",
     "ObjectPropertyAssertion(r i:c i:a)\nObjectPropertyAssertion(r i:c i:b)"},
    {"DifferentIndividuals", "DifferentIndividuals(i:a i:b)",
     "DisjointClasses(A B)\nClassAssertion(A i:a)\nClassAssertion(B i:b)", "ClassAssertion(A i:a)"},
    {"ClassAssertion", "ClassAssertion(A i:a)", "ObjectPropertyDomain(r A)\nObjectPropertyAssertion(r i:a i:b)",
     "ObjectPropertyRange(r A)\nObjectPropertyAssertion(r i:a i:b)"},
    {"ClassAssertionByCases", "ClassAssertion(C i:a)",
     "ClassAssertion(ObjectUnionOf(A B) i:a)\nSubClassOf(A C)\nSubClassOf(B C)",
     "ClassAssertion(ObjectUnionOf(A B) i:a)\nSubClassOf(A C)"},
    {"ObjectPropertyAssertion", "ObjectPropertyAssertion(r i:a i:b)",
     "InverseObjectProperties(r s)\nObjectPropertyAssertion(s i:b i:a)", "ObjectPropertyAssertion(r i:b i:a)"},
    {"NegativeObjectPropertyAssertion", "NegativeObjectPropertyAssertion(r i:a i:b)",
     "ObjectPropertyDomain(r A)\nClassAssertion(ObjectComplementOf(A) i:a)", "ObjectPropertyAssertion(r i:b i:a)"},
    {"DataPropertyAssertion", "DataPropertyAssertion(d:p i:a \"1\"^x:integer)",
     "DataPropertyAssertion(d:p i:a \"01\"^x:int)", "DataPropertyAssertion(d:p i:a \"2\"^x:integer)"},
    {"NegativeDataPropertyAssertion", "NegativeDataPropertyAssertion(d:p i:a \"1\"^x:integer)",
     "FunctionalDataProperty(d:p)\nDataPropertyAssertion(d:p i:a \"2\"^x:integer)",
     "DataPropertyAssertion(d:p i:a \"2\"^x:integer)"},
};

std::string name_of(const testing::TestParamInfo<Case>& one) { return one.param.name; }
INSTANTIATE_TEST_SUITE_P(OfClasses, Conclusion, testing::ValuesIn(class_axioms), name_of);
INSTANTIATE_TEST_SUITE_P(OfObjectProperties, Conclusion, testing::ValuesIn(object_property_axioms), name_of);
INSTANTIATE_TEST_SUITE_P(OfDataProperties, Conclusion, testing::ValuesIn(data_axioms), name_of);
INSTANTIATE_TEST_SUITE_P(OfFacts, Conclusion, testing::ValuesIn(facts), name_of);

TEST(Entailment, AnswersEachConclusionByItself) {
  EXPECT_EQ(answer_to("SubClassOf(A B)", "SubClassOf(A B)\nSubClassOf(B A)\nSubClassOf(A Thing)\nSubClassOf(A C)"),
            "yes, no, yes, no");
}

TEST(Entailment, DeclarationsFollowFromNothing) {
  EXPECT_EQ(answer_to("", "Declaration(A)\nDeclaration(r)\nDeclaration(i:a)"), "yes, yes, yes");
}

TEST(Entailment, WhatStandsInThePremiseInAnotherOrderFollows) {
  EXPECT_EQ(answer_to("DisjointClasses(A B C)\nHasKey(A d:p)", "DisjointClasses(C A B)\nHasKey(A d:p)"), "yes, yes");
}

TEST(Entailment, EverythingIsBelowTheTopPropertyAndNothingBelowTheBottomOne) {
  EXPECT_EQ(answer_to("",
                      "SubObjectPropertyOf(r owl:topObjectProperty)\n"
                      "SubObjectPropertyOf(owl:bottomObjectProperty r)\n"
                      "SubObjectPropertyOf(r owl:bottomObjectProperty)"),
            "yes, yes, no");
}

TEST(Entailment, DoesNotConfuseTheNamesItMakesUpWithThoseOfTheFiles) {
  owl::Ontology source;
  owl::write_into(source, "SubClassOf(A B)", "premise.ofn");
  const owl::FileId file = source.add_file("conclusion.ofn");
  const owl::TermId first = source.named_class("urn:geminga:asked:0");
  const owl::TermId second = source.named_class("urn:geminga:asked:1");
  source.add(owl::AxiomKind::sub_class_of, {first, second}, file, 1);
  const std::vector<std::uint32_t> premise{0};
  const std::vector<std::uint32_t> conclusion{1};
  EXPECT_EQ(entails_each(source, premise, conclusion).front().verdict, Verdict::no);
}

TEST(Entailment, AKeyOfDataPropertiesIsRefutedByTryingAndOtherwiseUndecided) {
  EXPECT_EQ(answer_to("", "HasKey(A d:p)"), "no");
  EXPECT_THAT(answer_to("HasKey(B d:p)\nSubClassOf(A B)", "HasKey(A d:p)"), HasSubstr("unknown: keys of data"));
}

TEST(Entailment, AnAxiomOfTooManyPairsIsUndecided) {
  constexpr std::size_t most = 447;  // 447 * 446 / 2 = 99'681, and one more member is over the limit of 100'000
  static_assert(most * (most - 1) / 2 <= max_pairs_of_members && (most + 1) * most / 2 > max_pairs_of_members);
  const auto refute = [](std::size_t count) {
    owl::Ontology empty;
    Excerpt excerpt(empty, {});
    Challenger challenger(excerpt);
    std::vector<owl::TermId> members;
    for (std::size_t at = 0; at < count; ++at)
      members.push_back(excerpt.source.named_class("urn:" + std::to_string(at)));
    return challenger.refute(owl::AxiomKind::disjoint_classes, members);
  };
  EXPECT_EQ(refute(most - 1).all.size(), (most - 1) * (most - 2) / 2);
  EXPECT_EQ(refute(most).undecided, "");
  EXPECT_THAT(refute(most + 1).undecided, HasSubstr("448 members"));
}

TEST(Subsumption, IsAskedOfExpressionsAndOfSomeAxiomsOnly) {
  owl::Ontology source = owl::written("SubClassOf(A ObjectSomeValuesFrom(r B))\nSubClassOf(B C)");
  const auto named = [&](const std::string& name) { return source.named_class("https://t.example/#" + name); };
  const owl::TermId r = source.object_property("https://t.example/#r");
  const owl::TermId some = source.term(owl::TermKind::object_some_values_from, {r, named("C")});
  const std::vector<std::uint32_t> first{0};
  EXPECT_EQ(entails(source, std::nullopt, named("A"), some).verdict, Verdict::yes);
  EXPECT_EQ(entails(source, first, named("A"), some).verdict, Verdict::no);
  EXPECT_EQ(entails(source, std::nullopt, some, named("A")).verdict, Verdict::no);
  EXPECT_EQ(entails(source, std::nullopt, named("B"), named("C")).verdict, Verdict::yes);
}

TEST(Subsumption, OfExpressionsThatNestTooDeepIsUndecided) {
  owl::Ontology source = owl::written("SubClassOf(A B)");
  const owl::TermId r = source.object_property("https://t.example/#r");
  const owl::TermId a = source.named_class("https://t.example/#A");
  owl::TermId nested = a;
  for (int level = 0; level < 501; ++level) nested = source.term(owl::TermKind::object_some_values_from, {r, nested});
  EXPECT_THAT(entails(source, std::nullopt, a, nested).reason, HasSubstr("over 500 levels"));
  EXPECT_EQ(entails(source, std::nullopt, a, source.term(nested).arguments[1]).verdict, Verdict::no);
}

}  // namespace
}  // namespace geminga::reasoner
