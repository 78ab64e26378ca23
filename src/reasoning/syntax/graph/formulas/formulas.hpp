// The expressions of a query, evaluated for a row or for a group of rows.
//
// rasqal reads them. It does not evaluate them here, because it counts what is not bound, compares values of different
// kinds, drops rows where BIND has an error and reads memory that it has freed (CONCAT of STR of a number).
#ifndef GEMINGA_REASONING_SYNTAX_GRAPH_FORMULAS_FORMULAS_HPP
#define GEMINGA_REASONING_SYNTAX_GRAPH_FORMULAS_FORMULAS_HPP

#include <optional>
#include <string>
#include <unordered_map>

#include "reasoning/syntax/graph/formulas/scalars.hpp"
#include "reasoning/syntax/graph/terms/terms.hpp"

namespace geminga::graph {

/// The most levels of operators and functions within one another.
inline constexpr std::size_t max_formula_levels = 256;

/// Names what of an expression is not computed here, in one line; nothing where all is. `level` is that of the formula.
[[nodiscard]] std::optional<std::string> refusal_of(const rasqal_expression* formula, std::size_t level = 0);
/// Whether there is an aggregate in it.
[[nodiscard]] bool has_aggregate(const rasqal_expression* formula);

/// The row, or the group, that a formula is evaluated for.
struct Case {
  const Row& row;
  /// The rows of the group, for aggregates. Null where there is none.
  const Rows* group = nullptr;
};

/// Evaluates formulas. Borrows everything.
class Formulas {
 public:
  Formulas(Terms& terms, Variables& variables) : terms_(terms), variables_(variables) {}

  /// The value, or nothing: an error (section 17.2), or a variable that is not bound.
  [[nodiscard]] Scalar evaluate(const rasqal_expression& formula, const Case& of);
  /// Whether it is true. An error is not.
  [[nodiscard]] bool holds(const rasqal_expression& formula, const Row& row, const Rows* group = nullptr);

 private:
  [[nodiscard]] Scalar value_of(rasqal_literal& literal, const Row& row);
  [[nodiscard]] std::optional<bool> truth(const rasqal_expression* formula, const Case& of);
  [[nodiscard]] Scalar logic(const rasqal_expression& formula, const Case& of);
  [[nodiscard]] Scalar compare(const rasqal_expression& formula, const Case& of);
  [[nodiscard]] Scalar arithmetic(const rasqal_expression& formula, const Case& of);
  [[nodiscard]] Scalar is_among(const rasqal_expression& formula, const Case& of);
  [[nodiscard]] Scalar aggregate(const rasqal_expression& formula, const Case& of);
  [[nodiscard]] std::vector<Scalar> arguments(const rasqal_expression& formula, const Case& of);

  Terms& terms_;
  Variables& variables_;
  std::unordered_map<const rasqal_literal*, Node> constants_;
};

/// The value of a function that looks at nothing but its arguments; nothing for an error. `formula` says which.
[[nodiscard]] Scalar call(const rasqal_expression& formula, const std::vector<Scalar>& arguments);
/// Whether call() knows it, which requires that.
[[nodiscard]] bool is_function(const rasqal_expression& formula);

}  // namespace geminga::graph

#endif
