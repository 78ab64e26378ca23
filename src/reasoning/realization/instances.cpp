// The instances of one class expression.
#include <algorithm>
#include <string>

#include "reasoning/dl/clauses/clausify.hpp"
#include "reasoning/realization/memberships.hpp"
#include "reasoning/realization/realization.hpp"
#include "reasoning/realization/world.hpp"

namespace geminga::realization {
namespace {

using clauses::IndividualId;
using clauses::number;
using hypertableau::Verdict;

/// A class above the expression. Individuals outside of it in some model are not in the expression there.
owl::TermId add_class_above(owl::Ontology& source, owl::TermId expression) {
  const owl::TermId above = source.named_class(source.unused_name("about:instances"));
  source.add(owl::AxiomKind::sub_class_of, {expression, above}, owl::FileId{0}, 0);
  return above;
}

Instances as_instances(const clauses::ClauseSet& set, std::vector<IndividualId> found,
                       std::vector<IndividualId> undecided, const std::vector<IndividualId>& named) {
  Instances result;
  std::ranges::sort(found);
  std::ranges::sort(undecided);
  for (const IndividualId individual : named) {
    const owl::TermId term = set.individuals[number(individual)];
    if (std::ranges::binary_search(found, individual)) {
      result.found.push_back(term);
    } else if (std::ranges::binary_search(undecided, individual)) {
      result.undecided.push_back(term);
    }
  }
  return result;
}

}  // namespace

Instances find_instances(owl::Ontology& source, owl::TermId expression, const Options& options) {
  Instances failed;
  failed.is_consistency_open = true;
  const owl::TermId above = add_class_above(source, expression);
  if (source.problem()) {
    failed.gaps.push_back(*source.problem());
    return failed;
  }
  if (options.progress) options.progress("translating to clauses", 0);
  const auto clauses =
      clauses::clausify(source, std::nullopt, {}, std::span(&expression, 1), {.budget = options.budget});
  if (!clauses) {
    failed.gaps.push_back(clauses.error().text);
    return failed;
  }
  const clauses::ClauseSet& set = *clauses;
  const auto named = named_individuals(source, set);
  const auto place = std::ranges::find_if(set.concepts, [&](const clauses::Concept& entry) {
    return entry.kind == clauses::ConceptKind::named && entry.term == above;
  });
  Gaps gaps;
  note_unused(source, set, gaps);
  if (options.progress) options.progress("building a model", 0);
  hypertableau::FactModel model(source, set, limits_for(set, options));
  const hypertableau::Answer world = model.build();
  if (world.verdict == Verdict::no) {
    Instances none;
    none.is_consistent = false;
    return none;
  }
  const bool is_known = place != set.concepts.end();  // otherwise nothing can be in the expression
  const clauses::ConceptId of{static_cast<std::uint32_t>(place - set.concepts.begin())};
  const hypertableau::Individuals individuals = model.individuals();
  OpenQuestions open;
  Column& column = open.columns.emplace_back();
  column.of = of;
  column.complement = set.complements.front();
  std::vector<IndividualId> certain;
  for (const IndividualId individual : named) {
    const auto label = individuals.certain_label(individuals.certain_node(individual));
    const bool is_certain = is_known && std::ranges::find(label, of) != label.end();
    (is_certain ? certain : column.open).push_back(individual);
  }
  std::ranges::sort(column.open);
  if (world.verdict == Verdict::unknown) {
    gaps.insert(world.reason);
  } else if (!is_known) {
    column.open.clear();
  } else {
    decide(model, open, options, gaps);
  }
  certain.insert(certain.end(), column.found.begin(), column.found.end());
  Instances result = as_instances(set, std::move(certain), std::move(column.open), named);
  result.gaps.assign(gaps.begin(), gaps.end());
  result.is_consistency_open = world.verdict == Verdict::unknown || !set.unused.empty();
  return result;
}

}  // namespace geminga::realization
