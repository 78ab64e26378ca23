#include "reasoning/dl/consequence/rules/value_rules.hpp"

#include <algorithm>
#include <cstddef>

#include "reasoning/dl/consequence/rules/range_conflicts.hpp"

namespace geminga::consequence {

//  D < D1 or ... or Dn   [D is their union]        D < Di   [D is their intersection]
//  D < F           [D has no value]
//  D and E < F     [D and E have none in common]
//  {v} < Bi  or  {v} < Ci,  Bi and Ci < F    for each bit i of v's number: two values differ in one of them
UnsaidOfRanges add_value_rules(const owl::Ontology& source, const clauses::ClauseSet& clauses,
                               const std::map<owl::TermId, std::size_t>& fact_values, const Predicates& predicates,
                               CentredRules& rules) {
  std::vector<clauses::DataRange> ranges(clauses.data_ranges.begin(), clauses.data_ranges.end());
  ranges.resize(ranges.size() + fact_values.size());
  for (const auto& [value, position] : fact_values) ranges[position] = {value, false};
  if (ranges.size() <= 2) return {};
  const std::vector<RangeParts> apart = take_apart(source, clauses.datatype_definitions, ranges);
  std::vector<std::uint32_t> predicate_of_range = predicates.range;
  while (predicate_of_range.size() < ranges.size()) predicate_of_range.push_back(rules.new_predicate());
  const ValueConflicts conflicts = conflicts_of(source, clauses.datatype_definitions, ranges, apart);
  const auto range = [&](std::size_t position) { return unary_atom(predicate_of_range[position]); };
  for (const RangeParts& parts : apart) {
    Atoms heads;
    for (const std::size_t part : parts.parts) heads.push_back(range(part));
    if (parts.is_union) {
      rules.add({range(parts.range)}, heads);
    } else {
      for (const RuleAtom& head : heads) rules.add({range(parts.range)}, {head});
    }
  }
  for (const std::size_t empty : conflicts.empty) rules.add({range(empty)}, {});
  for (const auto& [first, second] : conflicts.disjoint) rules.add({range(first), range(second)}, {});
  const std::uint32_t greatest = conflicts.value_number.empty() ? 0 : std::ranges::max(conflicts.value_number);
  for (std::uint32_t bit = 0; greatest > 1 && (greatest >> bit) != 0; ++bit) {
    const RuleAtom zero = unary_atom(rules.new_predicate());
    const RuleAtom one = unary_atom(rules.new_predicate());
    for (std::size_t i = 0; i < ranges.size(); ++i) {
      if (conflicts.value_number[i] == 0) continue;
      rules.add({range(i)}, {((conflicts.value_number[i] >> bit) & 1) != 0 ? one : zero});
    }
    rules.add({zero, one}, {});
  }
  UnsaidOfRanges unsaid{.is_finite = conflicts.is_finite, .unclear = {}, .gaps = conflicts.gaps};
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    if (conflicts.is_unclear[i]) unsaid.unclear.push_back(predicate_of_range[i]);
  }
  return unsaid;
}

}  // namespace geminga::consequence
