#include "reasoning/syntax/graph/selection.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace geminga::graph {
namespace {

using FormulaList = std::vector<const rasqal_expression*>;

FormulaList formulas_in(raptor_sequence* sequence) {
  FormulaList found;
  for (int at = 0; sequence != nullptr && at < raptor_sequence_size(sequence); ++at)
    found.push_back(static_cast<const rasqal_expression*>(raptor_sequence_get_at(sequence, at)));
  return found;
}

FormulaList group_conditions(const ReadQuery& read) {
  return formulas_in(rasqal_query_get_group_conditions_sequence(read.query()));
}
FormulaList having_conditions(const ReadQuery& read) {
  return formulas_in(rasqal_query_get_having_conditions_sequence(read.query()));
}
FormulaList order_conditions(const ReadQuery& read) {
  return formulas_in(rasqal_query_get_order_conditions_sequence(read.query()));
}

/// The variable that a condition is, or names with AS; null for another formula.
const rasqal_variable* variable_in(const rasqal_expression& formula) {
  switch (formula.op) {
    case RASQAL_EXPR_LITERAL:
      return rasqal_literal_as_variable(formula.literal);
    case RASQAL_EXPR_GROUP_COND_ASC:
    case RASQAL_EXPR_GROUP_COND_DESC:
      return variable_in(*formula.arg1);
    default:
      return nullptr;
  }
}

bool is_grouped(const ReadQuery& read) {
  const auto has_one = [](const FormulaList& list) { return std::ranges::any_of(list, has_aggregate); };
  return !group_conditions(read).empty() || !having_conditions(read).empty() || has_one(order_conditions(read)) ||
         std::ranges::any_of(selected(read), [&](const rasqal_variable* variable) {
           return has_aggregate(read.formula_of(*variable));
         });
}

std::string name_of(const rasqal_variable& variable) { return reinterpret_cast<const char*>(variable.name); }

/// A row with the rows that it stands for; none unless rows are grouped.
struct Result {
  Row row;
  Rows group;
};

class Selecting {
 public:
  Selecting(const ReadQuery& read, Terms& terms, Variables& variables, Formulas& formulas)
      : read_(read), terms_(terms), variables_(variables), formulas_(formulas) {}

  Rows run(Rows rows) {
    const bool has_groups = is_grouped(read_);
    std::vector<Result> results = has_groups ? grouped(std::move(rows)) : apart(std::move(rows));
    for (const rasqal_expression* condition : having_conditions(read_)) {
      std::erase_if(results,
                    [&](const Result& result) { return !formulas_.holds(*condition, result.row, &result.group); });
    }
    compute(results, has_groups);
    sort(results, has_groups);
    return cut(results);
  }

 private:
  static std::vector<Result> apart(Rows rows) {
    std::vector<Result> results;
    results.reserve(rows.size());
    for (Row& row : rows) results.push_back({std::move(row), {}});
    return results;
  }

  /// Groups in the order of their first rows. Without GROUP BY all rows are one, even if there are none.
  std::vector<Result> grouped(Rows rows) {
    const FormulaList conditions = group_conditions(read_);
    std::map<Row, std::size_t> place_of;
    std::vector<Result> results;
    if (conditions.empty()) results.emplace_back().group = std::move(rows);
    for (Row& row : rows) {
      Row key;
      for (const rasqal_expression* condition : conditions) {
        const rasqal_variable* variable = variable_in(*condition);
        const rasqal_expression* formula = variable == nullptr ? nullptr : read_.formula_of(*variable);
        key.push_back(terms_.number_of(formulas_.evaluate(formula == nullptr ? *condition : *formula, {row})));
      }
      const auto [place, is_new] = place_of.try_emplace(key, results.size());
      if (is_new) {
        Result& result = results.emplace_back();
        for (std::size_t at = 0; at < conditions.size(); ++at) {
          if (const rasqal_variable* variable = variable_in(*conditions[at]))
            set_in(result.row, variables_.number_of(*variable), key[at]);
        }
      }
      results[place->second].group.push_back(std::move(row));
    }
    return results;
  }

  /// Computes the variables that are selected with AS, each with those before.
  void compute(std::vector<Result>& results, bool has_groups) {
    for (const rasqal_variable* variable : selected(read_)) {
      const rasqal_expression* formula = read_.formula_of(*variable);
      if (formula == nullptr) continue;
      const std::size_t number = variables_.number_of(*variable);
      for (Result& result : results) {
        if (value_in(result.row, number) != unbound) continue;  // named by GROUP BY
        const Case of{result.row, has_groups ? &result.group : nullptr};
        const TermNumber value = terms_.number_of(formulas_.evaluate(*formula, of));
        set_in(result.row, number, value);
      }
    }
  }

  void sort(std::vector<Result>& results, bool has_groups) {
    const FormulaList conditions = order_conditions(read_);
    if (conditions.empty()) return;
    std::vector<std::pair<std::vector<Scalar>, std::size_t>> keys;
    for (std::size_t at = 0; at < results.size(); ++at) {
      auto& key = keys.emplace_back(std::vector<Scalar>(), at).first;
      for (const rasqal_expression* condition : conditions)
        key.push_back(formulas_.evaluate(*condition, {results[at].row, has_groups ? &results[at].group : nullptr}));
    }
    std::ranges::sort(keys, [&](const auto& a, const auto& b) {
      for (std::size_t at = 0; at < conditions.size(); ++at) {
        const auto order = sorted_before(a.first[at], b.first[at]);
        if (order != 0) return conditions[at]->op == RASQAL_EXPR_ORDER_COND_DESC ? order > 0 : order < 0;
      }
      return a.second < b.second;
    });
    std::vector<Result> sorted;
    sorted.reserve(results.size());
    for (const auto& [key, place] : keys) sorted.push_back(std::move(results[place]));
    results = std::move(sorted);
  }

  /// DISTINCT looks at what is selected; OFFSET and LIMIT count what is left.
  Rows cut(std::vector<Result>& results) {
    const bool is_distinct = rasqal_query_get_distinct(read_.query()) == 1;
    const int limit = rasqal_query_get_limit(read_.query());
    const int offset = rasqal_query_get_offset(read_.query());
    std::vector<std::size_t> numbers;
    for (const rasqal_variable* variable : selected(read_)) numbers.push_back(variables_.number_of(*variable));
    std::set<Row> seen;
    Rows kept;
    std::size_t passed = 0;
    for (Result& result : results) {
      if (is_distinct) {
        Row projected;
        for (const std::size_t number : numbers) projected.push_back(value_in(result.row, number));
        if (!seen.insert(std::move(projected)).second) continue;
      }
      if (offset > 0 && passed++ < static_cast<std::size_t>(offset)) continue;
      if (limit >= 0 && kept.size() >= static_cast<std::size_t>(limit)) break;
      kept.push_back(std::move(result.row));
    }
    return kept;
  }

  const ReadQuery& read_;
  Terms& terms_;
  Variables& variables_;
  Formulas& formulas_;
};

}  // namespace

std::optional<std::string> refusal_of_selected(const ReadQuery& read) {
  if (!is_grouped(read)) return std::nullopt;
  if (rasqal_query_get_wildcard(read.query()) != 0) return "SELECT * and groups: name the variables";
  std::set<std::string> named;
  for (const rasqal_expression* condition : group_conditions(read)) {
    if (const rasqal_variable* variable = variable_in(*condition)) named.insert(name_of(*variable));
  }
  for (const rasqal_variable* variable : selected(read)) {
    if (read.formula_of(*variable) == nullptr && !named.contains(name_of(*variable)))
      return '?' + name_of(*variable) + " has a value for each row of a group: write it behind GROUP BY, or (SAMPLE(?" +
             name_of(*variable) + ") AS ?one)";
  }
  return std::nullopt;
}

std::size_t rows_needed(const ReadQuery& read, std::size_t most) {
  rasqal_query* query = read.query();
  if (rasqal_query_get_verb(query) == RASQAL_QUERY_VERB_ASK) return 1;
  if (is_grouped(read) || rasqal_query_get_distinct(query) == 1 || !order_conditions(read).empty() ||
      read.last_values() != nullptr)
    return 0;
  const int limit = rasqal_query_get_limit(query);
  const auto offset = static_cast<std::size_t>(std::max(rasqal_query_get_offset(query), 0));
  if (limit < 0) return most + offset;
  return std::max<std::size_t>(static_cast<std::size_t>(limit) + offset, 1);
}

Rows selected_rows(const ReadQuery& read, Rows rows, Terms& terms, Variables& variables, Formulas& formulas) {
  return Selecting(read, terms, variables, formulas).run(std::move(rows));
}

}  // namespace geminga::graph
