// Facts that follow, what a limit leaves open, and the instances of expressions.
#include "reasoning/realization/realization.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>

#include "reasoning/reasoner/reasoner.hpp"
#include "reasoning/syntax/functional/read.hpp"
#include "support/written.hpp"

namespace geminga::realization {
namespace {

using owl::written;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Not;

std::string local(std::string_view iri) { return std::string(iri.substr(iri.find('#') + 1)); }

Realization realized(owl::Ontology& source, const Options& options = {.with_facts = true}) {
  const auto classification = reasoner::classify(source);
  EXPECT_TRUE(classification);
  return realize(source, *classification, options);
}

/// Of an ontology that nothing else is asked of.
Realization realized(std::string_view text) {
  owl::Ontology source = written(text);
  return realized(source);
}

/// `subject property object` with local names.
std::vector<std::string> facts_of(std::string_view text) {
  owl::Ontology source = written(text);
  const Realization found = realized(source);
  EXPECT_THAT(found.gaps, IsEmpty());
  std::vector<std::string> lines;
  for (const Fact& fact : found.facts) {
    lines.push_back(local(source.name_of(fact.subject)) + ' ' + local(source.name_of(fact.property)) + ' ' +
                    local(source.name_of(fact.object)));
  }
  std::ranges::sort(lines);
  return lines;
}

TEST(Facts, FollowByInversesAndSuperProperties) {
  EXPECT_THAT(facts_of("ObjectPropertyAssertion(r i:a i:b)\nInverseObjectProperties(r s)\nSubObjectPropertyOf(s t)\n"),
              ElementsAre("a r b", "b s a", "b t a"));
}

TEST(Facts, FollowByTransitivityAndChains) {
  EXPECT_THAT(facts_of("ObjectPropertyAssertion(r i:a i:b)\nObjectPropertyAssertion(r i:b i:c)\n"
                       "TransitiveObjectProperty(r)\n"),
              ElementsAre("a r b", "a r c", "b r c"));
  EXPECT_THAT(facts_of("ObjectPropertyAssertion(r i:a i:b)\nObjectPropertyAssertion(s i:b i:c)\n"
                       "SubObjectPropertyOf(ObjectPropertyChain(r s) t)\n"),
              ElementsAre("a r b", "a t c", "b s c"));
}

TEST(Facts, AreSharedByIndividualsThatAreTheSame) {
  EXPECT_THAT(facts_of("ObjectPropertyAssertion(r i:a i:b)\nObjectPropertyAssertion(r i:a i:c)\n"
                       "FunctionalObjectProperty(r)\nDataPropertyAssertion(d:u i:b \"1\"^x:integer)\n"),
              ElementsAre("a r b", "a r c", "b u 1", "c u 1"));
}

TEST(Facts, HaveTheValuesThatRulesAndRangesMake) {
  owl::Ontology source = written(
      "DataPropertyAssertion(d:u i:a \"1\"^x:integer)\n"
      "ClassAssertion(DataSomeValuesFrom(d:u DatatypeRestriction(x:integer x:minInclusive "
      "\"7\"^x:integer x:maxInclusive \"7\"^x:integer)) i:b)\n");
  const owl::FileId file = source.add_file("rule.ofn");
  ASSERT_TRUE(functional::read(
      "Prefix(:=<https://t.example/#>)Prefix(b:=<http://www.w3.org/2003/11/swrlb#>)Prefix(xsd:=<http://www.w3.org/2001/"
      "XMLSchema#>)Ontology(DLSafeRule(Body(DataPropertyAtom(:u Variable(:x) Variable(:v)) BuiltInAtom(b:divide "
      "Variable(:w) Variable(:v) \"8\"^^xsd:integer)) Head(DataPropertyAtom(:v Variable(:x) Variable(:w)))))",
      file, source, {.wrong_axioms = 0}));
  const Realization found = realized(source);
  std::vector<std::string> lines;
  for (const Fact& fact : found.facts)
    lines.push_back(local(source.name_of(fact.subject)) + ' ' + local(source.name_of(fact.property)) + ' ' +
                    std::string(source.name_of(fact.object)));
  std::ranges::sort(lines);
  EXPECT_THAT(lines, ElementsAre("a u 1", "a v 0.125", "b u 7", "b v 0.875"));
}

TEST(Facts, OfChainsAndValuesThatHoldInEachCaseAreFound) {
  EXPECT_THAT(facts_of("TransitiveObjectProperty(r)\nClassAssertion(ObjectUnionOf(B C) i:a)\n"
                       "SubClassOf(B ObjectSomeValuesFrom(r ObjectIntersectionOf(D ObjectHasValue(r i:b))))\n"
                       "SubClassOf(C ObjectSomeValuesFrom(r ObjectIntersectionOf(E ObjectHasValue(r i:b))))\n"),
              ElementsAre("a r b"));
  EXPECT_THAT(facts_of("SubDataPropertyOf(d:u d:w)\nSubDataPropertyOf(d:v d:w)\n"
                       "ClassAssertion(ObjectUnionOf(DataHasValue(d:u \"1\"^x:integer) DataHasValue(d:v "
                       "\"1\"^x:integer)) i:a)\n"),
              ElementsAre("a w 1"));
}

TEST(Facts, ThatHoldInEachCaseAreFound) {
  EXPECT_THAT(facts_of("ClassAssertion(ObjectUnionOf(ObjectHasValue(r i:b) ObjectHasValue(s i:b)) i:a)\n"
                       "SubObjectPropertyOf(r t)\nSubObjectPropertyOf(s t)\n"),
              ElementsAre("a t b"));
}

TEST(Types, OfACoveringAxiomAreTestedAndNotTakenFromTheModel) {
  owl::Ontology source = written(
      "EquivalentClasses(P ObjectUnionOf(M W))\nDisjointClasses(M W)\nClassAssertion(P i:a)\n"
      "ClassAssertion(P i:b)\nClassAssertion(ObjectComplementOf(M) i:b)\n");
  const auto classification = reasoner::classify(source);
  const Realization found = realize(source, *classification);
  ASSERT_EQ(found.individuals.size(), 2U);
  EXPECT_EQ(found.type_sets[found.types[0]].size(), 1U) << "P";
  EXPECT_EQ(found.type_sets[found.types[1]].size(), 2U) << "P and W";
  EXPECT_THAT(found.gaps, IsEmpty());
}

TEST(Realization, OfAContradictionSaysSo) {
  EXPECT_FALSE(realized("DisjointClasses(A B)\nClassAssertion(A i:a)\nClassAssertion(B i:a)\n").is_consistent);
}

TEST(Realization, WithoutABudgetLeftNamesWhatIsOpen) {
  owl::Ontology source = written("ClassAssertion(A i:a)\nClassAssertion(B i:b)\n");
  base::Budget budget(1);
  while (budget.spend(1)) {
  }
  const Realization found = realized(source, {.budget = &budget});
  EXPECT_TRUE(found.is_consistent);
  EXPECT_THAT(found.gaps, Not(IsEmpty()));
  EXPECT_THAT(found.undecided, ElementsAre(0U, 1U));
}

TEST(Realization, WithoutABudgetLeftKeepsWhatIsStated) {
  owl::Ontology source = written(
      "SubClassOf(A B)\nClassAssertion(A i:a)\nClassAssertion(ObjectComplementOf(A) i:b)\n"
      "ObjectPropertyAssertion(r i:a i:b)\nDataPropertyAssertion(d:u i:a \"1\"^x:integer)\n");
  const auto classification = reasoner::classify(source);
  base::Budget budget(1);
  while (budget.spend(1)) {
  }
  const Realization found = realize(source, *classification, {.budget = &budget, .with_facts = true});
  ASSERT_EQ(found.individuals.size(), 2U);
  EXPECT_EQ(found.type_sets[found.types[0]].size(), 2U) << "A and B";
  EXPECT_EQ(found.type_sets[found.types[1]].size(), 0U);
  EXPECT_EQ(found.facts.size(), 2U);
  EXPECT_TRUE(found.is_consistency_open);
}

TEST(Realization, OfNothingIsEmpty) {
  const Realization found = realized("SubClassOf(A B)\n");
  EXPECT_TRUE(found.is_consistent);
  EXPECT_THAT(found.individuals, IsEmpty());
  EXPECT_THAT(found.gaps, IsEmpty());
}

TEST(Instances, OfAnExpressionThatNeedsCasesAreFound) {
  owl::Ontology source = written(
      "ObjectPropertyAssertion(r i:a i:b)\nObjectPropertyAssertion(r i:a i:c)\nObjectPropertyAssertion(r i:b i:c)\n"
      "ObjectPropertyAssertion(r i:c i:d)\nClassAssertion(P i:b)\nClassAssertion(ObjectComplementOf(P) i:d)\n");
  const owl::TermId r = source.object_property("https://t.example/#r");
  const owl::TermId p = source.named_class("https://t.example/#P");
  const owl::TermId not_p = source.term(owl::TermKind::object_complement_of, {p});
  const owl::TermId inner = source.term(owl::TermKind::object_some_values_from, {r, not_p});
  const owl::TermId both = source.term(owl::TermKind::object_intersection_of, {p, inner});
  const owl::TermId asked = source.term(owl::TermKind::object_some_values_from, {r, both});
  const Instances found = find_instances(source, asked);
  ASSERT_EQ(found.found.size(), 1U);
  EXPECT_EQ(local(source.name_of(found.found.front())), "a");
  EXPECT_THAT(found.undecided, IsEmpty());
  EXPECT_THAT(found.gaps, IsEmpty());
}

TEST(Facts, HaveALimitOfOctetsBeyondWhichThereAreNone) {
  // A thing with four names, linked to itself by a property and its super-property: certainly, and by cases.
  const std::string same = "SameIndividual(i:a i:b i:c i:d)\nSubObjectPropertyOf(r s)\n";
  for (const std::string& text :
       {same + "ObjectPropertyAssertion(r i:a i:a)\n",
        same + "TransitiveObjectProperty(s)\nClassAssertion(ObjectUnionOf(ObjectHasValue(r i:b) ObjectHasValue(r i:a)) "
               "i:a)\n"}) {
    owl::Ontology source = written(text);
    const Realization all = realized(source);
    EXPECT_EQ(all.facts.size(), 32U) << text;
    EXPECT_FALSE(all.has_too_many_facts);
    std::size_t octets = 0;
    for (const Fact& fact : all.facts) {
      octets += fact_octets;
      for (const owl::TermId part : {fact.subject, fact.property, fact.object}) octets += source.name_of(part).size();
    }
    for (const std::size_t limit : {octets - 1, octets, octets + 1}) {
      owl::Ontology again = written(text);
      const Realization found = realized(again, {.with_facts = true, .most_fact_octets = limit});
      EXPECT_EQ(found.has_too_many_facts, limit < octets) << limit;
      EXPECT_EQ(found.facts.size(), limit < octets ? 0U : 32U) << limit;
    }
  }
}

TEST(Instances, OfWhatOnlyExcludesAreRefuted) {
  // Each asks for the absence of something, which a model of the facts need not say of anybody.
  const auto undecided = [](std::string_view text, const std::function<owl::TermId(owl::Ontology&)>& expression) {
    owl::Ontology source = written(text);
    const Instances found = find_instances(source, expression(source));
    EXPECT_THAT(found.found, IsEmpty());
    EXPECT_THAT(found.gaps, IsEmpty());
    return found.undecided;
  };
  EXPECT_THAT(undecided("ClassAssertion(ObjectUnionOf(Cat Dog) i:tim)",
                        [](owl::Ontology& source) {
                          const owl::TermId cat = source.named_class("https://t.example/#Cat");
                          const owl::TermId dog = source.named_class("https://t.example/#Dog");
                          return source.term(owl::TermKind::object_union_of,
                                             {dog, source.term(owl::TermKind::object_complement_of, {cat})});
                        }),
              IsEmpty());
  EXPECT_THAT(undecided("ObjectPropertyAssertion(r i:tim i:tom)\nClassAssertion(Cat i:tom)",
                        [](owl::Ontology& source) {
                          return source.term(owl::TermKind::object_all_values_from,
                                             {source.object_property("https://t.example/#r"),
                                              source.named_class("https://t.example/#Cat")});
                        }),
              IsEmpty());
}

}  // namespace
}  // namespace geminga::realization
