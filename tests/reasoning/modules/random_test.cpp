// Random ontologies: a module entails what the whole ontology entails about its signature, as the engines judge both.
#include "base/random.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "compare/functional_syntax.hpp"
#include "compare/opinions.hpp"
#include "extracted.hpp"
#include "support/random_ontology.hpp"
#include "support/rounds.hpp"

namespace geminga::modules {
namespace {

using compare::Opinion;
using compare::Profile;
using testing::IsEmpty;

constexpr std::uint64_t seeds = 150;

class RandomModules : public testing::TestWithParam<Profile> {};

/// Up to three named classes and at most one property of a source.
std::vector<std::string> random_signature(const owl::Ontology& source, base::Random& random) {
  std::vector<std::string> classes;
  std::vector<std::string> properties;
  for (std::uint32_t id = 0; id < source.term_count(); ++id) {
    const owl::TermId term{id};
    const bool is_built_in = term == owl::thing_term || term == owl::nothing_term;
    if (source.kind(term) == owl::TermKind::named_class && !is_built_in) classes.emplace_back(source.name_of(term));
    if (source.kind(term) == owl::TermKind::object_property) properties.emplace_back(source.name_of(term));
  }
  std::vector<std::string> signature;
  const std::uint64_t count = random.below(4);
  for (std::uint64_t at = 0; at < count && !classes.empty(); ++at) {
    signature.push_back(classes[random.below(classes.size())]);
  }
  if (!properties.empty() && random.below(4) == 0) signature.push_back(properties[random.below(properties.size())]);
  return signature;
}

/// The lines of a closure about classes of the signature or about everything.
cases::Closure about(const cases::Closure& closure, const std::vector<std::string>& signature) {
  cases::Closure lines;
  for (const std::string& line : closure) {
    const std::string sub = line.substr(0, line.find(" < "));
    if (line == "inconsistent" || sub == "Thing" || std::ranges::find(signature, sub) != signature.end()) {
      lines.push_back(line);
    }
  }
  return lines;
}

TEST_P(RandomModules, EntailWhatTheOntologyEntailsAboutTheirSignature) {
  std::size_t compared = 0;
  std::size_t smaller = 0;
  for (std::uint64_t seed = 1; seed <= test::rounds(seeds); ++seed) {
    const owl::Ontology source = numbered(compare::random_ontology(GetParam(), seed, 4 + seed % 14));
    base::Random random(seed);
    const std::vector<std::string> signature = random_signature(source, random);
    const std::vector<std::uint32_t> lines = lines_of_module(source, signature);
    const owl::Ontology module = only(source, lines);
    SCOPED_TRACE("profile " + std::string(to_string(GetParam())) + ", seed " + std::to_string(seed) + ", signature " +
                 testing::PrintToString(signature) + "\n" + compare::functional_syntax(source) + "\nmodule\n" +
                 compare::functional_syntax(module));
    smaller += lines.size() < source.axiom_count() ? 1U : 0U;

    const Opinion whole = compare::of_the_reasoner(source);
    const Opinion part = compare::of_the_reasoner(module);
    if (part.is_complete) {
      ++compared;
      EXPECT_THAT(cases::without(about(whole.closure, signature), about(part.closure, signature)), IsEmpty());
    }
    if (whole.is_complete) {
      EXPECT_THAT(cases::unsound(part.closure, whole.closure), IsEmpty());
    }

    const Opinion el = compare::of_el(module);
    if (el.is_complete) {
      EXPECT_THAT(cases::without(about(whole.closure, signature), about(el.closure, signature)), IsEmpty()) << "el";
    }
    if (HasFailure()) return;  // one ontology at a time is enough to look at
  }
  EXPECT_GT(compared, test::rounds(seeds / 2)) << "the comparison says little where most is left open";
  EXPECT_GT(smaller, test::rounds(seeds / 10)) << "the comparison says little where the module is the whole ontology";
}

INSTANTIATE_TEST_SUITE_P(Profile, RandomModules, testing::ValuesIn(compare::profiles),
                         [](const auto& one) { return std::string(to_string(one.param)); });

}  // namespace
}  // namespace geminga::modules
