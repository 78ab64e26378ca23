// Classes that are complete although the closure has gaps.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reasoning/dl/consequence/written.hpp"

namespace geminga::consequence {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// The classes in `:` that are settled, in the order of the clauses.
std::vector<std::string> settled_of(std::string_view axioms, const Options& options = {}) {
  const owl::Ontology source = written(axioms);
  const clauses::ClauseSet clauses = clauses_of(source);
  const std::vector<clauses::ConceptId> classes = named_classes(clauses);
  const Closure closure = saturate(source, clauses, classes, options);
  std::vector<std::string> settled;
  for (std::size_t at = 0; at < classes.size(); ++at) {
    const std::string_view name = source.name_of(clauses.concepts[number(classes[at])].term);
    if (closure.is_settled[at] && name.starts_with("https://t.example/#")) settled.emplace_back(name.substr(19));
  }
  std::ranges::sort(settled);
  return settled;
}

TEST(SettledContexts, IsEveryClassWhereThereIsNoGap) {
  EXPECT_THAT(settled_of("SubClassOf(:A ObjectUnionOf(:B :C)) SubClassOf(:B :D)"), ElementsAre("A", "B", "C", "D"));
}

TEST(SettledContexts, IsNoClassThatLeadsToANominal) {
  EXPECT_THAT(settled_of(R"(SubClassOf(:A ObjectOneOf(:a :b)) SubClassOf(:B :A) SubClassOf(:C :D)
                            SubClassOf(:E ObjectSomeValuesFrom(:r ObjectSomeValuesFrom(:r :B)))
                            SubClassOf(:F ObjectUnionOf(:D :E)) SubClassOf(:G ObjectSomeValuesFrom(:r :D)))"),
              ElementsAre("C", "D", "G"));
}

TEST(SettledContexts, IsAClassOfWhichItIsOnlyAskedWhetherItIsANominal) {
  // Nothing in A or B is said to be a.
  EXPECT_THAT(settled_of(R"(SubClassOf(ObjectHasValue(:r :a) :A) SubClassOf(:A ObjectComplementOf(ObjectOneOf(:a)))
                            SubClassOf(:B :A) SubClassOf(:C ObjectHasValue(:r :a)))"),
              ElementsAre("A", "B"));
}

TEST(SettledContexts, IsNoClassWhosePredecessorsMayBeANominal) {
  // An instance of B has an s-successor in A, whose r-neighbours are a: B's instance is. What is said of A for the sake
  // of B is not told apart from what is said of every A.
  EXPECT_THAT(settled_of(R"(SubClassOf(:A ObjectAllValuesFrom(:r ObjectOneOf(:a))) InverseObjectProperties(:r :s)
                            SubClassOf(:B ObjectSomeValuesFrom(:s :A)) SubClassOf(:C ObjectSomeValuesFrom(:s :D)))"),
              ElementsAre("C", "D"));
}

TEST(SettledContexts, IsNoClassWithValuesThatAreNotUnderstood) {
  EXPECT_THAT(
      settled_of(
          R"(SubClassOf(:A DataSomeValuesFrom(:u DatatypeRestriction(xsd:integer xsd:minInclusive "3"^^xsd:integer)))
                            SubClassOf(:B ObjectSomeValuesFrom(:r :A)) SubClassOf(:C DataSomeValuesFrom(:u xsd:string))
                            SubClassOf(:D ObjectSomeValuesFrom(:r :C)))"),
      ElementsAre("C", "D"));
}

TEST(SettledContexts, IsNoClassWithAValueInARangeThatIsNotUnderstood) {
  // The range is in no body of any clause, and is seen all the same.
  EXPECT_THAT(settled_of(R"(DataPropertyRange(:u DatatypeRestriction(xsd:integer xsd:minInclusive "3"^^xsd:integer))
                            SubClassOf(:A DataSomeValuesFrom(:u rdfs:Literal)) SubClassOf(:B DataSomeValuesFrom(:v xsd:string)))"),
              ElementsAre("B"));
}

TEST(SettledContexts, IsEveryClassWhereOnlyFactsAndKeysAreNotUnderstood) {
  EXPECT_THAT(settled_of("HasKey(:A () (:u)) ClassAssertion(:A :a) ClassAssertion(:A :b) SubClassOf(:B :A)"),
              ElementsAre("A", "B"));
  EXPECT_THAT(settled_of("ObjectPropertyAssertion(:r :a :b) SubClassOf(:A ObjectUnionOf(:B :C)) SubClassOf(:B :D)"),
              ElementsAre("A", "B", "C", "D"));
}

constexpr std::string_view by_cases = R"(SubClassOf(:A ObjectUnionOf(:B :C)) SubClassOf(:B :D) SubClassOf(:C :D)
                                         SubClassOf(:E ObjectSomeValuesFrom(:r :A)) SubClassOf(:F :B))";

/// How many conclusions by cases the context of :A has: the least limit under which there is no gap.
std::uint32_t needed_alternatives() {
  const owl::Ontology source = written(by_cases);
  const clauses::ClauseSet clauses = clauses_of(source);
  for (std::uint32_t limit = 0;; ++limit) {
    if (saturate(source, clauses, named_classes(clauses), {.alternatives = limit}).gaps.empty()) return limit;
  }
}

TEST(SettledContexts, IsNoClassThatLeadsToOneWithMoreAlternativesThanAreDerived) {
  const std::uint32_t needed = needed_alternatives();
  ASSERT_GT(needed, 0U);
  EXPECT_THAT(settled_of(by_cases, {.alternatives = needed - 1}), ElementsAre("B", "C", "D", "F"));
  EXPECT_THAT(settled_of(by_cases, {.alternatives = needed}), ElementsAre("A", "B", "C", "D", "E", "F"));
  EXPECT_THAT(settled_of(by_cases, {.alternatives = needed + 1}), ElementsAre("A", "B", "C", "D", "E", "F"));
}

TEST(SettledContexts, IsPlainWhereNoAlternativeIsLeft) {
  // B and F make the covering axiom of A redundant: an instance of F need not be in C.
  const owl::Ontology source = written(by_cases);
  const clauses::ClauseSet clauses = clauses_of(source);
  const std::vector<clauses::ConceptId> classes = named_classes(clauses);
  const Closure closure = saturate(source, clauses, classes, {.alternatives = 0});
  for (std::size_t at = 0; at < classes.size(); ++at) {
    const std::string_view name = source.name_of(clauses.concepts[number(classes[at])].term);
    if (!name.starts_with("https://t.example/#")) continue;
    EXPECT_EQ(closure.is_plain[at], name.back() != 'A' && name.back() != 'E') << name;
  }
}

TEST(SettledContexts, NamesTheGapWhereAlternativesAreNotDerivedAndKeepsWhatHasNone) {
  const owl::Ontology source = written(by_cases);
  const clauses::ClauseSet clauses = clauses_of(source);
  const Closure closure = saturate(source, clauses, named_classes(clauses), {.alternatives = 0});
  EXPECT_THAT(closure.gaps, ElementsAre(alternative_gap));
  EXPECT_THAT(lines_of(source, clauses, closure), ElementsAre("B D", "C D", "F B", "F D"));
}

TEST(SettledContexts, IsNoClassWhereWhatIsNotUnderstoodMayMatterToAny) {
  EXPECT_THAT(settled_of("DataPropertyRange(:u xsd:boolean) SubClassOf(:A DataMinCardinality(3 :u)) SubClassOf(:B :C)"),
              IsEmpty());
  EXPECT_THAT(settled_of("SubClassOf(:A :B) SubClassOf(:B :C) SubClassOf(:C :D)", {.clauses = 3}), IsEmpty());
  // Everything is connected with everything by way of one individual.
  EXPECT_THAT(settled_of("SubClassOf(:A ObjectSomeValuesFrom(owl:topObjectProperty :B)) SubClassOf(:C :D)"), IsEmpty());
}

}  // namespace
}  // namespace geminga::consequence
