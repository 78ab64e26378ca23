// Questions to the engines beyond the rules of EL, which take turns, and the allowance that bounds them.
#include "reasoning/explanation/explain_oracle.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <string>

#include "reasoning/explanation/allowance.hpp"
#include "reasoning/explanation/explain_minimal.hpp"
#include "support/written.hpp"

namespace geminga::explanation {
namespace {

using hypertableau::Verdict;

/// One more pigeon than holes, no two in one hole: a clash that is hard for every engine.
std::string pigeonhole(int holes) {
  std::string text;
  for (int pigeon = 0; pigeon <= holes; ++pigeon) {
    text += "SubClassOf(P ObjectUnionOf(";
    for (int hole = 0; hole < holes; ++hole) text += " H" + std::to_string(pigeon) + "x" + std::to_string(hole);
    text += "))\n";
    for (int other = 0; other < pigeon; ++other) {
      for (int hole = 0; hole < holes; ++hole) {
        text += "DisjointClasses(H" + std::to_string(pigeon) + "x" + std::to_string(hole) + " H" +
                std::to_string(other) + "x" + std::to_string(hole) + ")\n";
      }
    }
  }
  return text;
}

AxiomSet all_of(const owl::Ontology& source) {
  AxiomSet all(source.axiom_count());
  std::iota(all.begin(), all.end(), 0U);
  return all;
}

TEST(Oracle, DecidesBothWaysWhatTheRulesDoNot) {
  struct Case {
    std::string text;
    std::string super;
    Verdict verdict;
  };
  const Case cases[] = {
      {"SubClassOf(A ObjectUnionOf(B C))\nSubClassOf(B D)\nSubClassOf(C D)\n", "D", Verdict::yes},
      {"SubClassOf(A ObjectUnionOf(B C))\nSubClassOf(B D)\n", "D", Verdict::no},
      {"SubClassOf(A ObjectAllValuesFrom(r B))\nSubClassOf(A ObjectSomeValuesFrom(r C))\nDisjointClasses(B C)\n", "D",
       Verdict::yes},
      // Deriving leaves open what follows from an enumeration, and a model decides it.
      {"SubClassOf(A ObjectOneOf(i:a i:b))\nSubClassOf(ObjectOneOf(i:a) D)\nSubClassOf(ObjectOneOf(i:b) D)\n", "D",
       Verdict::yes},
      {"SubClassOf(A ObjectOneOf(i:a i:b))\nSubClassOf(ObjectOneOf(i:a) D)\n", "D", Verdict::no},
  };
  for (const Case& one : cases) {
    owl::Ontology source = owl::written(one.text);
    const owl::TermId sub = source.named_class("https://t.example/#A");
    const owl::TermId super = source.named_class("https://t.example/#" + one.super);
    for (const Patience patience : {Patience::of_a_person, Patience::of_a_daemon}) {
      Oracle oracle(source, patience);
      EXPECT_EQ(oracle.decide(all_of(source), sub, super).verdict, one.verdict) << one.text;
      EXPECT_EQ(oracle.holds(all_of(source), sub, super), one.verdict == Verdict::yes) << one.text;
      EXPECT_EQ(oracle.undecided_count(), 0U) << one.text;
    }
  }
}

TEST(Oracle, AQuestionThatIsBeingAskedEndsSoonAfterTheBudget) {
  owl::Ontology source = owl::written(pigeonhole(9));
  const owl::TermId sub = source.named_class("https://t.example/#P");
  base::Budget budget(200'000);
  Oracle oracle(source, Patience::of_a_person, &budget);
  EXPECT_FALSE(oracle.holds(all_of(source), sub, owl::nothing_term));
  EXPECT_TRUE(oracle.is_spent());
  EXPECT_LT(budget.spent(), 400'000U);
}

TEST(Allowance, IsPaidByTheWholeBudgetAndEndsBeforeIt) {
  base::Budget whole(100'000);
  {
    Allowance part(&whole, 1'000);
    EXPECT_TRUE(part.budget().spend(1'000));
    EXPECT_FALSE(part.budget().spend(1));
  }
  EXPECT_EQ(whole.spent(), 1'001U);
  EXPECT_FALSE(whole.is_spent());
  Allowance of_nothing(nullptr, 1'000);
  EXPECT_TRUE(of_nothing.budget().spend(1'000));
}

TEST(Allowance, EndsSoonAfterTheWholeBudget) {
  base::Budget whole(50'000);
  Allowance part(&whole, 1'000'000);
  while (part.budget().spend(100)) {
  }
  EXPECT_TRUE(whole.is_spent());
  EXPECT_LT(part.budget().spent(), 100'000U);
}

}  // namespace
}  // namespace geminga::explanation
