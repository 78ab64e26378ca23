// Random ontologies: the reasoner against a naive one and the engines beyond EL, whatever the order of axioms.
#include "base/random.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <sstream>

#include "compare/opinions.hpp"
#include "reasoning/compiled/compile.hpp"
#include "support/reference.hpp"
#include "support/rounds.hpp"
#include "support/written.hpp"

namespace geminga::el {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

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

std::vector<std::string> without(const std::vector<std::string>& lines, const std::vector<std::string>& others) {
  std::vector<std::string> rest;
  std::ranges::set_difference(lines, others, std::back_inserter(rest));
  return rest;
}

/// The exact closure of an ontology with a range over a chain, of which the naive reasoner knows too little: that of
/// the consequence-based engine, or of the tableau if the engine leaves a gap. Pairs that both leave open are not in
/// it, so that the test fails if el derives one.
std::vector<std::string> closure_beyond_the_naive_one(const owl::Ontology& source) {
  compare::Opinion opinion = compare::of_consequence(source);
  if (!opinion.is_complete) opinion = compare::of_the_tableau(source);
  constexpr std::string_view space = "https://t.example/#";
  for (std::string& line : opinion.closure) {
    for (auto at = line.find(space); at != std::string::npos; at = line.find(space)) line.erase(at, space.size());
  }
  std::ranges::sort(opinion.closure);
  return opinion.closure;
}

/// The errors of a closure: lines that do not follow, and missing lines if it is said to be complete.
std::vector<std::string> faults(const owl::Ontology& source, const std::vector<std::string>& found, bool is_complete) {
  const std::vector<std::string> expected =
      owl::has_range_over_chain(source) ? closure_beyond_the_naive_one(source) : owl::reference_closure(source);
  std::vector<std::string> wrong = without(found, expected);
  if (is_complete) std::ranges::copy(without(expected, found), std::back_inserter(wrong));
  return wrong;
}

TEST(RandomOntologies, AreClassifiedAsByTheNaiveReasoner) {
  int complete = 0;
  int beyond = 0;
  for (std::uint64_t seed = 1; seed <= test::rounds(300U); ++seed) {
    base::Random random(seed);
    const std::string text = owl::random_ontology(random, 4 + random.below(16));
    SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + text);
    const owl::Ontology source = owl::written(text);
    const bool is_complete = owl::classified(source).unused.empty();
    ASSERT_THAT(faults(source, owl::closure(owl::loaded(source)), is_complete), IsEmpty());
    if (is_complete) ++(owl::has_range_over_chain(source) ? beyond : complete);
  }
  EXPECT_GT(complete, test::rounds(150));
  if (test::percent_of_rounds() >= 100) {  // a few rounds may have none
    EXPECT_GE(beyond, test::rounds(4));
  }
}

TEST(RandomOntologies, WouldShowAnUnsoundClosure) {
  // An element that r and then s lead to is one that t leads to, so that it is a C.
  const owl::Ontology source = owl::written(
      "SubClassOf(A ObjectSomeValuesFrom(r ObjectSomeValuesFrom(s B)))\n"
      "SubObjectPropertyOf(ObjectPropertyChain(r s) t)\n"
      "ObjectPropertyRange(t C)\n"
      "SubClassOf(ObjectSomeValuesFrom(t C) D)\n"
      "SubClassOf(Empty Nothing)\n");
  ASSERT_TRUE(owl::has_range_over_chain(source));
  EXPECT_THAT(faults(source, {"A < D", "Empty < Nothing"}, true), IsEmpty());
  EXPECT_THAT(faults(source, {"A < Nothing", "Empty < Nothing"}, true), ElementsAre("A < Nothing", "A < D"));
  EXPECT_THAT(faults(source, {"A < D", "B < C", "Empty < Nothing"}, false), ElementsAre("B < C"));
  EXPECT_THAT(faults(source, {"inconsistent"}, false), ElementsAre("inconsistent"));
}

TEST(RandomOntologies, GiveTheSameBytesInAnyOrder) {
  for (std::uint64_t seed = 1; seed <= test::rounds(60U); ++seed) {
    base::Random random(seed);
    const std::string text = owl::random_ontology(random, 20);
    const auto without_lines = [](const owl::Ontology& read) {
      owl::Ontology copy;  // line numbers are part of the bytes, and a shuffled file has others
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
