// Random ontologies: the closure against the tableau, and the same whatever the order and the number of threads.
#include <gtest/gtest.h>

#include <algorithm>

#include "reasoning/dl/consequence/written.hpp"
#include "reasoning/dl/hypertableau/tableau.hpp"
#include "support/rounds.hpp"

namespace geminga::consequence {
namespace {

using clauses::ConceptId;
using hypertableau::Verdict;

/// A class and the complements of all classes, asked for in one clause set.
struct Questions {
  owl::Ontology source;
  clauses::ClauseSet clauses;
  std::vector<ConceptId> classes;
  std::vector<ConceptId> complements;  ///< of each class
};

Questions questions_of(const std::string& axioms) {
  Questions questions{written(axioms), {}, {}, {}};
  const clauses::ClauseSet plain = clauses_of(questions.source);
  std::vector<owl::TermId> complements;
  for (const ConceptId named : named_classes(plain)) {
    complements.push_back(
        questions.source.term(owl::TermKind::object_complement_of, {plain.concepts[number(named)].term}));
  }
  questions.clauses = clauses_of(questions.source, complements);
  questions.classes = named_classes(questions.clauses);
  questions.complements = questions.clauses.queries;
  return questions;
}

/// Counts what both know. Where they differ, the test fails.
struct Agreement {
  int entailed = 0;
  int refuted = 0;
};

void compare(const Questions& questions, const Closure& closure, Agreement& agreement) {
  hypertableau::Tableau models(questions.source, questions.clauses);
  // There is at least one thing.
  const Verdict consistent = models.is_satisfiable({clauses::thing}).verdict;
  if (consistent == Verdict::unknown) return;
  if (consistent == Verdict::no) {
    EXPECT_TRUE(!closure.is_consistent || !closure.gaps.empty());
    return;
  }
  ASSERT_TRUE(closure.is_consistent);
  for (std::size_t i = 0; i < questions.classes.size(); ++i) {
    const auto& above = closure.subsumers[i];
    const bool is_unsatisfiable = std::ranges::binary_search(above, clauses::nothing);
    for (std::size_t j = 0; j < questions.classes.size(); ++j) {
      const bool is_derived = is_unsatisfiable || std::ranges::binary_search(above, questions.classes[j]);
      const Verdict differs = models.is_satisfiable({questions.classes[i], questions.complements[j]}).verdict;
      if (differs == Verdict::unknown) continue;
      SCOPED_TRACE("concepts " + std::to_string(number(questions.classes[i])) + " and " +
                   std::to_string(number(questions.classes[j])));
      if (is_derived) {
        ASSERT_EQ(differs, Verdict::no);
        ++agreement.entailed;
      } else if (closure.is_settled[i]) {
        ASSERT_EQ(differs, Verdict::yes);
        ++agreement.refuted;
      }
    }
  }
}

void compare_many(std::uint64_t first, std::uint64_t count, const Vocabulary& vocabulary, Agreement& agreement) {
  for (std::uint64_t seed = first; seed < first + test::rounds(count); ++seed) {
    base::Random random(seed);
    const std::string axioms = joined(random_axioms(random, vocabulary));
    SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + axioms);
    const Questions questions = questions_of(axioms);
    compare(questions, saturate(questions.source, questions.clauses, questions.classes), agreement);
    if (testing::Test::HasFailure()) return;
  }
}

TEST(RandomOntologies, HaveTheClosureThatModelsAllow) {
  Agreement agreement;
  compare_many(1, 150, {}, agreement);
  EXPECT_GT(agreement.entailed, test::rounds(2000));
  EXPECT_GT(agreement.refuted, test::rounds(2000));
}

TEST(RandomOntologies, WithFactsHaveTheClosureThatModelsAllow) {
  Agreement agreement;
  compare_many(1000, 81, {true, true}, agreement);
  compare_many(2000, 81, {true, false}, agreement);
  EXPECT_GT(agreement.entailed, test::rounds(1000));
}

TEST(RandomOntologies, HaveTheSameClosureInAnyOrderAndWithAnyNumberOfThreads) {
  for (std::uint64_t seed = 3000; seed < 3000 + test::rounds(81U); ++seed) {
    base::Random random(seed);
    std::vector<std::string> axioms = random_axioms(random, {seed % 2 == 0, true});
    SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + joined(axioms));
    const std::vector<std::string> expected = closure_of(joined(axioms));
    for (std::size_t at = axioms.size(); at > 1; --at) std::swap(axioms[at - 1], axioms[random.below(at)]);
    ASSERT_EQ(closure_of(joined(axioms)), expected);
    const owl::Ontology source = written(joined(axioms));
    clauses::ClauseSet clauses = clauses_of(source);
    for (std::size_t at = clauses.clauses.size(); at > 1; --at) {
      std::swap(clauses.clauses[at - 1], clauses.clauses[random.below(at)]);
    }
    for (const unsigned threads : {1U, 2U, 4U}) {
      ASSERT_EQ(lines_of(source, clauses, saturate(source, clauses, named_classes(clauses), {.threads = threads})),
                expected);
    }
  }
}

TEST(RandomOntologies, GiveForOneConceptWhatTheyGiveForAll) {
  for (std::uint64_t seed = 4000; seed < 4000 + test::rounds(41U); ++seed) {
    base::Random random(seed);
    const std::string axioms = joined(random_axioms(random, {}));
    SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + axioms);
    const owl::Ontology source = written(axioms);
    const clauses::ClauseSet clauses = clauses_of(source);
    const std::vector<ConceptId> classes = named_classes(clauses);
    const Closure whole = saturate(source, clauses, classes);
    if (!whole.is_consistent) continue;
    for (std::size_t i = 0; i < classes.size(); ++i) {
      const Closure one = saturate(source, clauses, std::span(classes).subspan(i, 1));
      ASSERT_EQ(one.subsumers[0], whole.subsumers[i]);
      ASSERT_LE(one.contexts, whole.contexts + 1);
    }
  }
}

}  // namespace
}  // namespace geminga::consequence
