// Number restrictions that are counted before neighbours are made: lemmas 1 and 2 of
// src/reasoning/dl/hypertableau/README.md, and where they do not hold.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "reasoning/dl/clauses/clausify.hpp"
#include "reasoning/dl/clauses/counted_neighbours.hpp"
#include "reasoning/dl/hypertableau/tableau.hpp"
#include "support/written.hpp"

namespace geminga::hypertableau {
namespace {

/// Whether the class A may have an instance.
Verdict verdict_of(const std::string& text, const QuestionLimits& limits = {}) {
  owl::Ontology source = owl::written(text);
  const std::vector<owl::TermId> asked{source.named_class("https://t.example/#A")};
  const auto set = clauses::clausify(source, std::nullopt, asked);
  if (!set || !set->unused.empty()) {
    ADD_FAILURE() << "not all axioms have clauses";
    return Verdict::unknown;
  }
  Tableau tableau(source, *set, limits);
  return tableau.is_satisfiable({set->queries[0]}).verdict;
}

/// The numbers that are as good as those of the at-leasts.
std::vector<std::uint32_t> enough(const std::string& text) {
  const owl::Ontology source = owl::written(text);
  const auto set = clauses::clausify(source, std::nullopt, {});
  const clauses::CountedNeighbours counted(*set, clauses::UsedAtMosts::all);
  std::vector<std::uint32_t> found;
  for (const clauses::AtLeast& one : set->at_leasts) found.push_back(counted.enough(one));
  return found;
}

using Counts = std::vector<std::uint32_t>;

const std::string six = "SubClassOf(A ObjectMinCardinality(6 r B))\n";
constexpr QuestionLimits few_nodes{.nodes = 100, .steps = 2'000};

TEST(CountedNeighbours, AreOneMoreThanAllAtMostsCount) {
  const std::string two = "SubClassOf(A ObjectMaxCardinality(2 r B))\n";
  EXPECT_EQ(enough(six), Counts{1});
  EXPECT_EQ(enough(six + "SubClassOf(A ObjectMaxCardinality(2 s B))\n"), Counts{1});
  EXPECT_EQ(enough(six + two), Counts{3});
  EXPECT_EQ(enough(six + two + "SubClassOf(A ObjectMaxCardinality(1 r B))\n"), Counts{3});
  EXPECT_EQ(enough(six + two + "SubClassOf(A ObjectMaxCardinality(1 r C))\n"), Counts{4});
  const std::string inclusion = "SubObjectPropertyOf(r s)\n";
  EXPECT_EQ(enough(six + inclusion + "SubClassOf(A ObjectMaxCardinality(3 s))\n"), Counts{4});
  EXPECT_EQ(enough(six + inclusion + "SubClassOf(A ObjectMaxCardinality(9 s))\n"), Counts{6});
}

TEST(CountedNeighbours, AreAllThatAreAskedForIfThereAreNominals) {
  EXPECT_EQ(enough(six + "SubClassOf(B ObjectOneOf(i:a i:b))\n"), Counts{6});
}

TEST(CountedNeighbours, AreThoseOfEveryPropertyIfAnInverseIsCounted) {
  EXPECT_EQ(enough(six + "InverseFunctionalObjectProperty(r)\nSubClassOf(A ObjectMaxCardinality(2 s))\n"), Counts{4});
}

TEST(LargeNumbers, NeedNoLargeModel) {
  EXPECT_EQ(verdict_of("SubClassOf(A ObjectMinCardinality(6000 r B))\n", few_nodes), Verdict::yes);
}

TEST(LargeNumbers, MayBeExact) {
  EXPECT_EQ(verdict_of("SubClassOf(A ObjectExactCardinality(6000 r B))\n", {.steps = 200'000}), Verdict::yes);
  EXPECT_EQ(verdict_of("SubClassOf(A DataExactCardinality(2000 d:u))\n", {.steps = 200'000}), Verdict::yes);
}

TEST(LargeNumbers, ContradictEachOtherWithoutNeighbours) {
  const std::string at_least = "SubClassOf(A ObjectMinCardinality(6000 r B))\n";
  EXPECT_EQ(verdict_of(at_least + "SubClassOf(A ObjectMaxCardinality(5999 r B))\n", few_nodes), Verdict::no);
  EXPECT_EQ(verdict_of(at_least + "SubClassOf(A ObjectMaxCardinality(5999 r))\n", few_nodes), Verdict::no);
  EXPECT_EQ(verdict_of(at_least + "SubObjectPropertyOf(r s)\nSubClassOf(B C)\n"
                                  "SubClassOf(A ObjectMaxCardinality(5999 s C))\n",
                       few_nodes),
            Verdict::no);
  EXPECT_EQ(
      verdict_of("SubClassOf(A DataMinCardinality(600 d:u))\nSubClassOf(A DataMaxCardinality(599 d:u))\n", few_nodes),
      Verdict::no);
}

TEST(LargeNumbers, OfUnionsAreComparedWithWhatAllAlternativesAreIn) {
  const std::string of_some = "SubClassOf(A ObjectMinCardinality(600 r ObjectUnionOf(B C D)))\n";
  const std::string more = "SubClassOf(A ObjectMaxCardinality(599 r ObjectUnionOf(F D C B E)))\n";
  EXPECT_EQ(verdict_of(of_some + more, few_nodes), Verdict::no);
  const std::string nested = "SubClassOf(A ObjectMaxCardinality(599 r F))\nSubClassOf(B F)\nSubClassOf(C F)\n";
  EXPECT_EQ(verdict_of(of_some + nested + "EquivalentClasses(D ObjectUnionOf(B E))\nSubClassOf(E C)\n", few_nodes),
            Verdict::no);
  EXPECT_EQ(verdict_of("SubClassOf(A ObjectMinCardinality(6 r ObjectUnionOf(B C)))\n"
                       "SubClassOf(A ObjectMaxCardinality(5 r ObjectUnionOf(B D)))\n"),
            Verdict::yes);
}

TEST(LargeNumbers, OfKindsThatExcludeEachOtherAddUp) {
  const std::string kinds =
      "DisjointClasses(B C D)\nSubClassOf(A ObjectMinCardinality(200 r B))\n"
      "SubClassOf(A ObjectMinCardinality(200 s C))\nSubObjectPropertyOf(s r)\n";
  const std::string third = "SubClassOf(A ObjectMinCardinality(200 r D))\n";
  const std::string most = "SubClassOf(A ObjectMaxCardinality(599 r))\n";
  EXPECT_EQ(verdict_of(kinds + third + most, few_nodes), Verdict::no);
  EXPECT_EQ(verdict_of(kinds + most +
                           "SubClassOf(A ObjectUnionOf(E F))\nSubClassOf(E ObjectMinCardinality(200 r D))\n"
                           "SubClassOf(F ObjectMinCardinality(201 r D))\n",
                       few_nodes),
            Verdict::no);
  EXPECT_EQ(verdict_of("SubClassOf(A ObjectMinCardinality(3 r B))\nSubClassOf(A ObjectMinCardinality(3 r C))\n"
                       "SubClassOf(A ObjectMaxCardinality(5 r))\n"),
            Verdict::yes)
      << "a neighbour may be of both kinds";
  EXPECT_EQ(verdict_of("DisjointClasses(B C)\nSubClassOf(A ObjectMinCardinality(3 r B))\n"
                       "SubClassOf(A ObjectMinCardinality(3 r C))\nSubClassOf(A ObjectMaxCardinality(6 r))\n"),
            Verdict::yes);
}

TEST(LargeNumbers, OfPropertiesThatExcludeEachOtherAddUp) {
  const std::string apart = "DisjointObjectProperties(q s)\nSubObjectPropertyOf(q r)\nSubObjectPropertyOf(s r)\n";
  const auto asked = [](const std::string& q, const std::string& s, unsigned most) {
    return "SubClassOf(A ObjectMinCardinality(300 " + q + " B))\nSubClassOf(A ObjectMinCardinality(301 " + s +
           "))\nSubClassOf(A ObjectMaxCardinality(" + std::to_string(most) + " r))\n";
  };
  EXPECT_EQ(verdict_of(apart + asked("q", "s", 600), few_nodes), Verdict::no);
  EXPECT_EQ(verdict_of(apart + "SubObjectPropertyOf(p s)\n" + asked("q", "p", 600), few_nodes), Verdict::no);
  EXPECT_EQ(verdict_of("DisjointObjectProperties(ObjectInverseOf(q) s)\nSubObjectPropertyOf(ObjectInverseOf(q) r)\n"
                       "SubObjectPropertyOf(s r)\n" +
                           asked("ObjectInverseOf(q)", "s", 600),
                       few_nodes),
            Verdict::no);
  EXPECT_EQ(verdict_of("SubObjectPropertyOf(q r)\nSubObjectPropertyOf(s r)\n"
                       "DisjointObjectProperties(ObjectInverseOf(q) s)\nSubClassOf(A ObjectMinCardinality(3 q))\n"
                       "SubClassOf(A ObjectMinCardinality(3 s))\nSubClassOf(A ObjectMaxCardinality(5 r))\n"),
            Verdict::yes)
      << "the inverse of one is apart from the other";
  constexpr QuestionLimits few_steps{.nodes = 1000, .steps = 400'000};
  EXPECT_EQ(verdict_of(apart + asked("q", "s", 601), few_steps), Verdict::yes);
  const std::string values =
      "DisjointDataProperties(d:q d:s)\nSubDataPropertyOf(d:q d:r)\nSubDataPropertyOf(d:s d:r)\n"
      "SubClassOf(A DataMinCardinality(300 d:q))\nSubClassOf(A DataMinCardinality(301 d:s))\n";
  EXPECT_EQ(verdict_of(values + "SubClassOf(A DataMaxCardinality(600 d:r))\n", few_nodes), Verdict::no);
  EXPECT_EQ(verdict_of(values + "SubClassOf(A DataMaxCardinality(601 d:r))\n", few_steps), Verdict::yes);
}

TEST(LargeNumbers, OfAUnionAreLimitedByTheBoundsOfItsAlternatives) {
  const std::string bounds = "SubClassOf(A ObjectMaxCardinality(20 r B))\nSubClassOf(A ObjectMaxCardinality(30 s C))\n";
  const std::string fifty = "SubObjectPropertyOf(r s)\nSubClassOf(A ObjectMinCardinality(50 r D))\n";
  const std::string more = "SubObjectPropertyOf(r s)\nSubClassOf(A ObjectMinCardinality(51 r D))\n";
  const std::string none = "SubClassOf(A ObjectMaxCardinality(0 r E))\n";
  const std::string either = "SubClassOf(D ObjectUnionOf(B C))\n";
  const std::string nested = "SubClassOf(D ObjectUnionOf(B F))\nSubClassOf(F ObjectUnionOf(C E))\n";
  EXPECT_EQ(verdict_of(bounds + more + either, few_nodes), Verdict::no);
  EXPECT_EQ(verdict_of(bounds + more + nested + none, few_nodes), Verdict::no);
  EXPECT_EQ(verdict_of(bounds + more + "ObjectPropertyRange(s ObjectUnionOf(B C))\n", few_nodes), Verdict::no);
  EXPECT_EQ(verdict_of(bounds + more + "SubClassOf(A ObjectAllValuesFrom(r ObjectUnionOf(C B)))\n", few_nodes),
            Verdict::no);
  EXPECT_EQ(verdict_of(more + "SubClassOf(D ObjectUnionOf(B C))\nSubClassOf(B E)\nSubClassOf(C E)\n"
                              "SubClassOf(A ObjectMaxCardinality(50 r E))\n",
                       few_nodes),
            Verdict::no);
  constexpr QuestionLimits few_steps{.nodes = 200, .steps = 60'000};
  for (const std::string& cover : {either, nested + none, nested})
    EXPECT_EQ(verdict_of(bounds + fifty + cover, few_steps), Verdict::yes) << cover;
  EXPECT_EQ(verdict_of(bounds + more + nested, few_steps), Verdict::yes);
}

TEST(LargeNumbers, OfAUnionAreLimitedByBoundsOfConceptsThatItsAlternativesAreInTogether) {
  const std::string fifty =
      "SubClassOf(A ObjectMinCardinality(50 r D))\nSubClassOf(D ObjectUnionOf(B C))\n"
      "SubClassOf(A ObjectMaxCardinality(20 r C))\n";
  const auto both = [](unsigned most) {
    return "SubClassOf(A ObjectMaxCardinality(" + std::to_string(most) + " r ObjectIntersectionOf(B D)))\n";
  };
  EXPECT_EQ(verdict_of(fifty + both(29), few_nodes), Verdict::no);
  EXPECT_EQ(verdict_of(fifty + both(30), {.nodes = 200, .steps = 60'000}), Verdict::yes);
  EXPECT_EQ(verdict_of(fifty + "SubClassOf(ObjectIntersectionOf(B D) E)\nObjectPropertyRange(r F)\n"
                               "SubClassOf(ObjectIntersectionOf(E F) G)\nSubClassOf(A ObjectMaxCardinality(29 r G))\n",
                       few_nodes),
            Verdict::no);
}

TEST(LargeNumbers, OfTheWholeAreMetByTheNeighboursOfItsParts) {
  const std::string parts =
      "DisjointClasses(B C D)\nSubClassOf(A ObjectExactCardinality(66 r B))\n"
      "SubClassOf(A ObjectExactCardinality(32 r C))\nSubClassOf(A ObjectMinCardinality(27 r ObjectUnionOf(B D)))\n";
  constexpr QuestionLimits few_steps{.nodes = 200, .steps = 50'000};
  EXPECT_EQ(verdict_of(parts + "SubClassOf(A ObjectExactCardinality(128 r))\n", few_steps), Verdict::yes);
  EXPECT_EQ(verdict_of(parts + "SubClassOf(A ObjectExactCardinality(98 r))\n", few_steps), Verdict::yes);
  EXPECT_EQ(verdict_of(parts + "SubClassOf(A ObjectMaxCardinality(97 r))\n", few_steps), Verdict::no);
}

TEST(LargeNumbers, OfValuesInARangeAreCounted) {
  const std::string values = "SubClassOf(A DataMinCardinality(7 d:u x:integer))\n";
  EXPECT_EQ(verdict_of(values + "SubClassOf(A DataMaxCardinality(6 d:u x:integer))\n"), Verdict::no);
  EXPECT_EQ(verdict_of(values + "SubClassOf(A DataMaxCardinality(6 d:u x:string))\n"), Verdict::yes);
  EXPECT_EQ(verdict_of(values + "SubClassOf(A DataMaxCardinality(6 d:u DataOneOf(\"1\"^x:integer \"2\"^x:integer)))\n"
                                "SubClassOf(A DataAllValuesFrom(d:v DataComplementOf(DataOneOf(\"2\"^x:integer "
                                "\"1\"^x:integer))))\n"),
            Verdict::yes);
}

TEST(LargeNumbers, DecideAHundredDefinitionsWithoutAChoice) {
  std::string text = "SubClassOf(A C30)\n";
  for (int number = 1; number <= 100; ++number) {
    const std::string exact = "ObjectExactCardinality(" + std::to_string(number) + " r B)";
    text += "EquivalentClasses(C" + std::to_string(number) + " ObjectIntersectionOf(D " + exact + "))\n";
  }
  EXPECT_EQ(verdict_of(text, {.nodes = 100, .steps = 5'000}), Verdict::yes);
  EXPECT_EQ(verdict_of(text + "SubClassOf(A C31)\n", few_nodes), Verdict::no);
}

TEST(Neighbours, MayEachBeCountedByOneOfSeveralAtMosts) {
  const std::string bounds =
      "SubClassOf(A ObjectMaxCardinality(1 r C))\nSubClassOf(A ObjectMaxCardinality(1 r D))\n"
      "SubClassOf(B ObjectUnionOf(C D))\n";
  for (const bool counts : {true, false}) {
    EXPECT_EQ(verdict_of(bounds + "SubClassOf(A ObjectMinCardinality(2 r B))\n", {.counts = counts}), Verdict::yes);
    EXPECT_EQ(verdict_of(bounds + "SubClassOf(A ObjectMinCardinality(7 r B))\n", {.counts = counts}), Verdict::no);
  }
}

// Two of three that were made together are the two that are named; the third differs from these.
TEST(Neighbours, StayDifferentWhenTheyAreMergedWithOthers) {
  const std::string facts =
      "ClassAssertion(ObjectMinCardinality(3 r B) i:a)\nClassAssertion(ObjectMaxCardinality(3 r) i:a)\n"
      "ObjectPropertyAssertion(r i:a i:b)\nObjectPropertyAssertion(r i:a i:c)\nDifferentIndividuals(i:b i:c)\n";
  for (const bool counts : {true, false}) {
    EXPECT_EQ(verdict_of(facts + "SubClassOf(A B)\n", {.counts = counts}), Verdict::yes);
    EXPECT_EQ(verdict_of(facts + "ClassAssertion(ObjectComplementOf(B) i:b)\n", {.counts = counts}), Verdict::no);
    EXPECT_EQ(verdict_of(facts + "ClassAssertion(C i:b)\nClassAssertion(C i:c)\nClassAssertion(D i:a)\n"
                                 "SubClassOf(D ObjectMinCardinality(2 r ObjectComplementOf(C)))\n",
                         {.counts = counts}),
              Verdict::no);
  }
}

// Each at-least alone would make neighbours of its own. Whether they can be the same is a guess, and may be wrong.
TEST(Neighbours, OfOneAtLeastMayBeThoseOfAnother) {
  const std::string numbers =
      "SubClassOf(A ObjectMinCardinality(40 r B))\nSubClassOf(A ObjectMinCardinality(40 s C))\n"
      "SubObjectPropertyOf(r t)\nSubObjectPropertyOf(s t)\n";
  const std::string apart =
      "SubClassOf(C ObjectSomeValuesFrom(q D))\nSubClassOf(B ObjectAllValuesFrom(q E))\n"
      "DisjointClasses(D E)\n";
  constexpr QuestionLimits few_steps{.nodes = 200, .steps = 60'000};
  EXPECT_EQ(verdict_of(numbers + "SubClassOf(A ObjectMaxCardinality(40 t))\n", few_steps), Verdict::yes);
  EXPECT_EQ(verdict_of(numbers + "SubClassOf(A ObjectMaxCardinality(80 t))\n" + apart, few_steps), Verdict::yes);
  EXPECT_EQ(verdict_of("SubClassOf(A ObjectMinCardinality(2 r B))\nSubClassOf(A ObjectMinCardinality(2 r C))\n"
                       "SubClassOf(A ObjectMaxCardinality(3 r))\n" +
                       apart),
            Verdict::no);
}

TEST(Neighbours, AreCountedIfTheyAreNamed) {
  const std::string names = "EquivalentClasses(B ObjectOneOf(i:a i:b))\n";
  EXPECT_EQ(verdict_of(names + "SubClassOf(A ObjectMinCardinality(2 r B))\n"), Verdict::yes);
  EXPECT_EQ(verdict_of(names + "SubClassOf(A ObjectMinCardinality(3 r B))\n"), Verdict::no);
}

TEST(Neighbours, AreCountedIfTheyAreValues) {
  const std::string range = "DataPropertyRange(d:u DataOneOf(\"1\"^x:integer \"2\"^x:integer))\n";
  EXPECT_EQ(verdict_of(range + "SubClassOf(A DataMinCardinality(2 d:u))\n"), Verdict::yes);
  EXPECT_EQ(verdict_of(range + "SubClassOf(A DataMinCardinality(3 d:u))\n"), Verdict::no);
}

}  // namespace
}  // namespace geminga::hypertableau
