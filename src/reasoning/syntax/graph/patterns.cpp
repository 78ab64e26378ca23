#include "reasoning/syntax/graph/patterns.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

#include "reasoning/syntax/graph/existence.hpp"

namespace geminga::graph {
namespace {

rasqal_graph_pattern_operator kind_of(rasqal_graph_pattern* pattern) {
  return rasqal_graph_pattern_get_operator(pattern);
}

/// Both rows in one. Nothing where they do not agree.
std::optional<Row> merged(const Row& first, const Row& second) {
  Row both = first;
  for (std::size_t at = 0; at < second.size(); ++at) {
    if (second[at] == unbound) continue;
    const TermNumber value = value_in(both, at);
    if (value != unbound && value != second[at]) return std::nullopt;
    set_in(both, at, second[at]);
  }
  return both;
}

bool share_a_variable(const Row& first, const Row& second) {
  for (std::size_t at = 0; at < std::min(first.size(), second.size()); ++at) {
    if (first[at] != unbound && second[at] != unbound) return true;
  }
  return false;
}

/// The variables that each row binds.
std::set<std::size_t> bound_in_all(const Rows& rows) {
  std::set<std::size_t> bound;
  for (std::size_t at = 0; !rows.empty() && at < rows.front().size(); ++at) {
    if (std::ranges::all_of(rows, [&](const Row& row) { return value_in(row, at) != unbound; })) bound.insert(at);
  }
  return bound;
}

/// Rows that are found for a seed. They stay for rows with the same seed, which mostly follow each other.
class RowsOfSeed {
 public:
  template <typename Find>
  const Rows& get(Row seed, Find&& find) {
    if (!seed_ || *seed_ != seed) {
      rows_ = find(seed);
      seed_ = std::move(seed);
    }
    return rows_;
  }

 private:
  std::optional<Row> seed_;
  Rows rows_;
};

Row key_of(const Row& row, const std::vector<std::size_t>& variables) {
  Row key;
  for (const std::size_t variable : variables) key.push_back(value_in(row, variable));
  return key;
}

}  // namespace

Patterns::Patterns(const ReadQuery& read, Terms& terms, Variables& variables, Formulas& formulas, TripleIndex& index,
                   const Expressions& expressions, FindInner find_inner)
    : read_(read),
      terms_(terms),
      variables_(variables),
      formulas_(formulas),
      index_(index),
      matcher_(terms, variables, index, expressions),
      find_inner_(std::move(find_inner)) {}

Rows Patterns::rows(std::size_t most) {
  rasqal_graph_pattern* pattern = read_.pattern();
  if (pattern == nullptr) return {Row{}};
  if (kind_of(pattern) == RASQAL_GRAPH_PATTERN_OPERATOR_BASIC) most_ = most;
  return evaluate_one(pattern, {});
}

Rows Patterns::joined(const Rows& first, const Rows& second) {
  const auto in_first = bound_in_all(first);
  std::vector<std::size_t> shared;
  std::ranges::set_intersection(in_first, bound_in_all(second), std::back_inserter(shared));
  std::map<Row, std::vector<const Row*>> by_key;
  for (const Row& row : second) by_key[key_of(row, shared)].push_back(&row);
  Rows both;
  for (const Row& row : first) {
    const auto partners = by_key.find(key_of(row, shared));
    if (partners == by_key.end()) continue;
    for (const Row* partner : partners->second) {
      if (!index_.step()) return both;
      if (auto together = merged(row, *partner)) both.push_back(std::move(*together));
    }
  }
  return both;
}

Rows Patterns::rows_of(const GivenValues& values) {
  Rows rows;
  for (const Row& given : values.rows) {
    Row& row = rows.emplace_back();
    for (std::size_t at = 0; at < given.size(); ++at)
      set_in(row, variables_.number_of(values.variables[at]), given[at]);
  }
  return rows;
}

Patterns::Parts Patterns::group_of(rasqal_graph_pattern* pattern) {
  if (kind_of(pattern) == RASQAL_GRAPH_PATTERN_OPERATOR_GROUP) return parts_of(pattern);
  return {pattern};
}

Patterns::Parts Patterns::group_below(rasqal_graph_pattern* pattern) {
  Parts parts = parts_of(pattern);
  return parts.size() == 1 ? group_of(parts.front()) : parts;
}

Rows Patterns::evaluate_one(rasqal_graph_pattern* pattern, const Row& seed) {
  return evaluate(group_of(pattern), seed);
}

Rows Patterns::evaluate(const Parts& group, const Row& seed) {
  Rows rows = unfiltered(group, seed);
  keep_those_that_hold(group, rows);
  return rows;
}

Rows Patterns::unfiltered(const Parts& group, const Row& seed) {
  Rows rows{seed};
  for (rasqal_graph_pattern* part : group) {
    take(part, rows);
    if (rows.empty()) break;
  }
  return rows;
}

void Patterns::take(rasqal_graph_pattern* part, Rows& rows) {
  switch (kind_of(part)) {
    case RASQAL_GRAPH_PATTERN_OPERATOR_BASIC: {
      Rows found;
      for (Row& row : rows) matcher_.match(TripleMatcher::triples_of(part), std::move(row), most_, found);
      rows = std::move(found);
      return;
    }
    case RASQAL_GRAPH_PATTERN_OPERATOR_OPTIONAL:
      if (!existence_of(part)) rows = with_optional(rows, part);
      return;
    case RASQAL_GRAPH_PATTERN_OPERATOR_MINUS:
      rows = without(rows, part);
      return;
    case RASQAL_GRAPH_PATTERN_OPERATOR_LET:
      rows = with_value(std::move(rows), part);
      return;
    case RASQAL_GRAPH_PATTERN_OPERATOR_VALUES:
      rows = joined(rows, rows_of(read_.values(part)));
      return;
    case RASQAL_GRAPH_PATTERN_OPERATOR_SELECT:
      rows = joined(rows, find_inner_(read_.inner(part)));
      return;
    case RASQAL_GRAPH_PATTERN_OPERATOR_GROUP:
    case RASQAL_GRAPH_PATTERN_OPERATOR_UNION:
      rows = with_group(rows, part);
      return;
    case RASQAL_GRAPH_PATTERN_OPERATOR_FILTER:
      return;
    default:  // GRAPH: there is no graph with a name
      rows.clear();
  }
}

void Patterns::keep_those_that_hold(const Parts& group, Rows& rows) {
  for (rasqal_graph_pattern* part : group) {
    if (const auto is_wanted = existence_of(part))
      std::erase_if(rows, [&](const Row& row) { return exists(group_below(part), row) != *is_wanted; });
    if (kind_of(part) != RASQAL_GRAPH_PATTERN_OPERATOR_FILTER) continue;
    const rasqal_expression* filter = rasqal_graph_pattern_get_filter_expression(part);
    std::erase_if(rows, [&](const Row& row) { return !formulas_.holds(*filter, row); });
  }
}

// The values of the row stand for its variables in the group (section 18.6).
bool Patterns::exists(const Parts& group, const Row& row) {
  const bool is_plain = group.size() == 1 && kind_of(group.front()) == RASQAL_GRAPH_PATTERN_OPERATOR_BASIC;
  const std::size_t most = std::exchange(most_, is_plain ? 1 : 0);  // the first is enough
  const bool has_one = !evaluate(group, row).empty();
  most_ = most;
  return has_one;
}

// The filters of an optional group see the variables of the outer one, too (section 18.2.2.6).
Rows Patterns::with_optional(const Rows& rows, rasqal_graph_pattern* optional) {
  const Parts group = group_below(optional);
  const VariableSet variables = certain(group);
  Rows all;
  RowsOfSeed of_seed;
  for (const Row& row : rows) {
    Rows together;
    for (const Row& found :
         of_seed.get(restricted(row, variables), [&](const Row& seed) { return unfiltered(group, seed); })) {
      if (!index_.step()) return all;
      if (auto both = merged(row, found)) together.push_back(std::move(*both));
    }
    keep_those_that_hold(group, together);
    if (together.empty()) together.push_back(row);
    std::ranges::move(together, std::back_inserter(all));
  }
  return all;
}

Rows Patterns::without(const Rows& rows, rasqal_graph_pattern* minus) {
  const Parts group = group_below(minus);
  const VariableSet variables = certain(group);
  Rows kept;
  RowsOfSeed of_seed;
  for (const Row& row : rows) {
    const Rows& others =
        of_seed.get(restricted(row, variables), [&](const Row& seed) { return evaluate(group, seed); });
    const bool goes = std::ranges::any_of(
        others, [&](const Row& other) { return index_.step() && share_a_variable(row, other) && merged(row, other); });
    if (!goes) kept.push_back(row);
  }
  return kept;
}

Rows Patterns::with_group(const Rows& rows, rasqal_graph_pattern* pattern) {
  const Parts branches = kind_of(pattern) == RASQAL_GRAPH_PATTERN_OPERATOR_UNION ? parts_of(pattern) : Parts{pattern};
  Rows all;
  for (rasqal_graph_pattern* branch : branches) {
    const Parts group = group_of(branch);
    const VariableSet variables = certain(group);
    RowsOfSeed of_seed;
    for (const Row& row : rows) {
      for (const Row& found :
           of_seed.get(restricted(row, variables), [&](const Row& seed) { return evaluate(group, seed); })) {
        if (!index_.step()) return all;
        if (auto both = merged(row, found)) all.push_back(std::move(*both));
      }
    }
  }
  return all;
}

Rows Patterns::with_value(Rows rows, rasqal_graph_pattern* let) {
  const std::size_t variable = variables_.number_of(*rasqal_graph_pattern_get_variable(let));
  const rasqal_expression* formula = rasqal_graph_pattern_get_filter_expression(let);
  for (Row& row : rows) {
    if (!index_.step()) return {};
    const TermNumber value = terms_.number_of(formulas_.evaluate(*formula, {row}));
    if (value != unbound) set_in(row, variable, value);
  }
  return rows;
}

Patterns::VariableSet Patterns::certain(const Parts& group) {
  VariableSet variables;
  for (rasqal_graph_pattern* part : group) {
    switch (kind_of(part)) {
      case RASQAL_GRAPH_PATTERN_OPERATOR_BASIC:
        matcher_.add_variables(TripleMatcher::triples_of(part), variables);
        break;
      case RASQAL_GRAPH_PATTERN_OPERATOR_GROUP:
        variables.merge(certain(parts_of(part)));
        break;
      case RASQAL_GRAPH_PATTERN_OPERATOR_FILTER:
      case RASQAL_GRAPH_PATTERN_OPERATOR_VALUES:
      case RASQAL_GRAPH_PATTERN_OPERATOR_SELECT:
        break;
      case RASQAL_GRAPH_PATTERN_OPERATOR_OPTIONAL:
        if (!existence_of(part)) return variables;
        break;
      case RASQAL_GRAPH_PATTERN_OPERATOR_UNION: {
        std::optional<VariableSet> in_all;
        for (rasqal_graph_pattern* branch : parts_of(part)) {
          VariableSet here = certain(group_of(branch));
          if (in_all) std::erase_if(*in_all, [&](std::size_t variable) { return !here.contains(variable); });
          if (!in_all) in_all = std::move(here);
        }
        if (in_all) variables.merge(*in_all);
        break;
      }
      default:
        return variables;
    }
  }
  return variables;
}

Row Patterns::restricted(const Row& row, const VariableSet& to) {
  Row kept;
  for (const std::size_t variable : to) {
    if (const TermNumber value = value_in(row, variable); value != unbound) set_in(kept, variable, value);
  }
  return kept;
}

}  // namespace geminga::graph
