// The clauses of an ontology, and how much work a model of its facts may take.
#ifndef GEMINGA_REASONING_REALIZATION_WORLD_HPP
#define GEMINGA_REASONING_REALIZATION_WORLD_HPP

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "reasoning/dl/clauses/clause.hpp"
#include "reasoning/dl/hypertableau/fact_model.hpp"
#include "reasoning/realization/realization.hpp"

namespace geminga::realization {

/// Lines that say why something may be missing.
using Gaps = std::set<std::string>;

/// Limits that grow with the facts, so that any number of facts has a model and a small file takes the memory of one.
[[nodiscard]] hypertableau::QuestionLimits limits_for(const clauses::ClauseSet& set, const Options& options);

/// Notes the axioms of which the clauses do not say all.
void note_unused(const owl::Ontology& source, const clauses::ClauseSet& set, Gaps& gaps);

/// A concept that excludes `of`, and is in no other clause. The clauses stay sorted if sort_clauses() follows.
[[nodiscard]] clauses::ConceptId add_complement(clauses::ClauseSet& set, clauses::ConceptId of);
/// Two concepts such that nothing in the first has a link by the property to anything in the second.
[[nodiscard]] std::pair<clauses::ConceptId, clauses::ConceptId> add_unlinked(clauses::ClauseSet& set,
                                                                             clauses::PropertyId property);
void sort_clauses(clauses::ClauseSet& set);

/// The named individuals of the set, ascending by IRI.
[[nodiscard]] std::vector<clauses::IndividualId> named_individuals(const owl::Ontology& source,
                                                                   const clauses::ClauseSet& set);

}  // namespace geminga::realization

#endif
