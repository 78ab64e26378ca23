// The order of axioms changes nothing: neither what follows nor what is undecided.
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "base/budget.hpp"
#include "base/random.hpp"
#include "compare/functional_syntax.hpp"
#include "compare/shapes.hpp"
#include "reasoning/reasoner/reasoner.hpp"
#include "reasoning/syntax/functional/read.hpp"
#include "support/rounds.hpp"

namespace geminga::compare {
namespace {

/// Most of the ontologies need less. What is undecided where they end does not depend on the order, either.
constexpr std::uint64_t steps = 1'000'000;

/// The ontology of the lines of a document: the first, the axioms and declarations, and the last.
owl::Ontology read_lines(const std::vector<std::string>& lines) {
  std::string all;
  for (const std::string& line : lines) all += line + '\n';
  owl::Ontology result;
  EXPECT_TRUE(functional::read(all, result.add_file("again.ofn"), result, {.wrong_axioms = 0}));
  return result;
}

/// The taxonomy, the gaps and the undecided classes.
std::string answer_of(const owl::Ontology& source) {
  base::Budget budget(steps);
  const auto found = reasoner::classify(source, {.alternatives = 20, .budget = &budget});
  if (!found) return found.error().text;
  const auto name = [&](taxonomy::ClassNumber of) {
    return std::string(source.name(found->classes[static_cast<std::size_t>(of)])) + ' ';
  };
  std::string text;
  for (std::uint32_t of = 0; of < found->class_count(); ++of) {
    text += name(taxonomy::ClassNumber{of}) + "= " + name(found->representative[of]) + "< ";
    for (const taxonomy::ClassNumber parent : found->parents_of(taxonomy::ClassNumber{of})) text += name(parent);
    text += '\n';
  }
  for (const std::string& gap : found->gaps) text += gap + '\n';
  for (const taxonomy::ClassNumber of : found->undecided.classes) text += "undecided: " + name(of) + '\n';
  return text;
}

void expect_one_answer(const owl::Ontology& source, std::uint64_t seed) {
  base::Random random(seed);
  std::istringstream text(functional_syntax(source));
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  const std::string expected = answer_of(read_lines(lines));
  for (int order = 0; order < 2; ++order) {
    for (std::size_t at = lines.size() - 2; at > 1; --at) std::swap(lines[at], lines[1 + random.below(at)]);
    EXPECT_EQ(answer_of(read_lines(lines)), expected) << "seed " << seed << '\n' << functional_syntax(source);
  }
}

TEST(OrderOfAxioms, ChangesNeitherTheAnswerNorWhatIsUndecided) {
  for (std::uint64_t seed = 1; seed <= test::rounds(30U); ++seed) {
    expect_one_answer(pairings(seed, 3 + seed % 8), seed);
    expect_one_answer(features(seed, 4 + seed % 6), seed);
    expect_one_answer(qualified_numbers(seed), seed);
    expect_one_answer(anatomy(seed, 4 + seed % 12), seed);
    expect_one_answer(enumeration(seed, 3 + seed % 6), seed);
    if (testing::Test::HasFailure()) return;
  }
}

}  // namespace
}  // namespace geminga::compare
