// Whether there can be a world, asked of what each engine is there for.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "reasoning/reasoner/reasoner.hpp"
#include "support/written.hpp"

namespace geminga::reasoner {
namespace {

std::string consistency_of(std::string_view text) {
  const Answer answer = is_consistent(owl::written(text));
  if (answer.verdict == Verdict::unknown) return "unknown: " + answer.reason;
  return answer.verdict == Verdict::yes ? "yes" : "no";
}

TEST(Consistency, OfNothingAndOfPlainFactsIsGiven) {
  EXPECT_EQ(consistency_of(""), "yes");
  EXPECT_EQ(consistency_of("ClassAssertion(A i:a)\nDisjointClasses(A B)"), "yes");
}

TEST(Consistency, IsLostWhereAnIndividualIsInNothing) {
  EXPECT_EQ(consistency_of("ClassAssertion(A i:a)\nClassAssertion(B i:a)\nDisjointClasses(A B)"), "no");
  EXPECT_EQ(consistency_of("SubClassOf(Thing Nothing)"), "no");
  EXPECT_EQ(consistency_of("SubClassOf(A Nothing)"), "yes");
}

TEST(Consistency, IsLostByCasesThatAllFail) {
  const std::string cases = "SubClassOf(Thing ObjectUnionOf(A B))\nSubClassOf(A ObjectSomeValuesFrom(r Nothing))\n";
  EXPECT_EQ(consistency_of(cases), "yes");
  EXPECT_EQ(consistency_of(cases + "SubClassOf(B Nothing)"), "no");
}

TEST(Consistency, CountsIndividuals) {
  const std::string two =
      "ClassAssertion(ObjectMaxCardinality(1 r) i:a)\nObjectPropertyAssertion(r i:a i:b)\n"
      "ObjectPropertyAssertion(r i:a i:c)\n";
  EXPECT_EQ(consistency_of(two), "yes");
  EXPECT_EQ(consistency_of(two + "DifferentIndividuals(i:b i:c)"), "no");
}

TEST(Consistency, LooksBackAlongInverses) {
  EXPECT_EQ(consistency_of("ObjectPropertyAssertion(r i:a i:b)\nInverseObjectProperties(r s)\n"
                           "ClassAssertion(ObjectAllValuesFrom(s A) i:b)\nClassAssertion(ObjectComplementOf(A) i:a)"),
            "no");
}

TEST(Consistency, IsLostByToldFactsThoughThePropertyIsNotSimple) {
  const std::string both = "ObjectPropertyAssertion(r i:a i:b)\nObjectPropertyAssertion(r i:b i:a)\n";
  const std::string paths = "TransitiveObjectProperty(r)\n";
  EXPECT_EQ(consistency_of(paths + both + "AsymmetricObjectProperty(r)"), "no");
  EXPECT_EQ(consistency_of(paths + "ObjectPropertyAssertion(r i:a i:a)\nIrreflexiveObjectProperty(r)"), "no");
  EXPECT_EQ(consistency_of(paths + "ObjectPropertyAssertion(r i:a i:b)\nObjectPropertyAssertion(r i:a i:c)\n"
                                   "DifferentIndividuals(i:b i:c)\nFunctionalObjectProperty(r)"),
            "no");
  EXPECT_NE(consistency_of(paths + "ObjectPropertyAssertion(r i:a i:b)\nAsymmetricObjectProperty(r)"), "no");
}

TEST(Consistency, KnowsValues) {
  EXPECT_EQ(consistency_of("FunctionalDataProperty(d:p)\nDataPropertyAssertion(d:p i:a \"1\"^x:integer)\n"
                           "DataPropertyAssertion(d:p i:a \"2\"^x:integer)"),
            "no");
  EXPECT_EQ(consistency_of("FunctionalDataProperty(d:p)\nDataPropertyAssertion(d:p i:a \"1\"^x:integer)\n"
                           "DataPropertyAssertion(d:p i:a \"1.0\"^x:decimal)"),
            "yes");
}

TEST(Consistency, IsLostByMoreValuesThanADatatypeHas) {
  const auto with = [](const std::string& count) {
    return consistency_of("DataPropertyRange(d:u x:byte)\nClassAssertion(DataExactCardinality(" + count +
                          " d:u) i:a)\n");
  };
  EXPECT_EQ(with("255"), "yes");
  EXPECT_EQ(with("256"), "yes");
  EXPECT_EQ(with("257"), "no");
}

TEST(Consistency, ASourceOverItsLimitsIsUndecided) {
  owl::Ontology source({.axioms = 1});
  owl::write_into(source, "SubClassOf(A B)\nSubClassOf(B C)", "a.ofn");
  const Answer answer = is_consistent(source);
  EXPECT_EQ(answer.verdict, Verdict::unknown);
  EXPECT_THAT(answer.reason, testing::HasSubstr("more than 1 axioms"));
}

}  // namespace
}  // namespace geminga::reasoner
