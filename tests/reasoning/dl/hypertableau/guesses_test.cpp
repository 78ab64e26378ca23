// How much is guessed in vain: what is known to fail, or to hold, is no guess, and one failure tells little of many
// nodes. Work is counted in steps.
#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "reasoning/dl/clauses/clausify.hpp"
#include "reasoning/dl/hypertableau/tableau.hpp"
#include "support/written.hpp"

namespace geminga::hypertableau {
namespace {

constexpr std::size_t count = 400;
/// Steps are enough for so many facts of each of the families, and for no search.
constexpr std::size_t steps_a_family = 40;

Verdict answer(const std::string& axioms) {
  const owl::Ontology source = owl::written(axioms);
  const auto set = clauses::clausify(source, std::nullopt, {});
  EXPECT_TRUE(set && set->unused.empty());
  Tableau tableau(source, *set, {.steps = steps_a_family * count});
  return tableau.is_consistent().verdict;
}

/// Parents, each with so many children, who are told to differ, or have each another of a few teachers.
std::string families(std::size_t children, bool are_told_to_differ = true) {
  std::string text = "FunctionalObjectProperty(teacher)\nDifferentIndividuals(i:t0 i:t1 i:t2 i:t3 i:t4)\n";
  for (std::size_t family = 0; family < count; ++family) {
    const std::string parent = "i:p" + std::to_string(family);
    std::string all;
    for (std::size_t child = 0; child < children; ++child) {
      const std::string name = parent + "c" + std::to_string(child);
      text += "ClassAssertion(Person " + name + ")\nObjectPropertyAssertion(r " + parent + " " + name + ")\n";
      all += " " + name;
      if (!are_told_to_differ)
        text += "ObjectPropertyAssertion(teacher " + name + " i:t" + std::to_string(child) + ")\n";
    }
    text += "ClassAssertion(Person " + parent + ")\n";
    if (children > 1 && are_told_to_differ) text += "DifferentIndividuals(" + all + ")\n";
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

// Each person asks for an edge to an individual, by which it is in one of two classes. The other one asks for no
// neighbour, so that it would be guessed first, and means much.
TEST(Guesses, AreNotMadeWhereAnIndividualThatIsAskedForDecides) {
  constexpr std::size_t classes = 60;
  std::string text =
      "SubClassOf(Person ObjectHasValue(r i:o))\nSubClassOf(ObjectHasValue(r i:o) E)\n"
      "SubClassOf(Person ObjectUnionOf(E F0))\nSubClassOf(E ObjectSomeValuesFrom(q G))\n";
  for (std::size_t at = 0; at < classes; ++at)
    text += "SubClassOf(F" + std::to_string(at) + " F" + std::to_string(at + 1) + ")\n";
  for (std::size_t at = 0; at < count; ++at) text += "ClassAssertion(Person i:p" + std::to_string(at) + ")\n";
  EXPECT_EQ(answer(text), Verdict::yes);
}

// Nothing says that they differ, and they do: merging two merges their teachers. So that they differ is guessed.
TEST(Guesses, OfChildrenWhoDifferComeBeforeThoseOfEqualOnes) {
  for (const std::size_t children : {2U, 3U, 5U})
    EXPECT_EQ(answer(small_family + families(children, false)), Verdict::yes) << children;
}

TEST(Guesses, OfWhatHoldsComeBeforeThoseOfNewNodes) {
  EXPECT_EQ(answer(small_family + families(1)), Verdict::yes);
  EXPECT_EQ(answer(large_family + families(1)), Verdict::yes);
}

TEST(Guesses, OfAClassThatAsksForMuchComeAfterThatOfANeighbourOutside) {
  // A thing is in Deep if all its parts are in P, and Deep asks for a chain of trees. A part outside of P is less.
  std::string text = "EquivalentClasses(Deep ObjectAllValuesFrom(part P))\n";
  for (int level = 0; level < 12; ++level) {
    const std::string name = level == 0 ? "Deep" : "L" + std::to_string(level);
    for (const char* const way : {"l", "r"})
      text += "SubClassOf(" + name + " ObjectSomeValuesFrom(" + way + std::to_string(level) + " L" +
              std::to_string(level + 1) + "))\n";
    text += "SubClassOf(L" + std::to_string(level) + " ObjectAllValuesFrom(ObjectInverseOf(l" + std::to_string(level) +
            ") M" + std::to_string(level) + "))\n";
  }
  EXPECT_EQ(answer(text), Verdict::yes);
}

TEST(Guesses, NeedNoNeighbourForEachRestrictionThatANeighbourIsOutsideOf) {
  std::string text;
  for (int way = 0; way < 60; ++way) {
    const std::string property = "w" + std::to_string(way);
    text += "SubObjectPropertyOf(" + property + " pairs)\nEquivalentClasses(F" + property +
            " ObjectAllValuesFrom(part ObjectIntersectionOf(Base ObjectSomeValuesFrom(" + property + " Base))))\n";
    text += "ClassAssertion(ObjectComplementOf(F" + property + ") i:a)\n";
  }
  EXPECT_EQ(answer("FunctionalObjectProperty(pairs)\n" + text), Verdict::yes);
}

TEST(Guesses, BesideANeighbourAreWeighedByWhatItIsAskedFor) {
  // All parts of a thing in Whole are in Much, which asks for many things. The part that is there may be outside of
  // Much.
  std::string text = "EquivalentClasses(Whole ObjectAllValuesFrom(part Much))\n";
  for (int at = 0; at < 60; ++at)
    text += "SubClassOf(Much ObjectSomeValuesFrom(s" + std::to_string(at) + " O" + std::to_string(at) + "))\n";
  for (std::size_t at = 0; at < count; ++at)
    text += "ObjectPropertyAssertion(part i:a" + std::to_string(at) + " i:b" + std::to_string(at) + ")\n";
  EXPECT_EQ(answer(text), Verdict::yes);
}

/// Things with a part that is not of the kind of the thing, where each part asks for much. Only so many nodes may be
/// made as there are if one part asks for it and blocks the others.
Answer answer_of_outsiders(const std::function<std::string(std::size_t of)>& kind) {
  constexpr std::size_t things = 60;
  constexpr std::size_t organs = 60;
  std::string text = "ObjectPropertyRange(part Base)\n";
  for (std::size_t at = 0; at < organs; ++at)
    text += "SubClassOf(Base ObjectSomeValuesFrom(s" + std::to_string(at) + " O" + std::to_string(at) + "))\n";
  for (std::size_t at = 0; at < things; ++at) {
    text += "ClassAssertion(ObjectSomeValuesFrom(part ObjectComplementOf(" + kind(at) + ")) i:a" + std::to_string(at) +
            ")\n";
  }
  const owl::Ontology source = owl::written(text);
  const auto set = clauses::clausify(source, std::nullopt, {});
  EXPECT_TRUE(set && set->unused.empty());
  Tableau tableau(source, *set, {.nodes = 10 * (things + organs)});
  return tableau.is_consistent();
}

TEST(Guesses, LeaveNeighboursAlikeOfWhichOnlyADenialIsAsked) {
  const Answer found = answer_of_outsiders([](std::size_t of) { return "K" + std::to_string(of); });
  EXPECT_EQ(found.verdict, Verdict::yes) << found.reason;
}

TEST(Guesses, LeaveNeighboursBlockedThatSatisfyADenialOfWhatIsAroundThem) {
  const Answer found = answer_of_outsiders([](std::size_t of) {
    return "ObjectIntersectionOf(Base ObjectSomeValuesFrom(w" + std::to_string(of) + " Base))";
  });
  EXPECT_EQ(found.verdict, Verdict::yes) << found.reason;
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
  // Man and Woman are defined by a gender, and everything has one gender at most.
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

/// Kinds of which everything has one at most, and parts that may be of many kinds, seen from both ends. Whoever has a
/// part and is not in one of the definitions has a part of another kind.
std::string covers(std::size_t kinds) {
  std::string members;
  std::string text = "ObjectPropertyRange(p Any)\nInverseObjectProperties(p q)\n";
  for (std::size_t at = 0; at < kinds; ++at) members += " K" + std::to_string(at);
  text += "DisjointUnion(Any" + members + ")\n";
  for (std::size_t at = 0; at < kinds; ++at) {
    const auto kind = [&](std::size_t step) { return " K" + std::to_string((at * 7 + step) % kinds); };
    text += "EquivalentClasses(D" + std::to_string(at) + " ObjectIntersectionOf(ObjectSomeValuesFrom(p Any) " +
            "ObjectAllValuesFrom(p ObjectUnionOf(" + kind(1) + kind(4) + kind(9) + kind(16) + "))))\n";
    if (at % 3 == 0) text += "SubClassOf(" + kind(0) + " ObjectSomeValuesFrom(p " + kind(3) + "))\n";
    if (at % 4 != 0) continue;
    text += "SubClassOf(" + kind(5) + " ObjectAllValuesFrom(q ObjectUnionOf(" + kind(2) + kind(6) + kind(8) + ")))\n";
  }
  return text;
}

TEST(Guesses, NeedNoNeighbourForWhatOneThatIsThereIsNot) {
  const owl::Ontology source = owl::written(covers(30));
  const auto set = clauses::clausify(source, std::nullopt, {});
  ASSERT_TRUE(set && set->unused.empty());
  Tableau tableau(source, *set, {.steps = 50'000});
  for (std::uint32_t id = 2; id < set->concepts.size(); ++id) {
    if (set->concepts[id].kind != clauses::ConceptKind::named) continue;
    EXPECT_NE(tableau.is_satisfiable({clauses::ConceptId{id}}).verdict, Verdict::unknown) << id;
  }
}

}  // namespace
}  // namespace geminga::hypertableau
