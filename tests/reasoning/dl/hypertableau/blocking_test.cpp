// Which nodes are copies of others, and which only look like it.
#include <gtest/gtest.h>

#include <string>

#include "reasoning/dl/clauses/clausify.hpp"
#include "reasoning/dl/hypertableau/tableau.hpp"
#include "support/written.hpp"

namespace geminga::hypertableau {
namespace {

Verdict verdict_on_a(const std::string& axioms, const QuestionLimits& limits = {}) {
  const owl::Ontology source = owl::written(axioms);
  const auto set = clauses::clausify(source, std::nullopt, {});
  if (!set) return Verdict::unknown;
  Tableau tableau(source, *set, limits);
  for (std::uint32_t at = 0; at < set->concepts.size(); ++at) {
    const clauses::Concept& one = set->concepts[at];
    const bool is_named = one.kind == clauses::ConceptKind::named;
    if (is_named && source.name_of(one.term).ends_with("#A"))
      return tableau.is_satisfiable({clauses::ConceptId{at}}).verdict;
  }
  return Verdict::unknown;
}

/// Each of so many kinds of L asks for a neighbour of each kind.
std::string kinds_beside_kinds(int count) {
  std::string axioms = "SubClassOf(A K0)\n";
  for (int one = 0; one < count; ++one) {
    axioms += "SubClassOf(K" + std::to_string(one) + " L)\n";
    for (int other = 0; other < count; ++other) {
      axioms += "SubClassOf(K" + std::to_string(one) + " ObjectSomeValuesFrom(r K" + std::to_string(other) + "))\n";
    }
  }
  return axioms;
}

/// In A there are a thing in B and D and a thing in B only. Both ask for something in C, the first one first.
const std::string alike =
    "SubClassOf(A ObjectSomeValuesFrom(q ObjectIntersectionOf(B D)))\n"
    "SubClassOf(A ObjectSomeValuesFrom(q ObjectIntersectionOf(B E)))\n"
    "DisjointClasses(D E)\nSubClassOf(B ObjectSomeValuesFrom(r C))\n";

TEST(Blocking, ComparesNoParentsWhereNothingLooksBack) {
  constexpr int kinds = 12;
  // A universal and an at-least look back, but see one neighbour.
  const std::string looks =
      "SubClassOf(K3 ObjectAllValuesFrom(ObjectInverseOf(r) L))\nSubClassOf(K5 ObjectSomeValuesFrom(ObjectInverseOf(r) "
      "M))\n";
  // One node of each kind asks for one of each kind. If parents were compared, it were one for each pair of kinds.
  const QuestionLimits limits{.nodes = std::size_t{4} * kinds * kinds};
  EXPECT_EQ(verdict_on_a(kinds_beside_kinds(kinds) + looks, limits), Verdict::yes);
  // A bound counts the parents of some other class, and an at-least the neighbours of an individual.
  const std::string other = "SubClassOf(N ObjectMaxCardinality(1 ObjectInverseOf(r)))\nClassAssertion(N i:n)\n";
  EXPECT_EQ(verdict_on_a(kinds_beside_kinds(kinds) + looks + other, limits), Verdict::yes);
  EXPECT_EQ(verdict_on_a(kinds_beside_kinds(kinds) + looks + other + "SubClassOf(N ObjectOneOf(i:n))\n", limits),
            Verdict::yes);
}

TEST(Blocking, ComparesParentsThatABoundCounts) {
  const std::string asks = "SubClassOf(C ObjectSomeValuesFrom(ObjectInverseOf(r) ObjectIntersectionOf(B D)))\n";
  EXPECT_EQ(verdict_on_a(alike + asks), Verdict::yes);
  EXPECT_EQ(verdict_on_a(alike + asks + "SubClassOf(C ObjectMaxCardinality(1 ObjectInverseOf(r) B))\n"), Verdict::no);
  EXPECT_EQ(verdict_on_a(alike + asks + "InverseFunctionalObjectProperty(r)\n"), Verdict::no);
  // Six neighbours are asked for, so that five and the parent are too many.
  EXPECT_EQ(verdict_on_a(alike + "SubClassOf(C ObjectMinCardinality(6 ObjectInverseOf(r) ObjectIntersectionOf(B D)))\n"
                                 "SubClassOf(C ObjectMaxCardinality(6 ObjectInverseOf(r) B))\n"),
            Verdict::no);
}

TEST(Blocking, ComparesParentsThatAClauseSeesBesideAChild) {
  const std::string asks = "SubClassOf(C ObjectSomeValuesFrom(s F))\nDisjointClasses(F G)\n";
  const std::string one_of_two =
      "SubClassOf(C ObjectUnionOf(ObjectAllValuesFrom(ObjectInverseOf(r) D) ObjectAllValuesFrom(s G)))\n";
  EXPECT_EQ(verdict_on_a(alike + asks), Verdict::yes);
  EXPECT_EQ(verdict_on_a(alike + asks + one_of_two), Verdict::no);
}

TEST(Blocking, ComparesParentsThatAnAtLeastNeedsBesideANominal) {
  const std::string asks =
      "SubClassOf(C ObjectSomeValuesFrom(ObjectInverseOf(r) ObjectIntersectionOf(B ObjectOneOf(i:d))))\n"
      "SubClassOf(C ObjectMaxCardinality(1 ObjectInverseOf(r) B))\n";
  EXPECT_EQ(verdict_on_a(alike + asks), Verdict::no);
}

}  // namespace
}  // namespace geminga::hypertableau
