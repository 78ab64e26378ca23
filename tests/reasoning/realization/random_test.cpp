// Random ontologies with individuals: what is found is what follows when each statement is asked by itself.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "reasoning/owl/print.hpp"
#include "reasoning/realization/realization.hpp"
#include "reasoning/reasoner/reasoner.hpp"
#include "support/random_ontology.hpp"

namespace geminga::realization {
namespace {

using compare::Profile;
using owl::TermId;
using owl::TermKind;
using reasoner::Verdict;

constexpr std::uint64_t seeds = 150;
/// Beside the axioms of a profile, facts about its individuals.
constexpr std::size_t facts = 4;

/// The entities of one kind that the axioms name.
std::vector<TermId> entities(const owl::Ontology& source, TermKind kind) {
  std::vector<TermId> roots;
  for (std::size_t at = 0; at < source.axiom_count(); ++at) {
    for (const TermId argument : source.axiom(at).arguments) roots.push_back(argument);
  }
  std::vector<TermId> found;
  for (const TermId id : owl::terms_in(source, roots)) {
    if (source.kind(id) == kind && !source.name_of(id).starts_with("http://www.w3.org/")) found.push_back(id);
  }
  return found;
}

/// Random axioms, and types and links of the individuals among them.
owl::Ontology with_facts(Profile profile, std::uint64_t seed) {
  owl::Ontology source = compare::random_ontology(profile, seed, 5 + seed % 8);
  const auto classes = entities(source, TermKind::named_class);
  const auto properties = entities(source, TermKind::object_property);
  std::vector<TermId> individuals;
  for (const char* const name : {"0", "1", "2"})
    individuals.push_back(source.individual("http://random.example/#i" + std::string(name)));
  std::uint64_t state = seed;
  const auto below = [&](std::size_t count) {
    state = state * 6364136223846793005U + 1442695040888963407U;
    return (state >> 33) % count;
  };
  for (std::size_t at = 0; at < facts; ++at) {
    const TermId first = individuals[below(individuals.size())];
    if (!classes.empty())
      source.add(owl::AxiomKind::class_assertion, {classes[below(classes.size())], first}, owl::FileId{0}, 0);
    if (!properties.empty())
      source.add(owl::AxiomKind::object_property_assertion,
                 {properties[below(properties.size())], first, individuals[below(individuals.size())]}, owl::FileId{0},
                 0);
  }
  return source;
}

std::string axioms_of(const owl::Ontology& source) {
  std::string text;
  for (std::size_t at = 0; at < source.axiom_count(); ++at)
    text += owl::print(source, source.axiom(at), [](std::string_view iri) { return std::string(iri); }) + '\n';
  return text;
}

Verdict follows(owl::Ontology& source, TermId individual, TermId expression) {
  const TermId one = source.term(TermKind::object_one_of, {individual});
  return reasoner::entails(source, std::nullopt, one, expression).verdict;
}

std::string text_of(const owl::Ontology& source, TermId individual, TermId other) {
  return std::string(source.name_of(individual)) + ' ' + std::string(source.name_of(other));
}

/// Expects that what is found follows, and that what is not found does not follow where nothing was left open.
void expect_agreement(bool is_found, bool is_complete, Verdict expected, const std::string& statement) {
  if (is_found) {
    EXPECT_NE(expected, Verdict::no) << statement << " is found and does not follow";
  } else if (is_complete) {
    EXPECT_NE(expected, Verdict::yes) << statement << " follows and is not found";
  }
}

class RandomFacts : public testing::TestWithParam<Profile> {};

TEST_P(RandomFacts, GiveTheTypesThatFollowOneByOne) {
  std::size_t complete = 0;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    owl::Ontology source = with_facts(GetParam(), seed);
    SCOPED_TRACE("seed " + std::to_string(seed) + '\n' + axioms_of(source));
    const auto classification = reasoner::classify(source);
    ASSERT_TRUE(classification);
    const Realization found = realize(source, *classification, {.with_facts = true});
    if (!found.is_consistent) {
      EXPECT_NE(reasoner::is_consistent(source).verdict, Verdict::yes);
      continue;
    }
    const bool is_complete = found.gaps.empty() && classification->gaps.empty() && classification->unused.empty();
    complete += is_complete ? 1U : 0U;
    for (std::size_t at = 0; at < found.individuals.size(); ++at) {
      const TermId individual = found.individuals[at];
      const auto& types = found.type_sets[found.types[at]];
      for (std::size_t of = 0; of < classification->class_count(); ++of) {
        const auto number = classification->representative[of];
        if (number == classification->representative[static_cast<std::size_t>(classification->thing)]) continue;
        const TermId term = source.named_class(std::string(source.name(classification->classes[of])));
        const Verdict expected = follows(source, individual, term);
        const bool is_found = std::ranges::binary_search(types, number);
        expect_agreement(is_found, is_complete, expected, text_of(source, individual, term));
      }
      for (std::size_t other = 0; other < found.individuals.size(); ++other) {
        const TermId one = source.term(TermKind::object_one_of, {found.individuals[other]});
        const Verdict expected = follows(source, individual, one);
        const bool is_found = found.representative[at] == found.representative[other];
        expect_agreement(is_found, is_complete, expected, text_of(source, individual, found.individuals[other]));
      }
      for (const TermId property : entities(source, TermKind::object_property)) {
        for (const TermId object : found.individuals) {
          const TermId value = source.term(TermKind::object_has_value, {property, object});
          const Verdict expected = follows(source, individual, value);
          const bool is_found = std::ranges::binary_search(found.facts, Fact{individual, property, object});
          expect_agreement(is_found, is_complete, expected,
                           text_of(source, individual, property) + ' ' + std::string(source.name_of(object)));
        }
      }
    }
    if (HasFailure()) return;  // one ontology at a time is enough to look at
  }
  EXPECT_GT(complete, seeds / 4) << "the comparison says little where most is left open";
}

TEST_P(RandomFacts, GiveTheInstancesThatFollowOneByOne) {
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    owl::Ontology source = with_facts(GetParam(), seed);
    const auto classes = entities(source, TermKind::named_class);
    const auto properties = entities(source, TermKind::object_property);
    if (classes.empty() || properties.empty()) continue;
    const TermId first = classes[seed % classes.size()];
    const TermId second = classes[(seed / 3) % classes.size()];
    const TermId outside = source.term(TermKind::object_complement_of, {second});
    const TermId expressions[] = {first, outside,
                                  source.term(TermKind::object_some_values_from, {properties.front(), first}),
                                  source.term(TermKind::object_all_values_from, {properties.front(), first}),
                                  source.term(TermKind::object_union_of, {first, outside})};
    const TermId expression = expressions[seed % std::size(expressions)];
    owl::Ontology asked = source;
    const Instances found = find_instances(asked, expression);
    if (!found.is_consistent) continue;
    for (const TermId individual : entities(source, TermKind::individual)) {
      const Verdict expected = follows(source, individual, expression);
      const bool is_found = std::ranges::find(found.found, individual) != found.found.end();
      expect_agreement(is_found, found.gaps.empty(), expected, std::string(source.name_of(individual)));
    }
    if (HasFailure()) return;
  }
}

INSTANTIATE_TEST_SUITE_P(Profile, RandomFacts,
                         testing::Values(Profile::horn, Profile::choices, Profile::chains, Profile::nominals),
                         [](const auto& param) { return std::string(compare::to_string(param.param)); });

}  // namespace
}  // namespace geminga::realization
