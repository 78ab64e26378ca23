// Modules of the three kinds: construct by construct, and of random ontologies, as the reasoner judges them.
#include "reasoning/modules/signature_module.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "base/random.hpp"
#include "compare/functional_syntax.hpp"
#include "compare/opinions.hpp"
#include "extracted.hpp"
#include "reasoning/modules/module.hpp"
#include "support/random_ontology.hpp"
#include "support/rounds.hpp"
#include "support/written.hpp"

namespace geminga::modules {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// The entities of a source that have one of these names.
std::vector<owl::TermId> terms_of(const owl::Ontology& source, const std::vector<std::string>& names) {
  std::vector<owl::TermId> terms;
  for (std::uint32_t id = 0; id < source.term_count(); ++id) {
    const owl::TermId term{id};
    if (source.kind(term) > owl::TermKind::individual) continue;
    if (std::ranges::find(names, source.name_of(term)) != names.end()) terms.push_back(term);
  }
  return terms;
}

std::vector<std::uint32_t> lines(const owl::Ontology& source, const std::vector<std::string>& names, ModuleKind kind) {
  std::vector<std::uint32_t> found;
  for (const std::uint32_t axiom : extract_module(source, terms_of(source, names), kind))
    found.push_back(source.axiom(axiom).line);
  return found;
}

std::vector<std::uint32_t> lines(std::string_view text, std::vector<std::string> names, ModuleKind kind) {
  for (std::string& name : names) name = "https://t.example/#" + name;
  return lines(owl::written(text), names, kind);
}

constexpr std::string_view ladder = "SubClassOf(A B)\nSubClassOf(B C)\nSubClassOf(C D)\nSubClassOf(X B)";

TEST(SignatureModule, OfTheBottomGoesUpAndOfTheTopGoesDown) {
  EXPECT_THAT(lines(ladder, {"B"}, ModuleKind::bottom), ElementsAre(2, 3));
  EXPECT_THAT(lines(ladder, {"B"}, ModuleKind::top), ElementsAre(1, 4));
}

TEST(SignatureModule, OfTheStarHasOnlyTheWayBetweenNames) {
  EXPECT_THAT(lines(ladder, {"A", "C"}, ModuleKind::star), ElementsAre(1, 2));
  EXPECT_THAT(lines(ladder, {"A"}, ModuleKind::star), IsEmpty());
  EXPECT_THAT(lines(ladder, {"A", "X"}, ModuleKind::star), IsEmpty());
  EXPECT_THAT(lines("SubClassOf(A ObjectSomeValuesFrom(r B))\nSubClassOf(ObjectSomeValuesFrom(r C) D)\nSubClassOf(B C)",
                    {"A", "D"}, ModuleKind::star),
              ElementsAre(1, 2, 3));
}

TEST(SignatureModule, HasFactsAndWhatTheyNeed) {
  EXPECT_THAT(lines("ClassAssertion(A i:a)\nSubClassOf(A B)\nSubClassOf(C D)", {}, ModuleKind::bottom),
              ElementsAre(1, 2));
  EXPECT_THAT(lines("ClassAssertion(A i:a)\nSubClassOf(A B)\nSubClassOf(C D)", {}, ModuleKind::star), IsEmpty());
  EXPECT_THAT(lines("ClassAssertion(A i:a)\nSubClassOf(A B)\nSubClassOf(C D)", {"B"}, ModuleKind::star),
              ElementsAre(1, 2));
}

TEST(SignatureModule, DoesNotHoldTautologies) {
  for (const ModuleKind kind : {ModuleKind::bottom, ModuleKind::top, ModuleKind::star}) {
    EXPECT_THAT(lines("SubClassOf(A Thing)\nSubClassOf(Nothing A)\nSubClassOf(A ObjectUnionOf(B "
                      "ObjectComplementOf(Nothing)))\nSubClassOf(A ObjectMinCardinality(0 r B))",
                      {"A", "B", "r"}, kind),
                IsEmpty());
  }
}

class RandomSignatureModules : public testing::TestWithParam<compare::Profile> {};

/// The lines of a closure about two classes of the signature, and contradictions.
cases::Closure between(const cases::Closure& closure, const std::vector<std::string>& names) {
  const auto is_named = [&](const std::string& name) {
    return name == "Thing" || name == "Nothing" || std::ranges::find(names, name) != names.end();
  };
  cases::Closure found;
  for (const std::string& line : closure) {
    const std::size_t arrow = line.find(" < ");
    if (arrow == std::string::npos || (is_named(line.substr(0, arrow)) && is_named(line.substr(arrow + 3))))
      found.push_back(line);
  }
  return found;
}

TEST_P(RandomSignatureModules, EntailWhatTheOntologyEntailsBetweenTheirNames) {
  std::size_t smaller = 0;
  for (std::uint64_t seed = 1; seed <= test::rounds(std::uint64_t{60}); ++seed) {
    const owl::Ontology source = numbered(compare::random_ontology(GetParam(), seed, 4 + seed % 14));
    base::Random random(seed);
    std::vector<std::string> names;
    for (std::uint32_t id = 2; id < source.term_count(); ++id) {
      const owl::TermId term{id};
      if (source.kind(term) == owl::TermKind::named_class && random.chance(0.4))
        names.emplace_back(source.name_of(term));
    }
    const cases::Closure whole = compare::of_the_reasoner(source).closure;
    const std::vector<std::uint32_t> bottom = lines(source, names, ModuleKind::bottom);
    for (const ModuleKind kind : {ModuleKind::bottom, ModuleKind::top, ModuleKind::star}) {
      const std::vector<std::uint32_t> kept = lines(source, names, kind);
      const owl::Ontology module = only(source, kept);
      const compare::Opinion part = compare::of_the_reasoner(module);
      smaller += kept.size() < source.axiom_count() ? 1U : 0U;
      EXPECT_TRUE(kind != ModuleKind::star || std::ranges::includes(bottom, kept));
      if (!part.is_complete) continue;
      EXPECT_THAT(cases::without(between(whole, names), between(part.closure, names)), IsEmpty())
          << to_string(GetParam()) << ", seed " << seed << ", kind " << static_cast<int>(kind) << ", names "
          << testing::PrintToString(names) << '\n'
          << compare::functional_syntax(source) << "\nmodule\n"
          << compare::functional_syntax(module);
    }
    if (HasFailure()) return;
  }
  EXPECT_GT(smaller, test::rounds(std::size_t{6}));
}

INSTANTIATE_TEST_SUITE_P(Profile, RandomSignatureModules, testing::ValuesIn(compare::profiles),
                         [](const auto& one) { return std::string(to_string(one.param)); });

}  // namespace
}  // namespace geminga::modules
