// What is known about data ranges: which cannot hold of one value together.
//
// Ranges occur in heads only, so that all there is to know is which sets of them are empty. Unions, intersections,
// lists of values and their complements are taken apart into datatypes, single values and complements of either. Of
// these the empty sets of one or two are found; what else may be empty is a gap.
#ifndef GEMINGA_REASONING_DL_CONSEQUENCE_VALUES_HPP
#define GEMINGA_REASONING_DL_CONSEQUENCE_VALUES_HPP

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "reasoning/dl/clauses/clause.hpp"
#include "reasoning/owl/source.hpp"

namespace geminga::consequence {

/// A range that is the union, or the intersection, of others.
struct RangeParts {
  std::size_t range = 0;
  bool is_union = false;
  std::vector<std::size_t> parts;
};
/// Takes ranges apart, and appends the parts that are no ranges yet.
[[nodiscard]] std::vector<RangeParts> take_apart(const owl::Ontology& source,
                                                 std::span<const clauses::DatatypeDefinition> definitions,
                                                 std::vector<clauses::DataRange>& ranges);

struct ValueConflicts {
  std::vector<std::size_t> empty;                             ///< ranges that have no value
  std::vector<std::pair<std::size_t, std::size_t>> disjoint;  ///< pairs that have none in common
  /// Of each range that is one literal's value: its number among the values, from 1; 0 for other ranges. Ranges with
  /// different numbers are disjoint, and not listed as such, because there may be very many.
  std::vector<std::uint32_t> value_number;
  bool is_finite = false;  ///< a range has finitely many values, so that counting them may matter
  /// By range: whether it is not understood, or not together with every other.
  std::vector<bool> is_unclear;
  std::vector<std::string> gaps;
};

/// About these ranges, numbered by their positions, but for those that were taken apart.
[[nodiscard]] ValueConflicts conflicts_of(const owl::Ontology& source,
                                          std::span<const clauses::DatatypeDefinition> definitions,
                                          std::span<const clauses::DataRange> ranges,
                                          std::span<const RangeParts> apart);

}  // namespace geminga::consequence

#endif
