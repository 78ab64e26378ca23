// Proofs: every step follows from its premises, by the engines, and all axioms are needed.
#include "reasoning/explanation/proof.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "base/random.hpp"
#include "reasoning/explanation/proof_lemmas.hpp"
#include "support/reference.hpp"
#include "support/rounds.hpp"
#include "support/written.hpp"

namespace geminga::explanation {
namespace {

using compiled::Ontology;
using owl::loaded;
using owl::named;
using testing::ElementsAre;
using testing::IsEmpty;

/// Fails the test if a step does not follow from its premises, or the last step is not the goal.
void check(Explainer& explainer, const Proof& proof) {
  Module& module = explainer.module();
  ProofLemmas engines(module, explainer.oracle());
  std::set<std::uint32_t> used;
  for (std::size_t at = 0; at < proof.steps.size(); ++at) {
    const ProofStep& step = proof.steps[at];
    SCOPED_TRACE(step.text + " by " + std::string(to_string(step.rule)));
    AxiomSet premises;
    for (const std::uint32_t number : step.from) {
      ASSERT_GE(number, 1U);
      ASSERT_LE(number, proof.axioms.size() + at);
      used.insert(number);
      if (number <= proof.axioms.size()) {
        premises.push_back(proof.axioms[number - 1]);
      } else {
        const ProofStep& earlier = proof.steps[number - proof.axioms.size() - 1];
        premises.push_back(static_cast<std::uint32_t>(module.source().axiom_count()));
        module.source().add(owl::AxiomKind::sub_class_of, {earlier.sub, earlier.super}, owl::FileId{0}, 0);
      }
    }
    ASSERT_TRUE(engines.holds(premises, step.sub, step.super));
  }
  if (proof.steps.empty()) {
    ASSERT_LE(proof.axioms.size(), 1U);
    return;
  }
  ASSERT_EQ(proof.steps.back().sub, explainer.sub());
  ASSERT_EQ(proof.steps.back().super, explainer.super());
  ASSERT_EQ(used.size(), proof.axioms.size() + proof.steps.size() - 1) << "something is not used";
}

std::vector<std::string> written_steps(const Proof& proof) {
  std::vector<std::string> lines;
  for (const ProofStep& step : proof.steps) {
    std::string line = step.text + " |";
    for (const std::uint32_t number : step.from) line += " " + std::to_string(number);
    lines.push_back(line + " | " + std::string(to_string(step.rule)));
  }
  return lines;
}

/// The steps for t:sub below t:super, checked.
std::vector<std::string> steps_of(std::string_view axioms, std::string_view sub, std::string_view super) {
  const Ontology ontology = loaded(axioms);
  const auto number = [&](std::string_view name) {
    return name == "Nothing" || name == "Thing" ? *ontology.find("owl:" + std::string(name)) : named(ontology, name);
  };
  Explainer explainer(ontology, number(sub), number(super));
  const auto found = explainer.find_one();
  if (!found) return {"not entailed"};
  const Proof proof = prove(explainer, *found);
  check(explainer, proof);
  return written_steps(proof);
}

TEST(Proof, IsEmptyWhereAnAxiomSaysIt) {
  EXPECT_THAT(steps_of("SubClassOf(A B)", "A", "B"), IsEmpty());
  EXPECT_THAT(steps_of("SubClassOf(A B)", "A", "Thing"), IsEmpty());
}

TEST(Proof, GoesUpAChainInOneStep) {
  EXPECT_THAT(steps_of("SubClassOf(A B)\nSubClassOf(B C)\nSubClassOf(C D)", "A", "D"),
              ElementsAre("t:A SubClassOf t:D | 1 2 3 | a chain of subclasses"));
}

TEST(Proof, UsesTheExistentialRule) {
  EXPECT_THAT(steps_of("SubClassOf(A ObjectSomeValuesFrom(r B))\nSubClassOf(B C)\nSubObjectPropertyOf(r s)\n"
                       "SubClassOf(ObjectSomeValuesFrom(s C) D)",
                       "A", "D"),
              ElementsAre("t:A SubClassOf t:s some t:C | 1 2 3 | the existential rule",
                          "t:A SubClassOf t:D | 4 5 | a chain of subclasses"));
}

TEST(Proof, TakesDefinitionsApartAndPutsThemTogether) {
  EXPECT_THAT(
      steps_of("EquivalentClasses(A ObjectIntersectionOf(B C))\nEquivalentClasses(D ObjectIntersectionOf(B E))\n"
               "SubClassOf(C E)",
               "A", "D"),
      ElementsAre("t:A SubClassOf t:B | 1 | taking a conjunction apart",
                  "t:A SubClassOf t:E | 1 2 | taking a conjunction apart",
                  "t:A SubClassOf t:B and t:E | 4 5 | putting a conjunction together",
                  "t:A SubClassOf t:D | 3 6 | a chain of subclasses"));
}

TEST(Proof, FindsAContradictionOfIndividuals) {
  EXPECT_THAT(steps_of("ClassAssertion(A i:a)\nObjectPropertyAssertion(r i:a i:b)\nObjectPropertyRange(r B)\n"
                       "DisjointClasses(B C)\nClassAssertion(C i:b)",
                       "Thing", "Nothing"),
              testing::Contains(testing::HasSubstr("disjointness")));
}

TEST(Proof, ReachesBeyondEl) {
  const struct {
    const char* axioms;
    const char* sub;
    const char* super;
  } cases[] = {
      {"SubClassOf(A ObjectUnionOf(B C))\nSubClassOf(B D)\nSubClassOf(C D)", "A", "D"},
      {"SubClassOf(A ObjectUnionOf(B C))\nSubClassOf(B D)\nDisjointClasses(A C)", "A", "D"},
      {"SubClassOf(A ObjectSomeValuesFrom(r B))\nSubClassOf(A ObjectAllValuesFrom(r C))\n"
       "SubClassOf(ObjectSomeValuesFrom(r ObjectIntersectionOf(B C)) D)",
       "A", "D"},
      {"SubClassOf(A ObjectSomeValuesFrom(r B))\nInverseObjectProperties(r s)\n"
       "SubClassOf(B ObjectAllValuesFrom(s C))",
       "A", "C"},
      {"SubClassOf(A ObjectSomeValuesFrom(r B))\nInverseObjectProperties(r s)\n"
       "SubClassOf(ObjectSomeValuesFrom(s A) C)\nSubClassOf(ObjectSomeValuesFrom(r C) D)",
       "A", "D"},
      {"SubClassOf(A ObjectSomeValuesFrom(r B))\nSubClassOf(A ObjectSomeValuesFrom(r C))\n"
       "FunctionalObjectProperty(r)\nSubClassOf(ObjectSomeValuesFrom(r ObjectIntersectionOf(B C)) D)",
       "A", "D"},
      {"SubClassOf(A ObjectMinCardinality(3 r B))\nSubClassOf(A ObjectMaxCardinality(2 r B))", "A", "Nothing"},
      {"SubClassOf(A ObjectComplementOf(B))\nSubClassOf(ObjectComplementOf(B) C)", "A", "C"},
      {"EquivalentClasses(A ObjectComplementOf(B))\nDisjointClasses(C B)", "C", "A"},
      {"SubClassOf(A ObjectOneOf(i:a i:b))\nClassAssertion(B i:a)\nClassAssertion(B i:b)", "A", "B"},
      {"DisjointUnion(A B C)\nSubClassOf(D A)\nDisjointClasses(D B)", "D", "C"},
      {"SubClassOf(A ObjectMinCardinality(2 r B))\nEquivalentClasses(C ObjectMinCardinality(2 s D))\n"
       "SubClassOf(B D)\nSubObjectPropertyOf(r s)",
       "A", "C"},
      {"SubClassOf(A ObjectAllValuesFrom(r B))\nSubClassOf(B C)\nEquivalentClasses(D ObjectAllValuesFrom(r C))", "A",
       "D"},
  };
  for (const auto& one : cases) {
    SCOPED_TRACE(one.axioms);
    const auto steps = steps_of(one.axioms, one.sub, one.super);
    EXPECT_NE(steps, std::vector<std::string>{"not entailed"});
    for (const std::string& step : steps) SCOPED_TRACE(step);
    EXPECT_FALSE(steps.empty());
  }
}

TEST(RandomProofs, HaveStepsThatFollow) {
  int proven = 0;
  int by_rules = 0;
  for (std::uint64_t seed = 1; seed <= test::rounds(120U); ++seed) {
    base::Random random(seed);
    const std::string text = owl::random_ontology(random, 14);
    SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + text);
    const Ontology ontology = loaded(text);
    for (std::uint32_t sub = 0; sub < ontology.class_count(); ++sub) {
      for (std::uint32_t super = 0; super < ontology.class_count(); ++super) {
        if (!ontology.is_subsumed(taxonomy::ClassNumber{sub}, taxonomy::ClassNumber{super})) continue;
        Explainer explainer(ontology, taxonomy::ClassNumber{sub}, taxonomy::ClassNumber{super});
        const auto found = explainer.find_one();
        ASSERT_TRUE(found);
        if (found->size() < 3) continue;
        const Proof proof = prove(explainer, *found);
        SCOPED_TRACE(testing::PrintToString(written_steps(proof)));
        check(explainer, proof);
        if (HasFatalFailure()) return;
        ++proven;
        const auto is_bridge = [](const ProofStep& step) { return step.rule == ProofRule::together; };
        if (std::ranges::none_of(proof.steps, is_bridge)) ++by_rules;
      }
    }
  }
  EXPECT_GT(proven, test::rounds(200));
  // The proof rules have all rules of EL, so that an EL proof needs no lemma of an engine.
  EXPECT_EQ(by_rules, proven);
}

}  // namespace
}  // namespace geminga::explanation
