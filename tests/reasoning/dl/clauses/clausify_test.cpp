// Which clauses each construct becomes.
#include "reasoning/dl/clauses/clausify.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "reasoning/dl/clauses/print.hpp"
#include "support/written.hpp"

namespace geminga::clauses {
namespace {

std::string local_name(std::string_view iri) { return std::string(iri.substr(iri.find('#') + 1)); }

/// The clauses and facts, as lines.
std::vector<std::string> lines_of(const owl::Ontology& source) {
  const auto set = clausify(source, std::nullopt, {});
  if (!set) return {set.error().text};
  std::vector<std::string> lines;
  for (const Clause& clause : set->clauses) lines.push_back(print(source, *set, clause, local_name));
  for (const ConceptFact& fact : set->concept_facts) {
    lines.push_back(print(source, *set, fact.of, local_name) + " of " +
                    local_name(source.name_of(set->individuals[number(fact.individual)])));
  }
  for (const Unused& unused : set->unused) lines.push_back("unused: " + std::string(unused.construct));
  std::ranges::sort(lines);
  return lines;
}
std::vector<std::string> lines_of(std::string_view text) { return lines_of(owl::written(text)); }

struct Translated {
  const char* name;
  const char* axioms;
  std::vector<std::string> clauses;
};
void PrintTo(const Translated& one, std::ostream* out) { *out << one.name; }

class Clausification : public testing::TestWithParam<Translated> {};

TEST_P(Clausification, IsAsExpected) {
  EXPECT_EQ(lines_of(GetParam().axioms), GetParam().clauses) << GetParam().axioms;
}

const std::vector<Translated> cases = {
    {"Subclass", "SubClassOf(A B)", {"A(x) -> B(x)"}},
    {"Definition",
     "EquivalentClasses(A ObjectIntersectionOf(B ObjectSomeValuesFrom(r C)))",
     {"A(x) -> >=1 r.C(x)", "A(x) -> B(x)", "B(x), C(y1), r(x,y1) -> A(x)"}},
    {"UnionOnTheLeft", "SubClassOf(ObjectUnionOf(A B) C)", {"A(x) -> C(x)", "B(x) -> C(x)"}},
    {"UnionOnTheRight", "SubClassOf(A ObjectUnionOf(B C))", {"A(x) -> B(x) or C(x)"}},
    {"ComplementOnTheLeft", "SubClassOf(ObjectComplementOf(A) B)", {"true -> A(x) or B(x)"}},
    {"Disjoint", "DisjointClasses(A B)", {"A(x), B(x) -> false"}},
    {"Universal", "SubClassOf(A ObjectAllValuesFrom(r B))", {"A(x), r(x,y1) -> B(y1)"}},
    {"UniversalOverComplement",
     "SubClassOf(A ObjectAllValuesFrom(r ObjectComplementOf(B)))",
     {"A(x), B(y1), r(x,y1) -> false"}},
    {"UniversalOverInverse", "SubClassOf(A ObjectAllValuesFrom(ObjectInverseOf(r) B))", {"A(x), r(y1,x) -> B(y1)"}},
    {"DomainAndRange", "ObjectPropertyDomain(r A)\nObjectPropertyRange(r B)", {"r(x,y1) -> A(x)", "r(y1,x) -> B(x)"}},
    {"RangeOfAPathThatItsEdgesHave",
     "SubObjectPropertyOf(r s)\nTransitiveObjectProperty(s)\nObjectPropertyRange(s B)\nSubClassOf(B A)\n"
     "ObjectPropertyRange(s A)\nSubClassOf(ObjectSomeValuesFrom(s A) C)",
     {"B(x) -> A(x)", "Q2(x) -> C(x)", "r(x,y1) -> s(x,y1)", "s(x,y1) -> Q2(x)", "s(y1,x) -> A(x)", "s(y1,x) -> B(x)"}},
    {"Functional", "FunctionalObjectProperty(r)", {"r(x,y1), r(x,y2) -> y1=y2"}},
    {"AtMost", "SubClassOf(A ObjectMaxCardinality(1 r B))", {"A(x), B(y1), B(y2), r(x,y1), r(x,y2) -> y1=y2"}},
    {"AtMostOfAComplement",
     "SubClassOf(A ObjectMaxCardinality(1 r ObjectComplementOf(B)))",
     {"A(x), r(x,y1), r(x,y2) -> B(y1) or B(y2) or y1=y2"}},
    {"LargeAtMost", "SubClassOf(A ObjectMaxCardinality(9 r B))", {"A(x) -> <=9 r.B(x)"}},
    {"AtLeastOnTheLeft", "SubClassOf(ObjectMinCardinality(2 r) A)", {"r(x,y1), r(x,y2) -> A(x) or y1=y2"}},
    {"Exactly",
     "SubClassOf(A ObjectExactCardinality(1 r B))",
     {"A(x) -> >=1 r.B(x)", "A(x), B(y1), B(y2), r(x,y1), r(x,y2) -> y1=y2"}},
    {"ExactlyNone", "SubClassOf(A ObjectExactCardinality(0 r B))", {"A(x), B(y1), r(x,y1) -> false"}},
    {"NestedExistentials",
     "SubClassOf(ObjectSomeValuesFrom(r ObjectSomeValuesFrom(s A)) B)",
     {"A(y1), s(x,y1) -> Q3(x)", "Q3(y1), r(x,y1) -> B(x)"}},
    {"TwoExistentials",
     "SubClassOf(ObjectIntersectionOf(ObjectSomeValuesFrom(r A) ObjectSomeValuesFrom(s B)) C)",
     {"A(y1), r(x,y1) -> Q3(x)", "B(y1), s(x,y1) -> Q4(x)", "Q3(x), Q4(x) -> C(x)"}},
    {"Nominals",
     "SubClassOf(A ObjectOneOf(i:a i:b))\nSubClassOf(ObjectHasValue(r i:a) B)",
     {"A(x) -> {a}(x) or {b}(x)", "{a}(y1), r(x,y1) -> B(x)"}},
    {"Self", "SubClassOf(A ObjectHasSelf(r))\nIrreflexiveObjectProperty(s)", {"A(x) -> r(x,x)", "s(x,x) -> false"}},
    {"Reflexive", "ReflexiveObjectProperty(r)", {"true -> r(x,x)"}},
    {"Asymmetric", "AsymmetricObjectProperty(r)", {"r(x,y1), r(y1,x) -> false"}},
    {"Symmetric", "SymmetricObjectProperty(r)", {"r(x,y1) -> r(y1,x)"}},
    {"InversesAreOne",
     "InverseObjectProperties(r s)\nSubClassOf(A ObjectSomeValuesFrom(s B))\nSubClassOf(ObjectSomeValuesFrom(r B) A)",
     {"A(x) -> >=1 s.B(x)", "B(y1), s(y1,x) -> A(x)"}},
    {"TransitiveOnTheRight",
     "TransitiveObjectProperty(r)\nSubClassOf(A ObjectAllValuesFrom(r B))",
     {"A(x) -> Q3(x)", "Q3(x), r(x,y1) -> B(y1)", "Q3(x), r(x,y1) -> Q3(y1)"}},
    {"TransitiveOnTheLeft",
     "TransitiveObjectProperty(r)\nSubClassOf(ObjectSomeValuesFrom(r A) B)",
     {"A(y1), r(x,y1) -> Q2(x)", "Q2(x) -> B(x)", "Q2(y1), r(x,y1) -> Q2(x)"}},
    {"IrregularChain",
     "SubObjectPropertyOf(ObjectPropertyChain(r s r) r)\nSubClassOf(A ObjectAllValuesFrom(r B))",
     {"A(x), r(x,y1) -> B(y1)", "unused: an irregular property chain"}},
    {"NumberOfATransitiveProperty",
     "TransitiveObjectProperty(r)\nSubClassOf(A ObjectMaxCardinality(1 r))",
     {"unused: owl:maxCardinality of a property that is not simple"}},
    {"AsymmetryOfATransitiveProperty",
     "TransitiveObjectProperty(r)\nAsymmetricObjectProperty(r)",
     {"r(x,y1), r(y1,x) -> false", "unused: owl:AsymmetricProperty of a property that is not simple"}},
    {"NegativeFact",
     "NegativeObjectPropertyAssertion(r i:a i:b)\nClassAssertion(A i:a)",
     {"A of a", "mark of a of a", "mark of a(x), mark of b(y1), r(x,y1) -> false", "mark of b of b"}},
    {"DataRanges",
     "SubClassOf(A DataSomeValuesFrom(d:u x:integer))\nSubClassOf(DataHasValue(d:u \"1\"^x:integer) B)",
     {"A(x) -> >=1 u.integer(x)", "u(x,y1) -> B(x) or not \"1\"^^integer(y1)"}},
    {"ConjunctionInADisjunction",
     "SubClassOf(A ObjectUnionOf(B ObjectIntersectionOf(C D)))",
     {"A(x) -> B(x) or Q4(x)", "Q4(x) -> C(x)", "Q4(x) -> D(x)"}},
    {"TopObjectProperty",
     "SubClassOf(A ObjectAllValuesFrom(owl:topObjectProperty B))",
     {"A(x) -> Q4(x)", "Q4(x), topObjectProperty(x,y1) -> B(y1)", "Q4(x), topObjectProperty(x,y1) -> Q4(y1)",
      "topObjectProperty(x,y1) -> topObjectProperty(y1,x)", "true -> >=1 topObjectProperty.{?}(x)"}},
};

TEST(ClausifyLimits, LeaveOutAndNameACardinalityThatIsTooLarge) {
  const auto unused_with = [](std::uint32_t limit) {
    const owl::Ontology source = owl::written("SubClassOf(A ObjectMinCardinality(3 r))\nSubClassOf(A B)");
    const auto set = clausify(source, std::nullopt, {}, {}, {.cardinality = limit});
    return set ? set->unused.size() : 99;
  };
  EXPECT_EQ(unused_with(4), 0U);
  EXPECT_EQ(unused_with(3), 0U);
  EXPECT_EQ(unused_with(2), 1U);
}

TEST(ClausifyLimits, RefuseMoreClausesThanTheyAllow) {
  const auto text_with = [](std::size_t limit) {
    const owl::Ontology source = owl::written("SubClassOf(A B)\nSubClassOf(A C)\nSubClassOf(A D)");
    const auto set = clausify(source, std::nullopt, {}, {}, {.clauses = limit});
    return set ? std::string() : set.error().text;
  };
  EXPECT_EQ(text_with(4), "");
  EXPECT_EQ(text_with(3), "");
  EXPECT_EQ(text_with(2), "the axioms need more than 2 clauses");
}

TEST(ClausifyLimits, LeaveOutAndNameChainsWhoseAutomatonIsTooLarge) {
  const auto unused_with = [](std::size_t limit) {
    const owl::Ontology source =
        owl::written("SubObjectPropertyOf(ObjectPropertyChain(r s t) u)\nSubClassOf(A ObjectAllValuesFrom(u B))");
    const auto set = clausify(source, std::nullopt, {}, {}, {.automaton_states = limit});
    return set ? set->unused.size() : 99;
  };
  EXPECT_EQ(unused_with(5), 0U);
  EXPECT_EQ(unused_with(4), 0U);
  EXPECT_EQ(unused_with(3), 1U);
}

TEST(Clausify, DoesNotDependOnTheOrderOfAxioms) {
  const std::vector<std::string> axioms = {
      "EquivalentClasses(A ObjectIntersectionOf(B ObjectSomeValuesFrom(r C)))",
      "SubClassOf(D ObjectUnionOf(A ObjectSomeValuesFrom(s ObjectIntersectionOf(B C))))",
      "SubClassOf(D ObjectUnionOf(A ObjectSomeValuesFrom(s ObjectIntersectionOf(C B))))",
      "TransitiveObjectProperty(s)",
      "SubObjectPropertyOf(ObjectPropertyChain(r s) s)",
      "SubClassOf(C ObjectAllValuesFrom(s ObjectMaxCardinality(2 r B)))",
      "ClassAssertion(ObjectSomeValuesFrom(s D) i:a)",
  };
  std::string forwards;
  std::string backwards;
  for (const std::string& axiom : axioms) {
    forwards += axiom + "\n";
    backwards = axiom + "\n" + backwards;
  }
  EXPECT_EQ(lines_of(forwards), lines_of(backwards));
}

INSTANTIATE_TEST_SUITE_P(Each, Clausification, testing::ValuesIn(cases),
                         [](const auto& one) { return std::string(one.param.name); });

/// As many clauses as DisjointClasses of so many have.
std::size_t clauses_of_disjoint(std::size_t members) {
  std::string axiom = "DisjointClasses(";
  for (std::size_t at = 0; at < members; ++at) axiom += " A" + std::to_string(at);
  return lines_of(axiom + ")").size();
}

TEST(Clausification, OfManyDisjointClassesGrowsWithTheirNumber) {
  EXPECT_EQ(clauses_of_disjoint(63), 63U * 62U / 2);
  EXPECT_EQ(clauses_of_disjoint(64), 64U * 63U / 2);
  // Four groups of 16 and one of one, and what is in each.
  EXPECT_EQ(clauses_of_disjoint(65), 4U * 120U + 65U + 10U);
  EXPECT_LT(clauses_of_disjoint(2000), 2000U * 10U);
}

}  // namespace
}  // namespace geminga::clauses
