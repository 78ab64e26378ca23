// Every named limit of a classification: one below it the result is less and says so; at the limit and above it is all.
#include "reasoning/el/limits.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include "reasoning/compiled/compile.hpp"
#include "reasoning/owl/role_box.hpp"
#include "support/written.hpp"

namespace geminga::el {
namespace {

/// A limit, and an ontology that needs a part of it.
struct Limit {
  const char* name;
  std::string axioms;
  std::function<void(ClassifyLimits& limits, std::size_t value)> set;
  ClassifyOptions options{};
  bool is_refused = false;  ///< below the limit there is no taxonomy at all
  bool is_complete = true;  ///< within the limit, el uses all axioms
};

void PrintTo(const Limit& one, std::ostream* out) { *out << one.name; }

class ALimit : public testing::TestWithParam<Limit> {
 protected:
  ALimit() : source_(owl::written(GetParam().axioms)), all_(closure_of(*classify(source_, GetParam().options))) {}

  [[nodiscard]] std::vector<std::string> closure_of(const taxonomy::Classification& found) const {
    return owl::closure(*compiled::Ontology::from_bytes(compiled::compile(source_, found)));
  }
  [[nodiscard]] std::expected<taxonomy::Classification, ClassifyError> within(std::size_t value) const {
    ClassifyOptions options = GetParam().options;
    GetParam().set(options.limits, value);
    return classify(source_, options);
  }
  [[nodiscard]] bool is_all(const std::expected<taxonomy::Classification, ClassifyError>& found) const {
    return found && found->unused.empty() == GetParam().is_complete && closure_of(*found) == all_;
  }

  const owl::Ontology source_;
  const std::vector<std::string> all_;
};

TEST_P(ALimit, IsExactAndSaidWhereItIsReached) {
  ASSERT_EQ(classify(source_, GetParam().options)->unused.empty(), GetParam().is_complete);
  std::size_t least = 0;
  while (least < 2'000 && !is_all(within(least))) {
    const auto found = within(least);
    ASSERT_EQ(!found, GetParam().is_refused) << least;
    if (found) {
      EXPECT_FALSE(found->unused.empty()) << "less is found with " << least << ", and nothing says so";
      for (const std::string& line : closure_of(*found)) EXPECT_TRUE(std::ranges::binary_search(all_, line)) << line;
    }
    ++least;
  }
  ASSERT_LT(least, 2'000U);
  ASSERT_GT(least, 0U) << "nothing is limited";
  EXPECT_FALSE(is_all(within(least - 1)));
  EXPECT_TRUE(is_all(within(least)));
  EXPECT_TRUE(is_all(within(least + 1)));
}

/// A line of wholes, each with the next one as its part: the class of the last one goes up, link by link.
std::string wholes(int depth) {
  std::string text = "InverseObjectProperties(p h)\nTransitiveObjectProperty(p)\nTransitiveObjectProperty(h)\n";
  for (int at = 0; at < depth; ++at) {
    const std::string n = std::to_string(at);
    const std::string next = std::to_string(at + 1);
    text += "SubClassOf(W" + n + " ObjectSomeValuesFrom(h W" + next + "))\n";
    text += "EquivalentClasses(C" + n + " ObjectIntersectionOf(W" + next + " ObjectSomeValuesFrom(p W" + n + ")))\n";
    text += "SubClassOf(ObjectSomeValuesFrom(h C" + n + ") H" + n + ")\n";
  }
  return text;
}

/// Unions that are parts of each other: the superclasses that the parts share are found from the innermost union.
std::string unions(int depth) {
  std::string text = "SubClassOf(P0 Z0)\nSubClassOf(Q0 Z0)\n";
  for (int at = 0; at < depth; ++at) {
    const std::string n = std::to_string(at);
    const std::string next = std::to_string(at + 1);
    text += "SubClassOf(U" + n + " ObjectUnionOf(P" + n + " Q" + n + "))\n";
    text += "SubClassOf(P" + next + " ObjectSomeValuesFrom(r U" + n + "))\nSubClassOf(ObjectSomeValuesFrom(r Z" + n +
            ") Z" + next + ")\nSubClassOf(Q" + next + " Z" + next + ")\n";
  }
  return text;
}

/// Classes below one nominal, each with a superclass of its own.
std::string of_one_individual(int count) {
  std::string text;
  for (int at = 0; at < count; ++at) {
    const std::string n = std::to_string(at);
    text += "SubClassOf(C" + n + " ObjectOneOf(i:a))\nSubClassOf(C" + n + " D" + n +
            ")\nSubClassOf(ObjectSomeValuesFrom(r D" + n + ") E)\n";
  }
  return text + "SubClassOf(ObjectOneOf(i:a) B)\n";
}

const Limit limits[] = {
    {"ConclusionsThatAreInherited",
     wholes(0) + "SubClassOf(A ObjectSomeValuesFrom(h B))\nSubClassOf(ObjectSomeValuesFrom(h B) C)\n",
     [](ClassifyLimits& within, std::size_t value) { within.conclusions = value; },
     {},
     true},
    {"ConclusionsThatAreSaturated",
     "SubClassOf(A ObjectSomeValuesFrom(h B))\nSubClassOf(ObjectSomeValuesFrom(h B) C)\n",
     [](ClassifyLimits& within, std::size_t value) { within.conclusions = value; },
     {.inherits = false},
     true},
    {"Worlds", of_one_individual(4), [](ClassifyLimits& within, std::size_t value) { within.worlds = value; }},
    {"RoundsOfInverses",
     wholes(3),
     [](ClassifyLimits& within, std::size_t value) { within.rounds_of_inverses = static_cast<unsigned>(value); },
     {},
     false,
     false},
    {"RoundsOfUnions", unions(3),
     [](ClassifyLimits& within, std::size_t value) { within.rounds_of_unions = static_cast<unsigned>(value); }},
    {"SuccessorContexts",
     wholes(3),
     [](ClassifyLimits& within, std::size_t value) { within.successors.contexts = value; },
     {},
     false,
     false},
    {"ExpressionsThatASuccessorGrowsBy",
     wholes(3),
     [](ClassifyLimits& within, std::size_t value) { within.successors.grown = value; },
     {},
     false,
     false},
};

INSTANTIATE_TEST_SUITE_P(OfAClassification, ALimit, testing::ValuesIn(limits),
                         [](const testing::TestParamInfo<Limit>& one) { return std::string(one.param.name); });

/// True if el uses every axiom.
bool is_used(const std::string& text, const ClassifyOptions& options = {}) {
  return classify(owl::written(text), options)->unused.empty();
}

TEST(StatesOfAnAutomaton, AreLimitedForARangeOverAChain) {
  // A chain of n links has an automaton of n + 1 states.
  const auto range_over = [](std::size_t links) {
    std::string chain;
    for (std::size_t at = 0; at < links; ++at) chain += " s" + std::to_string(at);
    return "SubObjectPropertyOf(ObjectPropertyChain(" + chain + ") r)\nObjectPropertyRange(r C)\n" +
           "SubClassOf(A ObjectSomeValuesFrom(s0 B))\n";
  };
  constexpr std::size_t most = 1000;
  const ClassifyOptions by_rules = {.inherits = false};
  EXPECT_TRUE(is_used(range_over(most - 2), by_rules));
  EXPECT_TRUE(is_used(range_over(most - 1), by_rules));
  EXPECT_FALSE(is_used(range_over(most), by_rules));
  EXPECT_TRUE(is_used(range_over(most))) << "a range that changes nothing needs no automaton";
}

TEST(MirrorImagesOfAChain, AreLimited) {
  // s o u < r, where s has n inverses and u one: w o t < v for each t of these.
  const auto images = [](std::size_t inverses_of_first) {
    std::string text = "SubObjectPropertyOf(ObjectPropertyChain(s u) r)\nInverseObjectProperties(r v)\n";
    text += "InverseObjectProperties(u w)\n";
    for (std::size_t at = 0; at < inverses_of_first; ++at)
      text += "SubObjectPropertyOf(t" + std::to_string(at) + " ObjectInverseOf(s))\n";
    return text +
           "SubClassOf(A ObjectSomeValuesFrom(w B))\nSubClassOf(B ObjectSomeValuesFrom(t0 C))\n"
           "SubClassOf(ObjectSomeValuesFrom(v C) D)\n";
  };
  constexpr std::size_t most = 16;
  for (const std::size_t few : {most - 1, most}) {
    EXPECT_TRUE(is_used(images(few))) << few;
    EXPECT_TRUE(std::ranges::binary_search(owl::closure(images(few)), "A < D")) << few;
  }
  EXPECT_FALSE(is_used(images(most + 1)));
}

TEST(AutomatonOfARole, OfAStateTooManyIsLeftOutWithItsChainNamed) {
  // a o a o a o a < r: three states between the first and the last.
  const auto role = [](std::uint32_t number) { return owl::Role{owl::PropertyId{number}, false}; };
  const std::vector<owl::RoleChain> chains = {{{role(0), role(0), role(0), role(0)}, role(1), 7}};
  constexpr std::size_t states = 5;
  const owl::RoleBox less(2, {}, chains, states - 1);
  EXPECT_EQ(std::vector(less.left_out().begin(), less.left_out().end()), std::vector<std::uint32_t>{7});
  for (const std::size_t most : {states, states + 1}) {
    const owl::RoleBox box(2, {}, chains, most);
    EXPECT_TRUE(box.left_out().empty()) << most;
    EXPECT_EQ(box.automaton(role(1)).state_count(), states);
  }
}

}  // namespace
}  // namespace geminga::el
