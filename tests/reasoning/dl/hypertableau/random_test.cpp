// Random ontologies: what the saturation of EL derives cannot fail in a model, and what it does not derive can.
#include "base/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "reasoning/dl/clauses/clausify.hpp"
#include "reasoning/dl/hypertableau/tableau.hpp"
#include "support/reference.hpp"
#include "support/rounds.hpp"
#include "support/written.hpp"

namespace geminga::hypertableau {
namespace {

using owl::TermId;

/// Every subsumption as closure() of tests/reasoning/el writes it, by looking for a counter-model of each.
/// Nothing where an axiom is outside OWL 2 DL.
std::optional<std::vector<std::string>> closure_by_models(const owl::Ontology& source) {
  std::vector<TermId> classes = {owl::thing_term};
  for (std::size_t at = 0; at < source.axiom_count(); ++at) {
    std::vector<TermId> open(source.axiom(at).arguments.begin(), source.axiom(at).arguments.end());
    while (!open.empty()) {
      const TermId term = open.back();
      open.pop_back();
      const auto arguments = source.term(term).arguments;
      open.insert(open.end(), arguments.begin(), arguments.end());
      if (source.kind(term) == owl::TermKind::named_class && term != owl::nothing_term) classes.push_back(term);
    }
  }
  std::ranges::sort(classes);
  const auto repeated = std::ranges::unique(classes);
  classes.erase(repeated.begin(), repeated.end());
  const auto set = clauses::clausify(source, std::nullopt, classes, classes);
  if (!set) {
    ADD_FAILURE() << set.error().text;
    return std::nullopt;
  }
  if (!set->unused.empty()) return std::nullopt;
  Tableau tableau(source, *set);
  const auto is_possible = [&](std::vector<clauses::ConceptId> together) {
    const Answer answer = tableau.is_satisfiable(std::move(together));
    EXPECT_NE(answer.verdict, Verdict::unknown) << answer.reason;
    return answer.verdict == Verdict::yes;
  };
  const auto name_of = [&](std::size_t at) {
    const std::string_view iri = source.name_of(classes[at]);
    return std::string(iri.substr(iri.find('#') + 1));
  };
  std::vector<std::string> lines;
  for (std::size_t sub = 0; sub < classes.size(); ++sub) {
    if (!is_possible({set->queries[sub]})) {
      lines.push_back(name_of(sub) + " < Nothing");
      continue;
    }
    const std::vector<clauses::ConceptId> certain = tableau.model().certain;
    for (std::size_t super = 0; super < classes.size(); ++super) {
      if (super == sub || classes[super] == owl::thing_term) continue;
      const bool holds = !is_possible({set->queries[sub], set->complements[super]});
      if (holds) lines.push_back(name_of(sub) + " < " + name_of(super));
      EXPECT_TRUE(holds || !std::ranges::binary_search(certain, set->queries[super]))
          << name_of(sub) << " is certainly in " << name_of(super);
    }
  }
  std::ranges::sort(lines);
  return lines;
}

TEST(RandomOntologies, HaveCounterModelsExactlyOfWhatTheNaiveReasonerDoesNotDerive) {
  int compared = 0;
  for (std::uint64_t seed = 1; seed <= test::rounds(200U); ++seed) {
    base::Random random(seed);
    const std::string text = owl::random_ontology(random, 4 + random.below(12));
    SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + text);
    const owl::Ontology source = owl::written(text);
    const std::vector<std::string> expected = owl::reference_closure(source);
    const auto found = closure_by_models(source);
    if (!found || expected == std::vector<std::string>{"inconsistent"}) continue;
    ++compared;
    ASSERT_EQ(*found, expected);
  }
  EXPECT_GT(compared, test::rounds(75));
}

}  // namespace
}  // namespace geminga::hypertableau
