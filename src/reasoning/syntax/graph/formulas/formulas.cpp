#include "reasoning/syntax/graph/formulas/formulas.hpp"

#include <algorithm>
#include <initializer_list>
#include <set>
#include <utility>

namespace geminga::graph {
namespace {

/// The arguments of a formula, whichever way rasqal keeps them.
std::vector<const rasqal_expression*> operands_of(const rasqal_expression& formula) {
  std::vector<const rasqal_expression*> parts;
  for (const rasqal_expression* part : {formula.arg1, formula.arg2, formula.arg3, formula.arg4}) {
    if (part != nullptr) parts.push_back(part);
  }
  for (int at = 0; formula.args != nullptr && at < raptor_sequence_size(formula.args); ++at)
    parts.push_back(static_cast<const rasqal_expression*>(raptor_sequence_get_at(formula.args, at)));
  return parts;
}

bool is_aggregate(rasqal_op op) {
  switch (op) {
    case RASQAL_EXPR_COUNT:
    case RASQAL_EXPR_SUM:
    case RASQAL_EXPR_AVG:
    case RASQAL_EXPR_MIN:
    case RASQAL_EXPR_MAX:
    case RASQAL_EXPR_SAMPLE:
    case RASQAL_EXPR_GROUP_CONCAT:
      return true;
    default:
      return false;
  }
}

/// Whether Formulas evaluates it itself.
bool is_operator(rasqal_op op) {
  switch (op) {
    case RASQAL_EXPR_AND:
    case RASQAL_EXPR_OR:
    case RASQAL_EXPR_BANG:
    case RASQAL_EXPR_EQ:
    case RASQAL_EXPR_NEQ:
    case RASQAL_EXPR_LT:
    case RASQAL_EXPR_GT:
    case RASQAL_EXPR_LE:
    case RASQAL_EXPR_GE:
    case RASQAL_EXPR_UMINUS:
    case RASQAL_EXPR_PLUS:
    case RASQAL_EXPR_MINUS:
    case RASQAL_EXPR_STAR:
    case RASQAL_EXPR_SLASH:
    case RASQAL_EXPR_LITERAL:
    case RASQAL_EXPR_VARSTAR:
    case RASQAL_EXPR_BOUND:
    case RASQAL_EXPR_COALESCE:
    case RASQAL_EXPR_IF:
    case RASQAL_EXPR_IN:
    case RASQAL_EXPR_NOT_IN:
    case RASQAL_EXPR_ORDER_COND_ASC:
    case RASQAL_EXPR_ORDER_COND_DESC:
    case RASQAL_EXPR_GROUP_COND_ASC:
    case RASQAL_EXPR_GROUP_COND_DESC:
      return true;
    default:
      return is_aggregate(op);
  }
}

/// Whether it is a literal as with_opaque_constants() writes it. Its value is that of its first part.
bool is_opaque_constant(const rasqal_expression& formula) {
  const auto parts = operands_of(formula);
  return formula.op == RASQAL_EXPR_COALESCE && parts.size() == 2 && parts[0]->op == RASQAL_EXPR_LITERAL &&
         rasqal_literal_as_variable(parts[0]->literal) == nullptr && parts[1]->op == RASQAL_EXPR_RAND;
}

Scalar as_scalar(std::optional<bool> truth) { return truth ? Scalar(boolean(*truth)) : std::nullopt; }

/// The values that the rows of a group have for an aggregate's argument.
class Collected {
 public:
  explicit Collected(bool is_distinct) : is_distinct_(is_distinct) {}

  void add(const Node& value) {
    if (is_distinct_ && !seen_.insert(std::tuple(value.kind, value.text, value.datatype, value.language)).second)
      return;
    values_.push_back(value);
  }
  void note_error() { has_error_ = true; }

  [[nodiscard]] Scalar count() const { return integer(static_cast<std::int64_t>(values_.size())); }
  [[nodiscard]] Scalar sample() const { return values_.empty() ? Scalar() : values_.front(); }
  [[nodiscard]] Scalar sum() const {
    Numeric total;
    for (const Node& value : values_) {
      const auto number = number_of(value);
      auto next = number ? calculate('+', total, *number) : std::nullopt;
      if (!next) return std::nullopt;
      total = std::move(*next);
    }
    return has_error_ ? Scalar() : node_of(total);
  }
  [[nodiscard]] Scalar average() const {
    Scalar total = sum();
    if (values_.empty() || !total) return total;
    const auto mean = calculate('/', *number_of(*total), *number_of(*count()));
    return mean ? Scalar(node_of(*mean)) : std::nullopt;
  }
  [[nodiscard]] Scalar least(bool is_greatest) const {
    if (values_.empty() || has_error_) return std::nullopt;
    const auto is_before = [](const Node& a, const Node& b) { return sorted_before(a, b) < 0; };
    return is_greatest ? *std::ranges::max_element(values_, is_before) : *std::ranges::min_element(values_, is_before);
  }
  [[nodiscard]] Scalar joined(std::string_view separator) const {
    if (has_error_) return std::nullopt;
    std::string all;
    for (const Node& value : values_) {
      if (value.kind == Node::Kind::blank) return std::nullopt;
      if (&value != &values_.front()) all += separator;
      all += value.text;
    }
    return text(std::move(all));
  }

 private:
  bool is_distinct_;
  bool has_error_ = false;
  std::vector<Node> values_;
  std::set<std::tuple<Node::Kind, std::string, std::string, std::string>> seen_;
};

}  // namespace

std::optional<std::string> refusal_of(const rasqal_expression* formula, std::size_t level) {
  if (formula == nullptr || is_opaque_constant(*formula)) return std::nullopt;
  if (level >= max_formula_levels)
    return "an expression nests deeper than " + std::to_string(max_formula_levels) +
           " levels: write it in parts, with BIND";
  if (!is_operator(formula->op) && !is_function(*formula)) {
    const std::string name =
        formula->op == RASQAL_EXPR_FUNCTION && formula->name != nullptr
            ? '<' + std::string(reinterpret_cast<const char*>(raptor_uri_as_string(formula->name))) + '>'
            : std::string(rasqal_expression_op_label(formula->op));
    return "the function " + name + " is not computed here: leave it out, and work on the rows that are written";
  }
  for (const rasqal_expression* part : operands_of(*formula)) {
    if (auto refusal = refusal_of(part, level + 1)) return refusal;
  }
  return std::nullopt;
}

bool has_aggregate(const rasqal_expression* formula) {
  return formula != nullptr && (is_aggregate(formula->op) || std::ranges::any_of(operands_of(*formula), has_aggregate));
}

Scalar Formulas::value_of(rasqal_literal& literal, const Row& row) {
  if (const rasqal_variable* variable = rasqal_literal_as_variable(&literal)) {
    const TermNumber value = value_in(row, variables_.number_of(*variable));
    return value == unbound ? Scalar() : Scalar(terms_.node(value));
  }
  const auto [place, is_new] = constants_.try_emplace(&literal);
  if (is_new) {
    const OwnedTerm term = term_of(terms_.world(), &literal);
    if (term == nullptr) return std::nullopt;
    place->second = graph::node_of(*term);
  }
  return place->second;
}

std::optional<bool> Formulas::truth(const rasqal_expression* formula, const Case& of) {
  const Scalar value = evaluate(*formula, of);
  return value ? truth_of(*value) : std::nullopt;
}

bool Formulas::holds(const rasqal_expression& formula, const Row& row, const Rows* group) {
  return truth(&formula, {row, group}).value_or(false);
}

std::vector<Scalar> Formulas::arguments(const rasqal_expression& formula, const Case& of) {
  std::vector<Scalar> values;
  for (const rasqal_expression* part : operands_of(formula)) values.push_back(evaluate(*part, of));
  return values;
}

// Section 17.2: an error beside a false of AND, or a true of OR, does not matter.
Scalar Formulas::logic(const rasqal_expression& formula, const Case& of) {
  const auto first = truth(formula.arg1, of);
  if (formula.op == RASQAL_EXPR_BANG) return first ? Scalar(boolean(!*first)) : std::nullopt;
  const bool decides = formula.op == RASQAL_EXPR_OR;
  if (first && *first == decides) return boolean(decides);
  const auto second = truth(formula.arg2, of);
  if (second && *second == decides) return boolean(decides);
  return first && second ? Scalar(boolean(!decides)) : std::nullopt;
}

Scalar Formulas::compare(const rasqal_expression& formula, const Case& of) {
  const Scalar first = evaluate(*formula.arg1, of);
  const Scalar second = evaluate(*formula.arg2, of);
  if (!first || !second) return std::nullopt;
  if (formula.op == RASQAL_EXPR_EQ) return as_scalar(are_equal(*first, *second));
  if (formula.op == RASQAL_EXPR_NEQ) {
    const auto equal = are_equal(*first, *second);
    return equal ? Scalar(boolean(!*equal)) : std::nullopt;
  }
  const auto order = order_of(*first, *second);
  if (!order) return std::nullopt;
  switch (formula.op) {
    case RASQAL_EXPR_LT:
      return boolean(*order < 0);
    case RASQAL_EXPR_GT:
      return boolean(*order > 0);
    case RASQAL_EXPR_LE:
      return boolean(*order <= 0);
    default:
      return boolean(*order >= 0);
  }
}

Scalar Formulas::arithmetic(const rasqal_expression& formula, const Case& of) {
  const Scalar first = evaluate(*formula.arg1, of);
  const auto number = first ? number_of(*first) : std::nullopt;
  if (!number) return std::nullopt;
  if (formula.op == RASQAL_EXPR_UMINUS) {
    Numeric negated = *number;
    negated.exact = -negated.exact;
    negated.approximate = -negated.approximate;
    return node_of(negated);
  }
  const Scalar second = evaluate(*formula.arg2, of);
  const auto other = second ? number_of(*second) : std::nullopt;
  if (!other) return std::nullopt;
  char operation = '/';
  if (formula.op == RASQAL_EXPR_PLUS) operation = '+';
  if (formula.op == RASQAL_EXPR_MINUS) operation = '-';
  if (formula.op == RASQAL_EXPR_STAR) operation = '*';
  const auto result = calculate(operation, *number, *other);
  return result ? Scalar(node_of(*result)) : std::nullopt;
}

Scalar Formulas::is_among(const rasqal_expression& formula, const Case& of) {
  const Scalar wanted = evaluate(*formula.arg1, of);
  if (!wanted) return std::nullopt;
  bool has_error = false;
  for (int at = 0; formula.args != nullptr && at < raptor_sequence_size(formula.args); ++at) {
    const Scalar value = evaluate(*static_cast<const rasqal_expression*>(raptor_sequence_get_at(formula.args, at)), of);
    const auto equal = value ? are_equal(*wanted, *value) : std::nullopt;
    if (equal.value_or(false)) return boolean(formula.op == RASQAL_EXPR_IN);
    has_error = has_error || !equal;
  }
  return has_error ? Scalar() : boolean(formula.op == RASQAL_EXPR_NOT_IN);
}

Scalar Formulas::aggregate(const rasqal_expression& formula, const Case& of) {
  if (of.group == nullptr) return std::nullopt;
  const bool is_distinct = (formula.flags & RASQAL_EXPR_FLAG_DISTINCT) != 0;
  const std::vector<const rasqal_expression*> parts = operands_of(formula);
  if (formula.op == RASQAL_EXPR_COUNT && !parts.empty() && parts.front()->op == RASQAL_EXPR_VARSTAR) {
    if (!is_distinct) return integer(static_cast<std::int64_t>(of.group->size()));
    return integer(static_cast<std::int64_t>(std::set<Row>(of.group->begin(), of.group->end()).size()));
  }
  if (parts.empty()) return std::nullopt;
  Collected collected(is_distinct);
  for (const Row& row : *of.group) {
    const Scalar value = evaluate(*parts.front(), {row, nullptr});
    if (value) {
      collected.add(*value);
    } else {
      collected.note_error();
    }
  }
  switch (formula.op) {
    case RASQAL_EXPR_COUNT:
      return collected.count();
    case RASQAL_EXPR_SUM:
      return collected.sum();
    case RASQAL_EXPR_AVG:
      return collected.average();
    case RASQAL_EXPR_MIN:
    case RASQAL_EXPR_MAX:
      return collected.least(formula.op == RASQAL_EXPR_MAX);
    case RASQAL_EXPR_SAMPLE:
      return collected.sample();
    default: {
      const Scalar separator = formula.literal == nullptr ? Scalar() : value_of(*formula.literal, {});
      return collected.joined(separator ? std::string_view(separator->text) : " ");
    }
  }
}

Scalar Formulas::evaluate(const rasqal_expression& formula, const Case& of) {
  if (is_aggregate(formula.op)) return aggregate(formula, of);
  switch (formula.op) {
    case RASQAL_EXPR_LITERAL:
      return value_of(*formula.literal, of.row);
    case RASQAL_EXPR_AND:
    case RASQAL_EXPR_OR:
    case RASQAL_EXPR_BANG:
      return logic(formula, of);
    case RASQAL_EXPR_EQ:
    case RASQAL_EXPR_NEQ:
    case RASQAL_EXPR_LT:
    case RASQAL_EXPR_GT:
    case RASQAL_EXPR_LE:
    case RASQAL_EXPR_GE:
      return compare(formula, of);
    case RASQAL_EXPR_UMINUS:
    case RASQAL_EXPR_PLUS:
    case RASQAL_EXPR_MINUS:
    case RASQAL_EXPR_STAR:
    case RASQAL_EXPR_SLASH:
      return arithmetic(formula, of);
    case RASQAL_EXPR_BOUND:
      return boolean(evaluate(*formula.arg1, of).has_value());
    case RASQAL_EXPR_IN:
    case RASQAL_EXPR_NOT_IN:
      return is_among(formula, of);
    case RASQAL_EXPR_IF: {
      const auto condition = truth(formula.arg1, of);
      return condition ? evaluate(*condition ? *formula.arg2 : *formula.arg3, of) : std::nullopt;
    }
    case RASQAL_EXPR_COALESCE: {
      for (const rasqal_expression* part : operands_of(formula)) {
        if (Scalar value = evaluate(*part, of)) return value;
      }
      return std::nullopt;
    }
    case RASQAL_EXPR_ORDER_COND_ASC:
    case RASQAL_EXPR_ORDER_COND_DESC:
    case RASQAL_EXPR_GROUP_COND_ASC:
    case RASQAL_EXPR_GROUP_COND_DESC:
      return evaluate(*formula.arg1, of);
    default:
      return call(formula, arguments(formula, of));
  }
}

}  // namespace geminga::graph
