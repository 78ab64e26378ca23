// How much is guessed in vain: what is known to fail, or to hold, is no guess, and one failure tells little of many
// nodes. Work is counted in steps.
#include <gtest/gtest.h>

#include <string>

#include "clauses/clausify.hpp"
#include "el/written.hpp"
#include "tableau/tableau.hpp"

namespace geminga::tableau {
namespace {

constexpr std::size_t count = 400;
/// Steps are enough for so many facts of each of the families, and for no search.
constexpr std::size_t steps_a_family = 40;

Verdict answer(const std::string& axioms) {
  const el::OntologySource source = el::written(axioms);
  const auto set = clauses::clausify(source, std::nullopt, {});
  EXPECT_TRUE(set && set->unused.empty());
  Tableau tableau(source, *set, {.steps = steps_a_family * count});
  return tableau.is_consistent().verdict;
}

/// Parents, each with so many children that are known to differ.
std::string families(std::size_t children) {
  std::string text;
  for (std::size_t family = 0; family < count; ++family) {
    const std::string parent = "i:p" + std::to_string(family);
    std::string all;
    for (std::size_t child = 0; child < children; ++child) {
      const std::string name = parent + "c" + std::to_string(child);
      text += "ClassAssertion(Person " + name + ")\nObjectPropertyAssertion(r " + parent + " " + name + ")\n";
      all += " " + name;
    }
    text += "ClassAssertion(Person " + parent + ")\n";
    if (children > 1) text += "DifferentIndividuals(" + all + ")\n";
  }
  return text;
}

const char* const small_family =
    "EquivalentClasses(Small ObjectIntersectionOf(Person ObjectMinCardinality(1 r Person) "
    "ObjectMaxCardinality(2 r Person)))\n";
const char* const large_family =
    "EquivalentClasses(Large ObjectIntersectionOf(Person ObjectMinCardinality(4 r Person)))\n"
    "InverseObjectProperties(r q)\nClassAssertion(ObjectOneOf(i:someone) i:someone)\n";

TEST(Guesses, AreNotMadeWhereABoundIsExceeded) {
  EXPECT_EQ(answer(small_family + families(4)), Verdict::yes);
  EXPECT_EQ(answer(large_family + families(4)), Verdict::yes);
}

TEST(Guesses, OfWhatHoldsComeBeforeThoseOfNewNodes) {
  EXPECT_EQ(answer(small_family + families(1)), Verdict::yes);
  EXPECT_EQ(answer(large_family + families(1)), Verdict::yes);
}

TEST(Guesses, AreNotTurnedForAllByOneFailure) {
  // The first may not be small, for a reason that comes late.
  const std::string late =
      "SubClassOf(Small ObjectSomeValuesFrom(s ObjectSomeValuesFrom(s Proof)))\n"
      "SubClassOf(ObjectSomeValuesFrom(s ObjectSomeValuesFrom(s Proof)) Judged)\n"
      "ClassAssertion(ObjectComplementOf(Judged) i:p0)\n";
  EXPECT_EQ(answer(small_family + late + families(1)), Verdict::yes);
}

TEST(Guesses, AreSeenToFailByTheNeighbourThatIsThere) {
  // Who is a man or a woman is so by a gender, of which there is one.
  std::string text =
      "FunctionalObjectProperty(g)\nDisjointClasses(Male Female)\nSubClassOf(Man ObjectSomeValuesFrom(g Male))\n"
      "SubClassOf(Woman ObjectSomeValuesFrom(g Female))\nSubClassOf(Spouse ObjectUnionOf(Man Woman))\n";
  for (std::size_t at = 0; at < count; ++at) {
    const std::string name = "i:p" + std::to_string(at);
    text += "ClassAssertion(Spouse " + name + ")\nObjectPropertyAssertion(g " + name +
            (at % 2 == 0 ? " i:male)\n" : " i:female)\n");
  }
  EXPECT_EQ(answer(text + "ClassAssertion(Male i:male)\nClassAssertion(Female i:female)\n"), Verdict::yes);
}

}  // namespace
}  // namespace geminga::tableau
