// Groups of individuals that are certainly the same, with what a model says of each.
#ifndef GEMINGA_REASONING_REALIZATION_ROWS_HPP
#define GEMINGA_REASONING_REALIZATION_ROWS_HPP

#include <cstdint>
#include <map>
#include <vector>

#include "reasoning/realization/type_sets.hpp"
#include "reasoning/realization/world.hpp"
#include "reasoning/reasoner/named_concepts.hpp"

namespace geminga::realization {

/// One thing with one name or several.
struct Row {
  std::vector<clauses::IndividualId> names;  ///< ascending by IRI
  hypertableau::NodeId certain = 0;
  hypertableau::NodeId node = 0;
  std::uint32_t known = 0;     ///< certain types: a set of TypeSets
  std::uint32_t possible = 0;  ///< types in the model
};

/// The rows in the order of their first names.
[[nodiscard]] std::vector<Row> find_rows(const hypertableau::Individuals& individuals,
                                         const std::vector<clauses::IndividualId>& named,
                                         const reasoner::NamedConcepts& concepts, TypeSets& types);

/// Makes one row of the rows of each pair. The known types of the new row are those of both.
void unite(std::vector<Row>& rows, const std::vector<std::pair<clauses::IndividualId, clauses::IndividualId>>& same,
           TypeSets& types);

/// The rows that one node of the model stands for, two by two: the first one with each other.
[[nodiscard]] std::vector<std::pair<clauses::IndividualId, clauses::IndividualId>> possible_pairs(
    const std::vector<Row>& rows);

}  // namespace geminga::realization

#endif
