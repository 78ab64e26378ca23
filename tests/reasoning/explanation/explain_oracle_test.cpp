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

/// Pigeons in holes, no two in one hole, as a class P. With more pigeons than holes it is a clash that is hard for
/// every engine. With as many, a model is soon built, and deriving looks at all ways.
std::string pigeonhole(int pigeons, int holes) {
  std::string text;
  for (int pigeon = 0; pigeon < pigeons; ++pigeon) {
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

/// A class C that is D by so many steps, each of which either of two ways takes. Deriving follows the steps. A model
/// of C without D is looked for in all combinations of ways.
std::string two_ways(int steps) {
  std::string text = "SubClassOf(C S0)\nSubClassOf(S" + std::to_string(steps) + " D)\n";
  for (int at = 0; at < steps; ++at) {
    const std::string here = std::to_string(at);
    const std::string next = std::to_string(at + 1);
    text += "SubClassOf(S" + here + " ObjectUnionOf(L" + here + " R" + here + "))\n";
    for (const char* way : {"L", "R"}) text += "SubClassOf(" + (way + here) + " S" + next + ")\n";
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

/// Questions to one oracle about all axioms of one ontology, and the steps of each.
class Questions {
 public:
  Questions(const std::string& text, Patience patience)
      : source_(owl::written(text)), oracle_(source_, patience, &budget_) {}

  /// The answer to whether the class is below D, or below nothing where there is no D.
  Verdict ask(const std::string& sub, const std::string& super = "D") {
    const std::uint64_t before = budget_.spent();
    const owl::TermId below = source_.named_class("https://t.example/#" + sub);
    const owl::TermId above = super.empty() ? owl::nothing_term : source_.named_class("https://t.example/#" + super);
    const Verdict verdict = oracle_.decide(all_of(source_), below, above).verdict;
    steps_ = budget_.spent() - before;
    return verdict;
  }
  /// Of the last question.
  [[nodiscard]] std::uint64_t steps() const { return steps_; }

 private:
  owl::Ontology source_;
  base::Budget budget_;
  Oracle oracle_;
  std::uint64_t steps_ = 0;
};

// Deriving alone takes 20'000'000 steps for P and leaves it open; so does a model with 3'000'000 for C.
TEST(Oracle, TakesTurnsSoThatTheEngineForWhichAQuestionIsEasyDecidesIt) {
  for (const bool begins_with_models : {true, false}) {
    Questions questions(pigeonhole(5, 5) + two_ways(20), Patience::of_a_person);
    for (int round = 0; round < 4; ++round) {
      const bool is_for_models = begins_with_models == (round % 2 == 0);
      EXPECT_EQ(questions.ask(is_for_models ? "P" : "C"), is_for_models ? Verdict::no : Verdict::yes);
      EXPECT_LT(questions.steps(), 500'000U) << "question " << round << (is_for_models ? " for models" : " to derive");
    }
  }
}

TEST(Oracle, BeginsSmallAfterAQuestionThatWasTooHard) {
  Questions questions(pigeonhole(9, 8) + two_ways(20), Patience::of_a_daemon);
  EXPECT_EQ(questions.ask("P", ""), Verdict::unknown);
  EXPECT_GT(questions.steps(), 200'000U) << "it is no longer hard";
  EXPECT_EQ(questions.ask("C"), Verdict::yes);
  EXPECT_LT(questions.steps(), 50'000U);
}

TEST(Oracle, AQuestionThatIsBeingAskedEndsSoonAfterTheBudget) {
  owl::Ontology source = owl::written(pigeonhole(10, 9));
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
