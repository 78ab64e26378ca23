// Random ontologies: the reasoner against the naive one, whatever the order of axioms, and every explanation checked.
#include "base/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "reasoning/compiled/compile.hpp"
#include "support/reference.hpp"
#include "support/written.hpp"

namespace geminga::el {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::string shuffled(const std::string& text, base::Random& random) {
  std::vector<std::string> lines = lines_of(text);
  for (std::size_t at = lines.size(); at > 1; --at) std::swap(lines[at - 1], lines[random.below(at)]);
  std::string result;
  for (const std::string& line : lines) result += line + "\n";
  return result;
}

/// Whether everything in a sorted list is in another.
bool is_part(const std::vector<std::string>& part, const std::vector<std::string>& whole) {
  return std::ranges::includes(whole, part);
}

/// Whether all of `expected` follows from what was found: of a class that was found to be empty, everything does.
bool covers(const std::vector<std::string>& found, const std::vector<std::string>& expected) {
  const auto has = [&](const std::string& line) { return std::ranges::binary_search(found, line); };
  return has("inconsistent") || std::ranges::all_of(expected, [&](const std::string& line) {
           return has(line) || has(line.substr(0, line.find(' ')) + " < Nothing");
         });
}

TEST(RandomOntologies, AreClassifiedAsByTheNaiveReasoner) {
  int complete = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    base::Random random(seed);
    const std::string text = owl::random_ontology(random, 4 + random.below(16));
    SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + text);
    const owl::Ontology source = owl::written(text);
    const std::vector<std::string> found = owl::closure(owl::loaded(source));
    const std::vector<std::string> expected = owl::reference_closure(source);
    const bool is_complete = owl::classified(source).unused.empty();
    if (owl::has_range_over_chain(source)) {
      // What else follows from the ranges of chains is for tests/compare.
      ASSERT_TRUE(!is_complete || covers(found, expected));
    } else if (is_complete) {
      ++complete;
      ASSERT_EQ(found, expected);
    } else {
      ASSERT_TRUE(is_part(found, expected));
    }
  }
  EXPECT_GT(complete, 150);
}

TEST(RandomOntologies, GiveTheSameBytesInAnyOrder) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    base::Random random(seed);
    const std::string text = owl::random_ontology(random, 20);
    const auto without_lines = [](const owl::Ontology& read) {
      owl::Ontology copy;  // a shuffled file has other line numbers, and they are part of the bytes
      const owl::FileId file = copy.add_file("f");
      std::vector<owl::TermId> terms;
      for (std::uint32_t id = 0; id < read.term_count(); ++id) {
        const owl::Term term = read.term(owl::TermId{id});
        std::vector<owl::TermId> arguments;
        for (const owl::TermId argument : term.arguments)
          arguments.push_back(terms[static_cast<std::size_t>(argument)]);
        terms.push_back(copy.copy(term.kind, read.name(term.name), term.number, arguments));
      }
      for (std::size_t at = 0; at < read.axiom_count(); ++at) {
        const owl::Axiom axiom = read.axiom(at);
        std::vector<owl::TermId> arguments;
        for (const owl::TermId argument : axiom.arguments)
          arguments.push_back(terms[static_cast<std::size_t>(argument)]);
        copy.add(axiom.kind, arguments, file, 1);
      }
      return compiled::compile(copy, owl::classified(copy));
    };
    const std::string other = shuffled(text, random);
    ASSERT_EQ(without_lines(owl::written(text)), without_lines(owl::written(other))) << "seed " << seed << "\n" << text;
  }
}

}  // namespace
}  // namespace geminga::el
