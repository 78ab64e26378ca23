// At-leasts that nodes which are there satisfy: how many nodes a question needs, and that none is missing.
#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "reasoning/dl/clauses/clausify.hpp"
#include "reasoning/dl/hypertableau/tableau.hpp"
#include "support/written.hpp"

namespace geminga::hypertableau {
namespace {

/// Whether a model of the axioms is found with so many nodes.
Verdict answer(const std::string& axioms, std::size_t nodes) {
  const owl::Ontology source = owl::written(axioms);
  const auto set = clauses::clausify(source, std::nullopt, {});
  EXPECT_TRUE(set && set->unused.empty());
  Tableau tableau(source, *set, {.nodes = nodes});
  return tableau.is_consistent().verdict;
}

/// Three generations in a line, and what they are called by their relatives.
const std::string line =
    "ObjectPropertyAssertion(hasParent i:a i:b)\nObjectPropertyAssertion(hasParent i:b i:c)\n"
    "ObjectPropertyAssertion(hasSibling i:c i:d)\nClassAssertion(Special i:d)\n"
    "SubObjectPropertyOf(hasParent hasAncestor)\nTransitiveObjectProperty(hasAncestor)\n";
constexpr std::size_t persons = 4;

TEST(Witnesses, AreThoseByWhichAThingIsFoundToBeInAClass) {
  const std::string axioms = line +
                             "EquivalentClasses(Nephew ObjectSomeValuesFrom(hasParent ObjectIntersectionOf("
                             "ObjectSomeValuesFrom(hasParent Thing) ObjectSomeValuesFrom(hasParent "
                             "ObjectSomeValuesFrom(hasSibling Special)))))\n";
  EXPECT_EQ(answer(axioms, persons), Verdict::yes);
}

TEST(Witnesses, AreAtTheEndsOfPaths) {
  const std::string axioms = line +
                             "EquivalentClasses(Far ObjectSomeValuesFrom(hasAncestor "
                             "ObjectSomeValuesFrom(hasSibling Special)))\nClassAssertion(Far i:a)\n";
  EXPECT_EQ(answer(axioms, persons), Verdict::yes);
  EXPECT_EQ(answer(axioms + "ClassAssertion(Far i:c)\n", persons), Verdict::unknown) << "nothing leads from c";
}

TEST(Witnesses, ContradictWhatIsForbiddenOfThem) {
  const std::string axioms = line + "ClassAssertion(ObjectSomeValuesFrom(hasAncestor Special) i:a)\n";
  const std::string none = "ClassAssertion(ObjectAllValuesFrom(hasAncestor ObjectComplementOf(Special)) i:a)\n";
  EXPECT_EQ(answer(axioms, 100), Verdict::yes) << "d is no ancestor, so one is made";
  EXPECT_EQ(answer(axioms + none, 100), Verdict::no);
}

// A name with a universal has more than parts: everything beside its instances is in C.
TEST(Witnesses, AreNotThoseOfWhichMoreWouldFollow) {
  const std::string axioms =
      "ObjectPropertyAssertion(r i:a i:b)\nClassAssertion(A i:b)\nClassAssertion(B i:b)\n"
      "ClassAssertion(ObjectSomeValuesFrom(r ObjectIntersectionOf(A B ObjectAllValuesFrom(s C))) i:a)\n"
      "ObjectPropertyAssertion(s i:b i:c)\nClassAssertion(ObjectComplementOf(C) i:c)\n";
  EXPECT_EQ(answer(axioms, 3), Verdict::unknown) << "b has an s that is no C, so another one is needed";
  EXPECT_EQ(answer(axioms + "FunctionalObjectProperty(r)\n", 100), Verdict::no);
}

// The parent of b is blocked by that of a: they have equal labels, and so have a and b. If what is around a counted for
// the parent of a, the parent of b would live on it. Either of the two may be looked at first.
TEST(Witnesses, OfOneNodeAreNotThoseOfItsCopies) {
  const std::string axioms =
      "InverseObjectProperties(hasParent isParentOf)\nSubClassOf(P ObjectMaxCardinality(1 isParentOf))\n"
      "FunctionalObjectProperty(near)\n"
      "SubClassOf(P ObjectSomeValuesFrom(isParentOf ObjectSomeValuesFrom(near Special)))\n"
      "ClassAssertion(Special i:c)\nClassAssertion(ObjectComplementOf(Special) i:d)\n";
  for (const auto& [first, second] : {std::pair("i:c", "i:d"), std::pair("i:d", "i:c")}) {
    const std::string facts =
        "ClassAssertion(ObjectSomeValuesFrom(hasParent P) i:a)\nClassAssertion(ObjectSomeValuesFrom(hasParent P) i:b)\n"
        "ObjectPropertyAssertion(near i:a " +
        std::string(first) + ")\nObjectPropertyAssertion(near i:b " + second + ")\n";
    EXPECT_EQ(answer(axioms + facts, 100), Verdict::no);
  }
}

// The second person has no name, and is copied where a node is blocked. A path through it counts for no individual.
TEST(Witnesses, OnPathsAreNamed) {
  const std::string axioms =
      "SubClassOf(Person ObjectSomeValuesFrom(hasParent Person))\nClassAssertion(Person i:a)\n"
      "SubObjectPropertyOf(hasParent hasAncestor)\nTransitiveObjectProperty(hasAncestor)\n"
      "SubClassOf(Person ObjectSomeValuesFrom(hasAncestor Saint))\n";
  EXPECT_EQ(answer(axioms, 100), Verdict::yes);
  EXPECT_EQ(answer(axioms + "SubClassOf(Saint Nothing)\n", 100), Verdict::no);
  EXPECT_EQ(answer(axioms + "ClassAssertion(ObjectAllValuesFrom(hasAncestor ObjectComplementOf(Saint)) i:a)\n", 100),
            Verdict::no);
}

// The individual n and its neighbour without a name put x where x has to be, until n turns out to be m, whose
// neighbours are others. Either alternative of E may come first.
TEST(Witnesses, AroundIndividualsAreThereAfterAMerge) {
  const std::string axioms =
      "ClassAssertion(ObjectAllValuesFrom(s ObjectComplementOf(B)) i:m)\nClassAssertion(A i:m)\n"
      "ObjectPropertyAssertion(r i:x i:n)\nClassAssertion(A i:n)\nClassAssertion(ObjectSomeValuesFrom(s E) i:n)\n"
      "ObjectPropertyAssertion(r i:x i:o)\nClassAssertion(ObjectComplementOf(A) i:o)\n"
      "ClassAssertion(ObjectMaxCardinality(2 r) i:x)\n"
      "ClassAssertion(ObjectSomeValuesFrom(g G) i:x)\nSubClassOf(G ObjectUnionOf(G1 G2))\n"
      "SubClassOf(ObjectSomeValuesFrom(g G1) Late)\nSubClassOf(ObjectSomeValuesFrom(g G2) Late)\n"
      "SubClassOf(Late ObjectSomeValuesFrom(r ObjectIntersectionOf(A ObjectSomeValuesFrom(s B))))\n"
      "SubClassOf(Late ObjectSomeValuesFrom(z Z))\nSubClassOf(Z ObjectUnionOf(Z1 Z2))\n"
      "ObjectPropertyAssertion(q i:y i:x)\n"
      "SubClassOf(ObjectSomeValuesFrom(q ObjectSomeValuesFrom(z Z1)) ObjectMaxCardinality(1 t))\n"
      "SubClassOf(ObjectSomeValuesFrom(q ObjectSomeValuesFrom(z Z2)) ObjectMaxCardinality(1 t))\n"
      "ObjectPropertyAssertion(t i:y i:n)\nObjectPropertyAssertion(t i:y i:m)\n";
  EXPECT_EQ(answer(axioms + "SubClassOf(E ObjectUnionOf(B D))\n", 100), Verdict::no);
  EXPECT_EQ(answer(axioms + "SubClassOf(E ObjectUnionOf(D B))\n", 100), Verdict::no);
}

}  // namespace
}  // namespace geminga::hypertableau
