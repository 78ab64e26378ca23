// The models of earlier questions stay, and may only make later questions faster.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "reasoning/dl/clauses/clausify.hpp"
#include "reasoning/dl/hypertableau/tableau.hpp"
#include "support/random_ontology.hpp"
#include "support/rounds.hpp"
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
    // Things that can only be one individual, each with facts of its own about it: what one question says of the
    // individual is not true for the next.
    "SubClassOf(A ObjectOneOf(i:a))\nSubClassOf(B ObjectOneOf(i:a))\nDisjointClasses(A B)\nClassAssertion(D i:a)\n"
    "SubClassOf(C ObjectUnionOf(A B))\nSubClassOf(E ObjectSomeValuesFrom(r A))\nSubClassOf(F ObjectOneOf(i:a "
    "i:b))\nSubClassOf(F ObjectUnionOf(A E))\nDifferentIndividuals(i:a i:b)\nSubClassOf(D ObjectUnionOf(A "
    "ObjectComplementOf(F)))",
    // Individuals that only bodies ask for, beside one that a class may be.
    "SubClassOf(ObjectHasValue(r i:a) A)\nSubClassOf(B ObjectSomeValuesFrom(r C))\nSubClassOf(C ObjectUnionOf(D "
    "ObjectOneOf(i:c)))\nNegativeObjectPropertyAssertion(s i:a i:b)\nObjectPropertyAssertion(r i:b i:a)\n"
    "SubClassOf(ObjectOneOf(i:b) ObjectUnionOf(D E))\nDisjointClasses(A D)\nSameIndividual(i:a i:c)",
    // Counting.
    "SubClassOf(A ObjectMinCardinality(2 r B))\nSubClassOf(B ObjectMaxCardinality(1 s C))\nSubClassOf(B "
    "ObjectSomeValuesFrom(s C))\n"
    "SubClassOf(C ObjectUnionOf(A D))\nSubClassOf(D ObjectMinCardinality(3 s C))",
    // Values that models have in common, and that must differ from others.
    "SubClassOf(A DataHasValue(d:u \"1\"^x:integer))\nSubClassOf(B DataMinCardinality(2 d:u DataOneOf(\"1\"^x:integer "
    "\"2\"^x:integer)))\nSubClassOf(C DataMinCardinality(3 d:u DataOneOf(\"1\"^x:integer \"2\"^x:integer)))\n"
    "FunctionalDataProperty(d:v)\nSubClassOf(D DataSomeValuesFrom(d:v DataOneOf(\"1\"^x:integer \"2\"^x:integer)))\n"
    "SubClassOf(D ObjectUnionOf(DataHasValue(d:v \"2\"^x:integer) DataAllValuesFrom(d:v "
    "DataComplementOf(x:integer))))\n"
    "DisjointDataProperties(d:u d:v)\nSubClassOf(E DataHasValue(d:u \"2\"^x:integer))\n"
    "EquivalentClasses(F DataHasValue(d:v \"2\"^x:integer))\nSubClassOf(A ObjectSomeValuesFrom(r ObjectUnionOf(B D)))\n"
    "SubClassOf(B ObjectSomeValuesFrom(r A))\nSubClassOf(D ObjectSomeValuesFrom(r D))",
    // Values of a datatype of which nothing is known: one model has 1 among them, and another has not.
    "SubClassOf(A DataHasValue(d:u \"1\"^x:integer))\nSubClassOf(A DataAllValuesFrom(d:u x:colour))\n"
    "SubClassOf(B DataHasValue(d:u \"1\"^x:integer))\nSubClassOf(B DataAllValuesFrom(d:u DataComplementOf(x:colour)))\n"
    "SubClassOf(C ObjectSomeValuesFrom(r A))\nSubClassOf(D ObjectSomeValuesFrom(r ObjectUnionOf(A B)))",
    // The same with a facet that is not worked out.
    "SubClassOf(A DataHasValue(d:u \"1\"^x:string))\nSubClassOf(B A)\nSubClassOf(B DataSomeValuesFrom(d:u "
    "DatatypeRestriction(x:string x:pattern \"1|2\"^x:string)))\nSubClassOf(C DataAllValuesFrom(d:u DataComplementOf("
    "DatatypeRestriction(x:string x:pattern \"1|2\"^x:string))))\nSubClassOf(D ObjectSomeValuesFrom(r A))",
};

std::optional<clauses::ConceptId> concept_of(const clauses::ClauseSet& set, owl::TermId named) {
  for (std::uint32_t id = 0; id < set.concepts.size(); ++id) {
    if (set.concepts[id].kind == clauses::ConceptKind::named && set.concepts[id].term == named)
      return clauses::ConceptId{id};
  }
  return std::nullopt;
}

/// The first named classes but owl:Nothing, at most so many.
std::vector<owl::TermId> first_classes(const owl::Ontology& source, std::size_t most) {
  std::vector<owl::TermId> classes;
  for (std::uint32_t id = 0; id < source.term_count() && classes.size() < most; ++id) {
    if (source.kind(owl::TermId{id}) == owl::TermKind::named_class && owl::TermId{id} != owl::nothing_term)
      classes.push_back(owl::TermId{id});
  }
  return classes;
}

/// Asks about all pairs of classes beside models that are kept, and each time with no other question before it. Returns
/// the number of answers.
std::size_t compare_answers(const owl::Ontology& source) {
  const std::vector<owl::TermId> classes = first_classes(source, source.term_count());
  const auto set = clauses::clausify(source, std::nullopt, classes, classes);
  EXPECT_TRUE(set) << set.error().text;
  if (!set) return 0;
  const QuestionLimits limits{.steps = 200'000};
  Tableau kept(source, *set, limits);
  std::size_t answers = 0;
  for (const clauses::ConceptId sub : set->queries) {
    for (std::size_t at = 0; at < classes.size(); ++at) {
      SCOPED_TRACE("concept " + std::to_string(clauses::number(sub)) + " outside of class " + std::to_string(at));
      const Verdict alone = Tableau(source, *set, limits).is_satisfiable({sub, set->complements[at]}).verdict;
      if (alone == Verdict::unknown) continue;
      // Within the limit of steps another order of guesses may find no answer.
      const auto expect_the_same = [&](Verdict beside) {
        if (beside == Verdict::unknown) return;
        ++answers;
        EXPECT_EQ(beside, alone);
      };
      expect_the_same(kept.is_satisfiable({sub, set->complements[at]}).verdict);
      const auto named = concept_of(*set, classes[at]);
      if (!named || classes[at] == owl::thing_term) continue;
      expect_the_same(kept.is_satisfiable({sub}, {*named}).verdict);
      if (alone == Verdict::no || kept.is_satisfiable({sub}).verdict != Verdict::yes) continue;
      EXPECT_FALSE(std::ranges::binary_search(kept.model().certain, *named)) << "is certain, and does not follow";
    }
    if (testing::Test::HasFailure()) break;
  }
  return answers;
}

/// Asks for things in one class and outside of two others, beside models that are kept, and each time with no other
/// question before it. Returns the number of answers.
std::size_t compare_answers_about_two(const owl::Ontology& source) {
  std::vector<owl::TermId> classes = first_classes(source, 8);
  std::erase(classes, owl::thing_term);
  const auto set = clauses::clausify(source, std::nullopt, classes, classes);
  EXPECT_TRUE(set) << set.error().text;
  if (!set) return 0;
  const QuestionLimits limits{.steps = 200'000};
  Tableau kept(source, *set, limits);
  std::size_t answers = 0;
  for (const clauses::ConceptId sub : set->queries) {
    for (std::size_t one = 0; one < classes.size(); ++one) {
      for (std::size_t other = one + 1; other < classes.size(); ++other) {
        SCOPED_TRACE("concept " + std::to_string(clauses::number(sub)) + " outside of classes " + std::to_string(one) +
                     " and " + std::to_string(other));
        const auto first = concept_of(*set, classes[one]);
        const auto second = concept_of(*set, classes[other]);
        if (!first || !second) continue;
        const Verdict alone =
            Tableau(source, *set, limits).is_satisfiable({sub, set->complements[one], set->complements[other]}).verdict;
        const Verdict beside = kept.is_satisfiable({sub}, {*second, *first}).verdict;
        if (alone == Verdict::unknown || beside == Verdict::unknown) continue;
        ++answers;
        EXPECT_EQ(beside, alone);
      }
    }
    if (testing::Test::HasFailure()) break;
  }
  return answers;
}

TEST(KeptModels, ChangeNoAnswer) {
  for (const char* text : ontologies) {
    SCOPED_TRACE(text);
    EXPECT_GT(compare_answers(owl::written(text)), 0U);
    EXPECT_GT(compare_answers_about_two(owl::written(text)), 0U);
  }
}

TEST(KeptModels, OfAnIndividualHideNoLaterQuestionAboutIt) {
  // The individual is in C or in G. One of A and B has an instance only where the other choice holds, and that model
  // becomes the base. In it the individual carries the mark of the question.
  const owl::Ontology source = owl::written(
      "ClassAssertion(ObjectUnionOf(C G) i:a)\nSubClassOf(A ObjectOneOf(i:a))\nSubClassOf(B ObjectOneOf(i:a))\n"
      "DisjointClasses(A C)\nDisjointClasses(B G)\nClassAssertion(D i:a)\nSubClassOf(E C)");
  const auto term = [&](const std::string& name) {
    for (std::uint32_t id = 0; id < source.term_count(); ++id) {
      if (source.kind(owl::TermId{id}) == owl::TermKind::named_class && source.name_of(owl::TermId{id}).ends_with(name))
        return owl::TermId{id};
    }
    ADD_FAILURE() << name;
    return owl::thing_term;
  };
  const std::vector<owl::TermId> classes{term("A"), term("B"), term("D"), term("E")};
  const auto set = clauses::clausify(source, std::nullopt, classes, classes);
  ASSERT_TRUE(set) << set.error().text;
  Tableau tableau(source, *set, {});
  for (const std::size_t one : {0U, 1U}) {
    SCOPED_TRACE(one);
    EXPECT_EQ(tableau.is_satisfiable({set->queries[one]}, {concept_of(*set, term("E")).value()}).verdict, Verdict::yes);
    EXPECT_EQ(tableau.is_satisfiable({set->queries[one]}, {concept_of(*set, term("D")).value()}).verdict, Verdict::no);
  }
}

TEST(KeptModels, ChangeNoAnswerAboutRandomOntologies) {
  using compare::Profile;
  for (const Profile profile : {Profile::choices, Profile::chains, Profile::nominals, Profile::values}) {
    std::size_t answers = 0;
    for (std::uint64_t seed = 1; seed <= test::rounds(20U) && !HasFailure(); ++seed) {
      SCOPED_TRACE("profile " + std::string(to_string(profile)) + ", seed " + std::to_string(seed));
      const owl::Ontology source = compare::random_ontology(profile, seed, 8 + seed % 16);
      answers += compare_answers(source) + compare_answers_about_two(source);
    }
    EXPECT_TRUE(HasFailure() || answers > test::rounds(20U)) << answers;
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
  EXPECT_LE(nodes_of_chain("SubClassOf(C9 DataSomeValuesFrom(d:u x:integer))\nSubClassOf(C9 DataHasValue(d:v "
                           "\"1\"^x:integer))\n"),
            about_one_a_class)
      << "nor where they have values";
  EXPECT_GT(nodes_of_chain("SubClassOf(C9 DataSomeValuesFrom(d:u x:colour))\n"), about_one_a_class)
      << "but those that say which values a datatype has";
  EXPECT_LE(nodes_of_chain("SubClassOf(A ObjectHasValue(r i:a))\n"), about_one_a_class) << "and beside a nominal";
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
