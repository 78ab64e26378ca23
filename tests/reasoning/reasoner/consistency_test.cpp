// Whether there can be a world, asked of what each engine is there for.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <random>
#include <string>

#include "reasoning/dl/clauses/fact_clauses.hpp"
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

/// The individuals i:0 to i:N-1 all differ: one axiom, or one for each pair.
std::string all_different(std::size_t count, bool by_pairs) {
  std::string text;
  std::string list;
  for (std::size_t one = 0; one < count; ++one) {
    list += " i:" + std::to_string(one);
    for (std::size_t other = 0; by_pairs && other < one; ++other)
      text += "DifferentIndividuals(i:" + std::to_string(other) + " i:" + std::to_string(one) + ")\n";
  }
  return by_pairs ? text : "DifferentIndividuals(" + list.substr(1) + ")\n";
}

TEST(Consistency, CountsAnyNumberOfIndividualsThatDiffer) {
  const std::string most_two =
      "SubClassOf(A ObjectMaxCardinality(2 r))\nSubClassOf(ObjectMinCardinality(2 r) B)\n"
      "ClassAssertion(A i:0)\nObjectPropertyAssertion(r i:0 i:1)\n"
      "ObjectPropertyAssertion(r i:0 i:2)\n";
  for (const std::size_t count :
       {clauses::max_paired_individuals, clauses::max_paired_individuals + 1, std::size_t{6000}}) {
    EXPECT_EQ(consistency_of(all_different(count, false) + most_two), "yes") << count;
    EXPECT_EQ(consistency_of(all_different(count, false) + most_two + "ObjectPropertyAssertion(r i:0 i:3)\n"), "no")
        << count;
    EXPECT_EQ(consistency_of(all_different(count, false) + most_two +
                             "ObjectPropertyAssertion(r i:0 i:2)\n"
                             "ClassAssertion(ObjectComplementOf(B) i:0)\n"),
              "no")
        << count;
  }
  std::string more = "ClassAssertion(ObjectMaxCardinality(599 r) i:0)\n";
  for (unsigned at = 0; at < 600; ++at) more += "ObjectPropertyAssertion(r i:0 i:" + std::to_string(at) + ")\n";
  EXPECT_EQ(consistency_of(all_different(600, false) + more), "no");
}

TEST(Consistency, OfADifferentListIsThatOfItsPairs) {
  const std::size_t count = clauses::max_paired_individuals + 2;
  const std::string list = all_different(count, false);
  const std::string pairs = all_different(count, true);
  std::size_t contradictions = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    std::mt19937 random(seed);
    const auto name = [&] {  // of one in the list, of few so that they meet, or of one outside of it
      const auto number = random() % 12;
      return number < 6 ? "i:" + std::to_string(number * 9) : "i:other" + std::to_string(number % 3);
    };
    std::string facts =
        "SubClassOf(A ObjectMaxCardinality(2 r))\nFunctionalObjectProperty(s)\n"
        "SubClassOf(B ObjectOneOf(i:0 i:9 i:other0))\n";
    for (int at = 0; at < 6; ++at) {
      facts +=
          "ObjectPropertyAssertion(" + std::string(random() % 2 == 0 ? "r" : "s") + ' ' + name() + ' ' + name() + ")\n";
      if (random() % 3 == 0) facts += "SameIndividual(" + name() + ' ' + name() + ")\n";
      if (random() % 2 == 0) facts += "ClassAssertion(" + std::string(random() % 2 == 0 ? "A " : "B ") + name() + ")\n";
    }
    const std::string expected = consistency_of(pairs + facts);
    EXPECT_EQ(consistency_of(list + facts), expected) << facts;
    EXPECT_EQ(consistency_of(list + "DifferentIndividuals(i:0 i:9 i:other1)\n" + facts),
              consistency_of(pairs + "DifferentIndividuals(i:0 i:9 i:other1)\n" + facts))
        << facts;
    contradictions += expected == "no" ? 1U : 0U;
  }
  EXPECT_GT(contradictions, 5U);
  EXPECT_LT(contradictions, 35U);
}

TEST(Consistency, IsLostByAnIndividualThatDiffersFromItself) {
  EXPECT_EQ(consistency_of(all_different(70, false) + "SameIndividual(i:3 i:other)\nSameIndividual(i:4 i:other)\n"),
            "no");
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
