// Conflicts of data ranges: ranges without values, and pairs without a common value.
//
// Ranges occur in heads only, so it is enough to know which sets of ranges are empty. Unions, intersections, lists of
// values and their complements are split into datatypes, single values and complements of either. Among these, the
// empty sets of one or two ranges are found. Other sets that may be empty are a gap.
#ifndef GEMINGA_REASONING_DL_CONSEQUENCE_RULES_RANGE_CONFLICTS_HPP
#define GEMINGA_REASONING_DL_CONSEQUENCE_RULES_RANGE_CONFLICTS_HPP

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "reasoning/dl/clauses/clause.hpp"
#include "reasoning/owl/source.hpp"

namespace geminga::consequence {

/// A range that is the union or the intersection of others.
struct RangeParts {
  std::size_t range = 0;
  bool is_union = false;
  std::vector<std::size_t> parts;
};
/// Splits ranges, and appends the parts that are not among the ranges yet.
[[nodiscard]] std::vector<RangeParts> take_apart(const owl::Ontology& source,
                                                 std::span<const clauses::DatatypeDefinition> definitions,
                                                 std::vector<clauses::DataRange>& ranges);

struct ValueConflicts {
  std::vector<std::size_t> empty;                             ///< ranges that have no value
  std::vector<std::pair<std::size_t, std::size_t>> disjoint;  ///< pairs that have none in common
  /// For each range that is the value of one literal: the number of the value, from 1. 0 for other ranges. Ranges with
  /// different numbers are disjoint. They are not listed as disjoint, because there may be very many.
  std::vector<std::uint32_t> value_number;
  bool is_finite = false;  ///< a range has finitely many values, so that counting them may matter
  /// By range: whether it is not understood, alone or together with every other range.
  std::vector<bool> is_unclear;
  std::vector<std::string> gaps;
};

/// The conflicts of these ranges, numbered by their positions, except for those that were split.
[[nodiscard]] ValueConflicts conflicts_of(const owl::Ontology& source,
                                          std::span<const clauses::DatatypeDefinition> definitions,
                                          std::span<const clauses::DataRange> ranges,
                                          std::span<const RangeParts> apart);

}  // namespace geminga::consequence

#endif
