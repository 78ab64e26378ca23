// The models of earlier questions stay, and may only make later questions faster.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "reasoning/dl/clauses/clausify.hpp"
#include "reasoning/dl/hypertableau/tableau.hpp"
#include "support/written.hpp"

namespace geminga::hypertableau {
namespace {

constexpr const char* ontologies[] = {
    // A circle, with choices on the way.
    "SubClassOf(A ObjectSomeValuesFrom(r B))\nSubClassOf(B ObjectUnionOf(C D))\nSubClassOf(C ObjectSomeValuesFrom(r "
    "A))\n"
    "SubClassOf(D ObjectSomeValuesFrom(r D))\nSubClassOf(A ObjectAllValuesFrom(r ObjectComplementOf(C)))",
    // An inverse passes facts from child to parent: pairs block.
    "SubClassOf(A ObjectSomeValuesFrom(r B))\nInverseObjectProperties(r s)\nSubClassOf(B ObjectAllValuesFrom(s C))\n"
    "SubClassOf(C ObjectUnionOf(D E))\nDisjointClasses(A D)\nSubClassOf(B ObjectSomeValuesFrom(r B))",
    // Facts, and individuals in classes: the model of the facts is the base of the questions.
    "SubClassOf(A ObjectHasValue(r i:a))\nClassAssertion(B i:a)\nSubClassOf(B ObjectUnionOf(C D))\n"
    "SubClassOf(ObjectSomeValuesFrom(r C) E)\nSubClassOf(A ObjectComplementOf(E))\nSubClassOf(F ObjectOneOf(i:a))",
    // Individuals that only bodies ask for, beside one that a class may be.
    "SubClassOf(ObjectHasValue(r i:a) A)\nSubClassOf(B ObjectSomeValuesFrom(r C))\nSubClassOf(C ObjectUnionOf(D "
    "ObjectOneOf(i:c)))\nNegativeObjectPropertyAssertion(s i:a i:b)\nObjectPropertyAssertion(r i:b i:a)\n"
    "SubClassOf(ObjectOneOf(i:b) ObjectUnionOf(D E))\nDisjointClasses(A D)\nSameIndividual(i:a i:c)",
    // Counting.
    "SubClassOf(A ObjectMinCardinality(2 r B))\nSubClassOf(B ObjectMaxCardinality(1 s C))\nSubClassOf(B "
    "ObjectSomeValuesFrom(s C))\n"
    "SubClassOf(C ObjectUnionOf(A D))\nSubClassOf(D ObjectMinCardinality(3 s C))",
};

clauses::ConceptId concept_of(const clauses::ClauseSet& set, owl::TermId named) {
  std::uint32_t id = 0;
  while (set.concepts.at(id).kind != clauses::ConceptKind::named || set.concepts[id].term != named) ++id;
  return clauses::ConceptId{id};
}

TEST(KeptModels, ChangeNoAnswer) {
  for (const char* text : ontologies) {
    SCOPED_TRACE(text);
    const owl::Ontology source = owl::written(text);
    std::vector<owl::TermId> classes;
    for (std::uint32_t id = 0; id < source.term_count(); ++id) {
      if (source.kind(owl::TermId{id}) == owl::TermKind::named_class && owl::TermId{id} != owl::nothing_term)
        classes.push_back(owl::TermId{id});
    }
    const auto set = clauses::clausify(source, std::nullopt, classes, classes);
    ASSERT_TRUE(set) << set.error().text;
    Tableau kept(source, *set);
    for (int round = 0; round < 2; ++round) {
      for (const clauses::ConceptId sub : set->queries) {
        for (std::size_t at = 0; at < classes.size(); ++at) {
          const clauses::ConceptId complement = set->complements[at];
          const Answer beside = kept.is_satisfiable({sub, complement});
          const Answer alone = Tableau(source, *set).is_satisfiable({sub, complement});
          ASSERT_EQ(beside.verdict, alone.verdict) << clauses::number(sub) << " " << clauses::number(complement);
          if (classes[at] == owl::thing_term) continue;
          const Answer outside = kept.is_satisfiable({sub}, concept_of(*set, classes[at]));
          ASSERT_EQ(outside.verdict, alone.verdict) << clauses::number(sub) << " " << clauses::number(complement);
        }
      }
    }
  }
}

/// The nodes of the labels of all questions about named classes, where each of 60 classes leads along one chain.
std::size_t nodes_of_chain(std::string text) {
  for (int at = 0; at < 30; ++at)
    text += "SubClassOf(C" + std::to_string(at) + " ObjectSomeValuesFrom(r C" + std::to_string(at + 1) + "))\n";
  for (int at = 0; at < 30; ++at) text += "SubClassOf(B" + std::to_string(at) + " ObjectSomeValuesFrom(r C0))\n";
  const owl::Ontology source = owl::written(text);
  const auto set = clauses::clausify(source, std::nullopt, {});
  if (!set) ADD_FAILURE() << set.error().text;
  if (!set) return 0;
  Tableau tableau(source, *set);
  std::size_t nodes = 0;
  for (std::uint32_t id = 2; id < set->concepts.size(); ++id) {
    if (set->concepts[id].kind != clauses::ConceptKind::named) continue;
    EXPECT_EQ(tableau.is_satisfiable({clauses::ConceptId{id}}).verdict, Verdict::yes);
    nodes += tableau.model().labels.size();
  }
  return nodes;
}

TEST(KeptModels, AreNotBuiltAgain) {
  constexpr std::size_t about_one_a_class = 3 * 62;
  EXPECT_LE(nodes_of_chain(""), about_one_a_class);
  EXPECT_LE(nodes_of_chain("NegativeObjectPropertyAssertion(s i:a i:b)\nSubClassOf(ObjectHasValue(r i:a) A)\n"),
            about_one_a_class)
      << "nor where only bodies name individuals";
  EXPECT_GT(nodes_of_chain("SubClassOf(A ObjectHasValue(r i:a))\n"), about_one_a_class) << "but beside a nominal";
}

TEST(KeptModels, AreNotLookedAtAgainWhereNothingChanged) {
  // The model of the facts has a value and a blocked neighbour for each of many individuals.
  constexpr int individuals = 2000;
  std::string text =
      "SubClassOf(A ObjectHasValue(r i:i0))\nSubClassOf(B ObjectSomeValuesFrom(r B))\n"
      "SubClassOf(B DataSomeValuesFrom(d:v x:integer))\n";
  for (int at = 0; at < individuals; ++at) {
    const std::string name = " i:i" + std::to_string(at);
    text += "ClassAssertion(B" + name + ")\nDataPropertyAssertion(d:v" + name + " \"" + std::to_string(at) +
            "\"^x:integer)\n";
  }
  owl::Ontology source = owl::written(text);
  const std::vector<owl::TermId> classes{source.named_class("https://t.example/#A")};
  const auto set = clauses::clausify(source, std::nullopt, classes);
  ASSERT_TRUE(set) << set.error().text;
  Tableau tableau(source, *set);
  ASSERT_EQ(tableau.is_consistent().verdict, Verdict::yes);
  const std::size_t before = tableau.steps();
  ASSERT_EQ(tableau.is_satisfiable({set->queries.front()}).verdict, Verdict::yes);
  EXPECT_LT(tableau.steps() - before, individuals / 4U) << "of " << before << " steps for the facts";
}

}  // namespace
}  // namespace geminga::hypertableau
