// Bottom locality, construct by construct: which axioms matter for a signature, and which are left out.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "extracted.hpp"
#include "reasoning/modules/module.hpp"
#include "support/written.hpp"

namespace geminga::modules {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

struct Case {
  const char* name;
  const char* axioms;
  std::vector<std::string> signature;
  std::vector<std::uint32_t> lines;  ///< of the module
};

void PrintTo(const Case& one, std::ostream* out) { *out << one.name; }

std::vector<std::uint32_t> lines_for(std::string_view axioms, const std::vector<std::string>& names) {
  std::vector<std::string> signature;
  for (const std::string& name : names) signature.push_back("https://t.example/#" + name);
  return lines_of_module(owl::written(axioms), signature);
}

class Locality : public testing::TestWithParam<Case> {};

TEST_P(Locality, DecidesWhichAxiomsMatter) {
  EXPECT_EQ(lines_for(GetParam().axioms, GetParam().signature), GetParam().lines) << GetParam().axioms;
}

const Case class_cases[] = {
    {"WayUpIsFollowed", "SubClassOf(A B)\nSubClassOf(B C)\nSubClassOf(D B)", {"A"}, {1, 2}},
    {"WayDownIsNotFollowed", "SubClassOf(A B)\nSubClassOf(B C)", {"B"}, {2}},
    {"ThingAboveSaysNothing", "SubClassOf(A Thing)\nSubClassOf(A B)", {"A"}, {2}},
    {"ComplementOfNothingAboveSaysNothing", "SubClassOf(A ObjectUnionOf(B ObjectComplementOf(Nothing)))", {"A"}, {}},
    {"NothingBelowSaysNothing", "SubClassOf(Nothing A)", {"A"}, {}},
    {"EmptySignatureHasNoClassAxioms", "SubClassOf(A B)\nEquivalentClasses(A C)\nDisjointClasses(A B)", {}, {}},
    {"ThingOnTheLeftIsAlwaysThere", "SubClassOf(Thing A)\nSubClassOf(A B)\nSubClassOf(C B)", {}, {1, 2}},
    {"ComplementOnTheLeftIsAlwaysThere", "SubClassOf(ObjectComplementOf(A) B)\nSubClassOf(A C)", {}, {1, 2}},
    {"DefinitionMattersForItsName", "EquivalentClasses(A ObjectIntersectionOf(B C))\nSubClassOf(B D)", {"A"}, {1, 2}},
    {"DefinitionThatNothingCanMeetDoesNotMatter", "EquivalentClasses(A ObjectIntersectionOf(B C))", {"B"}, {}},
    {"DefinitionThatSomethingMeetsMatters", "EquivalentClasses(A ObjectIntersectionOf(B C))", {"B", "C"}, {1}},
    {"UnionOnTheLeftNeedsOnePart", "SubClassOf(ObjectUnionOf(A B) C)", {"B"}, {1}},
    {"IntersectionOnTheLeftNeedsAllParts", "SubClassOf(ObjectIntersectionOf(A B) C)", {"B"}, {}},
    {"DisjointnessNeedsTwo", "DisjointClasses(A B C)", {"C"}, {}},
    {"DisjointnessOfTwoThatAreThere", "DisjointClasses(A B C)", {"A", "C"}, {1}},
    {"DisjointUnionMattersForAPart", "DisjointUnion(A B C)", {"C"}, {1}},
};
INSTANTIATE_TEST_SUITE_P(Classes, Locality, testing::ValuesIn(class_cases),
                         [](const auto& one) { return std::string(one.param.name); });

const Case property_cases[] = {
    {"ExistentialOnTheLeftNeedsItsProperty", "SubClassOf(ObjectSomeValuesFrom(r A) B)", {"A"}, {}},
    {"ExistentialOnTheLeftNeedsItsFiller", "SubClassOf(ObjectSomeValuesFrom(r A) B)", {"r"}, {}},
    {"ExistentialOnTheLeftWithBoth", "SubClassOf(ObjectSomeValuesFrom(r A) B)", {"r", "A"}, {1}},
    {"ExistentialOfTheTopPropertyNeedsItsFiller",
     "SubClassOf(ObjectSomeValuesFrom(owl:topObjectProperty A) B)",
     {"A"},
     {1}},
    {"ExistentialOfTheBottomPropertyIsNothing",
     "SubClassOf(ObjectSomeValuesFrom(owl:bottomObjectProperty A) B)",
     {"A"},
     {}},
    {"UniversalSaysNothingWithoutItsProperty", "SubClassOf(A ObjectAllValuesFrom(r B))", {"A"}, {}},
    {"UniversalMattersWithItsProperty",
     "SubClassOf(A ObjectAllValuesFrom(r B))\nSubClassOf(A ObjectSomeValuesFrom(r C))",
     {"A"},
     {1, 2}},
    {"UniversalOnTheLeftIsAlwaysThere", "SubClassOf(ObjectAllValuesFrom(r Nothing) A)", {}, {1}},
    {"MaximumSaysNothingWithoutItsProperty", "SubClassOf(A ObjectMaxCardinality(1 r B))", {"A"}, {}},
    {"MinimumOfNoneSaysNothing", "SubClassOf(A ObjectMinCardinality(0 r B))", {"A", "r", "B"}, {}},
    {"MinimumOfNoneOnTheLeftIsEverything", "SubClassOf(ObjectMinCardinality(0 r B) A)", {}, {1}},
    {"HierarchyMattersForTheSubProperty", "SubObjectPropertyOf(r s)\nSubObjectPropertyOf(t s)", {"r"}, {1}},
    {"ChainNeedsAllItsParts", "SubObjectPropertyOf(ObjectPropertyChain(r s) t)\nSubObjectPropertyOf(r u)", {"r"}, {2}},
    {"InverseMattersForEitherSide", "InverseObjectProperties(r s)\nTransitiveObjectProperty(s)", {"r"}, {1, 2}},
    {"DomainNeedsItsProperty", "ObjectPropertyDomain(r A)\nObjectPropertyRange(s B)", {"r", "A", "B"}, {1}},
    {"DomainOfThingSaysNothing", "ObjectPropertyDomain(r Thing)", {"r"}, {}},
    {"ReflexivityIsAlwaysThere", "ReflexiveObjectProperty(r)\nTransitiveObjectProperty(s)", {}, {1}},
    {"KeyNeedsItsClass", "HasKey(A r)", {"r"}, {}},
};
INSTANTIATE_TEST_SUITE_P(Properties, Locality, testing::ValuesIn(property_cases),
                         [](const auto& one) { return std::string(one.param.name); });

const Case individual_cases[] = {
    {"FactsAreAlwaysThere",
     "ClassAssertion(A i:a)\nObjectPropertyAssertion(r i:a i:b)\nSameIndividual(i:b i:c)",
     {},
     {1, 2, 3}},
    {"FactsBringTheirNames", "ClassAssertion(A i:a)\nSubClassOf(A B)\nSubClassOf(C B)", {}, {1, 2}},
    {"FactOfThingSaysNothing", "ClassAssertion(Thing i:a)", {}, {}},
    {"NegativeFactNeedsItsProperty", "NegativeObjectPropertyAssertion(r i:a i:b)", {}, {}},
    {"NominalOnTheLeftIsAlwaysThere", "SubClassOf(ObjectOneOf(i:a) A)\nSubClassOf(A B)", {}, {1, 2}},
    {"NominalOnTheRightNeedsTheLeft", "SubClassOf(A ObjectOneOf(i:a))\nSubClassOf(B ObjectOneOf(i:b))", {"A"}, {1}},
    {"ValueOnTheLeftNeedsItsProperty", "SubClassOf(ObjectHasValue(r i:a) A)", {"A"}, {}},
    {"EnumerationIsAlwaysThere", "EquivalentClasses(A ObjectOneOf(i:a i:b))", {}, {1}},
};
INSTANTIATE_TEST_SUITE_P(Individuals, Locality, testing::ValuesIn(individual_cases),
                         [](const auto& one) { return std::string(one.param.name); });

TEST(ModuleTest, GoesFromNearAxiomsToFarOnes) {
  const compiled::Ontology ontology = owl::loaded("SubClassOf(C D)\nSubClassOf(B C)\nSubClassOf(A B)");
  std::vector<std::uint32_t> lines;
  const taxonomy::ClassNumber a[] = {owl::named(ontology, "A")};
  for (const std::uint32_t axiom : extract_module(ontology.module_index(), a))
    lines.push_back(ontology.axioms().axiom_line[axiom]);
  EXPECT_THAT(lines, ElementsAre(3, 2, 1));
  for (const std::size_t most : {0U, 1U, 2U, 3U, 4U})
    EXPECT_EQ(extract_module(ontology.module_index(), a, {}, most).size(), std::min<std::size_t>(most, 3)) << most;
}

TEST(ModuleTest, HasNoDeclarations) {
  owl::Ontology source = owl::written("SubClassOf(A B)");
  const owl::TermId declared[] = {source.named_class("https://t.example/#A")};
  source.add(owl::AxiomKind::declaration, declared, owl::FileId{0}, 2);
  EXPECT_THAT(lines_of_module(source, {"https://t.example/#A"}), ElementsAre(1));
}

TEST(ModuleTest, HasNoTermForAClassThatNoAxiomUses) {
  const compiled::Ontology ontology = owl::loaded("SubClassOf(A B)");
  EXPECT_TRUE(ontology.module_index().term_of(owl::named(ontology, "A")));
  EXPECT_FALSE(ontology.module_index().term_of(taxonomy::ClassNumber{ontology.class_count()}));
}

/// `ObjectUnionOf(A0 ... An)` below a class: the test looks at the union, then at each of the n parts.
std::string union_of(std::uint32_t parts) {
  std::string text = "SubClassOf(ObjectUnionOf(";
  for (std::uint32_t part = 0; part < parts; ++part) text += "A" + std::to_string(part) + " ";
  return text + ") B)";
}

TEST(ModuleTest, TakesAnAxiomOfMoreTermsThanAreLookedAt) {
  EXPECT_THAT(lines_for(union_of(max_terms_looked_at - 2), {}), IsEmpty());
  EXPECT_THAT(lines_for(union_of(max_terms_looked_at - 1), {}), IsEmpty());
  EXPECT_THAT(lines_for(union_of(max_terms_looked_at), {}), ElementsAre(1));
}

}  // namespace
}  // namespace geminga::modules
