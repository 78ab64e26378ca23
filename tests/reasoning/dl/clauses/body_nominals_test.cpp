// Which nominals are replaced, and that nothing follows from it that did not follow.
#include "reasoning/dl/clauses/body_nominals.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "reasoning/dl/clauses/clausify.hpp"
#include "support/written.hpp"

namespace geminga::clauses {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::string name_of(const owl::Ontology& source, owl::TermId term) {
  if (term == no_term) return "?";
  const std::string_view iri = source.name_of(term);
  return std::string(iri.substr(iri.find('#') + 1));
}

/// The individuals that have a concept of this kind, by name.
std::vector<std::string> individuals_of(const owl::Ontology& source, const ClauseSet& set, ConceptKind kind) {
  std::vector<std::string> found;
  for (const Concept& one : set.concepts) {
    if (one.kind == kind) found.push_back(name_of(source, set.individuals[number(one.individual)]));
  }
  std::ranges::sort(found);
  return found;
}
std::vector<std::string> individuals_of(std::string_view text, ConceptKind kind) {
  const owl::Ontology source = owl::written(text);
  const auto set = clausify(source, std::nullopt, {});
  if (!set) ADD_FAILURE() << set.error().text;
  return set ? individuals_of(source, *set, kind) : std::vector<std::string>();
}
std::vector<std::string> marked(std::string_view text) { return individuals_of(text, ConceptKind::mark); }
std::vector<std::string> nominals(std::string_view text) { return individuals_of(text, ConceptKind::nominal); }

TEST(BodyNominals, AreReplacedWhereOnlyBodiesAskForThem) {
  constexpr const char* texts[] = {
      "SubClassOf(ObjectOneOf(i:a) A)",
      "SubClassOf(ObjectHasValue(r i:a) A)",
      "SubClassOf(ObjectHasValue(ObjectInverseOf(r) i:a) A)",
      "DisjointClasses(A ObjectHasValue(r i:a))",
      "SubClassOf(A ObjectComplementOf(ObjectOneOf(i:a)))",
      "SubClassOf(A ObjectAllValuesFrom(r ObjectComplementOf(ObjectOneOf(i:a))))",
      "SubClassOf(A ObjectMaxCardinality(1 r ObjectOneOf(i:a)))",
      "SubClassOf(A ObjectMaxCardinality(7 r ObjectOneOf(i:a)))",
      "NegativeObjectPropertyAssertion(r i:a i:a)",
      "NegativeDataPropertyAssertion(d:v i:a \"1\"^x:integer)",
  };
  for (const char* text : texts) {
    EXPECT_THAT(marked(text), ElementsAre("a")) << text;
    EXPECT_THAT(nominals(text), IsEmpty()) << text;
  }
}

TEST(BodyNominals, StayWhereSomethingMayBeTheIndividual) {
  constexpr const char* texts[] = {
      "SubClassOf(A ObjectOneOf(i:a))",
      "SubClassOf(A ObjectHasValue(r i:a))",
      "SubClassOf(A ObjectSomeValuesFrom(r ObjectOneOf(i:a)))",
      "SubClassOf(A ObjectAllValuesFrom(r ObjectOneOf(i:a)))",
      "SubClassOf(ObjectComplementOf(ObjectOneOf(i:a)) A)",
      "SubClassOf(A ObjectMaxCardinality(7 r ObjectComplementOf(ObjectOneOf(i:a))))",
      "ObjectPropertyRange(r ObjectOneOf(i:a))",
      "ClassAssertion(ObjectOneOf(i:a) i:b)",
      "ClassAssertion(ObjectHasValue(r i:a) i:b)",
  };
  for (const std::string text : texts) {
    EXPECT_THAT(nominals(text), ElementsAre("a")) << text;
    EXPECT_THAT(nominals(text + "\nSubClassOf(ObjectOneOf(i:a) B)"), ElementsAre("a")) << text;
  }
}

TEST(BodyNominals, AreReplacedOneByOne) {
  constexpr const char* text = "SubClassOf(A ObjectOneOf(i:a))\nSubClassOf(ObjectOneOf(i:a i:b) B)";
  EXPECT_THAT(nominals(text), ElementsAre("a"));
  EXPECT_THAT(marked(text), ElementsAre("b"));
}

TEST(BodyNominals, StayInQuestions) {
  owl::Ontology source = owl::written("SubClassOf(ObjectOneOf(i:a) A)\nSubClassOf(ObjectOneOf(i:b) A)");
  const std::vector<owl::TermId> asked{
      source.term(owl::TermKind::object_one_of, {source.individual("https://t.example/#a")})};
  for (const bool is_complement : {false, true}) {
    const auto set = is_complement ? clausify(source, std::nullopt, {}, asked) : clausify(source, std::nullopt, asked);
    ASSERT_TRUE(set) << set.error().text;
    // A name stands for the complement; its clause has {a} in its body.
    EXPECT_THAT(individuals_of(source, *set, ConceptKind::nominal).size(), is_complement ? 0U : 1U);
    EXPECT_THAT(individuals_of(source, *set, ConceptKind::mark).size(), is_complement ? 2U : 1U);
  }
}

}  // namespace
}  // namespace geminga::clauses
