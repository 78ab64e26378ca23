// Which values a built-in compares, and what it makes of them.
#include "reasoning/dl/hypertableau/rules/built_ins.hpp"

#include <algorithm>
#include <compare>
#include <vector>

#include "reasoning/dl/hypertableau/rules/arithmetic.hpp"
#include "reasoning/dl/hypertableau/rules/texts.hpp"

namespace geminga::hypertableau {
namespace {

using clauses::BuiltIn;
using owl::DataFamily;

/// Fourteen hours, the most that a time without a zone may differ from the same time in one (XML Schema 1.1, part 2,
/// D.2.1).
constexpr int zone_seconds = 14 * 3600;

std::partial_ordering ordering_of(const Number& a, const Number& b) {
  if (a == b) return std::partial_ordering::equivalent;
  return a < b ? std::partial_ordering::less : std::partial_ordering::greater;
}

std::partial_ordering compare_times(const Value& a, const Value& b) {
  if (a.layer == b.layer) return ordering_of(a.position, b.position);
  // The one without a zone lies somewhere in an interval.
  const Number low = b.position - a.position - zone_seconds;
  const Number high = b.position - a.position + zone_seconds;
  if (low > 0) return std::partial_ordering::less;
  if (high < 0) return std::partial_ordering::greater;
  return std::partial_ordering::unordered;
}

/// Values of different types are neither equal nor ordered.
std::partial_ordering compare(const Value& a, const Value& b) {
  if (is_number(a) && is_number(b)) return compare_numbers(a, b);
  if (a.family != b.family) return std::partial_ordering::unordered;
  switch (a.family) {
    case DataFamily::text: {
      if (a.layer == language_layer || b.layer == language_layer)
        return a == b ? std::partial_ordering::equivalent : std::partial_ordering::unordered;
      // UTF-8 keeps the order of characters.
      return text_of(a).compare(text_of(b)) <=> 0;
    }
    case DataFamily::boolean:
      return ordering_of(a.position, b.position);
    case DataFamily::time:
      return compare_times(a, b);
    default:
      return a == b ? std::partial_ordering::equivalent : std::partial_ordering::unordered;
  }
}

bool holds(BuiltIn built_in, std::partial_ordering order) {
  switch (built_in) {
    case BuiltIn::equal:
      return order == std::partial_ordering::equivalent;
    case BuiltIn::not_equal:
      return order != std::partial_ordering::equivalent;
    case BuiltIn::less_than:
      return order == std::partial_ordering::less;
    case BuiltIn::less_than_or_equal:
      return order == std::partial_ordering::less || order == std::partial_ordering::equivalent;
    case BuiltIn::greater_than:
      return order == std::partial_ordering::greater;
    default:
      return order == std::partial_ordering::greater || order == std::partial_ordering::equivalent;
  }
}

Computed computed(BuiltIn built_in, std::span<const Value> operands) {
  if (built_in == BuiltIn::boolean_not) {
    if (operands[0].family != DataFamily::boolean) return {};
    return {Holds::yes, Value{DataFamily::boolean, 0, 1 - operands[0].position, {}}};
  }
  if (built_in < BuiltIn::boolean_not) return compute(built_in, operands);
  return make_text(built_in, operands);
}

}  // namespace

Holds evaluate(BuiltIn built_in, std::span<std::optional<Value>> arguments) {
  if (built_in == BuiltIn::equal) {
    if (!arguments[0]) arguments[0] = arguments[1];
    if (!arguments[1]) arguments[1] = arguments[0];
  }
  const bool binds_first = clauses::form_of(built_in).binds_first && built_in != BuiltIn::equal;
  const std::span<std::optional<Value>> known = arguments.subspan(binds_first ? 1 : 0);
  std::vector<Value> operands;
  for (const std::optional<Value>& one : known) {
    if (!one) return Holds::unknown;
    operands.push_back(*one);
  }
  if (built_in <= BuiltIn::greater_than_or_equal)
    return holds(built_in, compare(operands[0], operands[1])) ? Holds::yes : Holds::no;
  if (!binds_first) return compare_texts(built_in, operands[0], operands[1]);
  Computed result = computed(built_in, operands);
  if (result.holds != Holds::yes) return result.holds;
  if (!arguments[0]) {
    arguments[0] = std::move(result.value);
    return Holds::yes;
  }
  return compare(*arguments[0], *result.value) == std::partial_ordering::equivalent ? Holds::yes : Holds::no;
}

}  // namespace geminga::hypertableau
