// Numbers of built-ins: exact ones, doubles and floats.
#ifndef GEMINGA_REASONING_DL_HYPERTABLEAU_RULES_ARITHMETIC_HPP
#define GEMINGA_REASONING_DL_HYPERTABLEAU_RULES_ARITHMETIC_HPP

#include <compare>
#include <optional>
#include <span>

#include "reasoning/dl/clauses/built_in.hpp"
#include "reasoning/dl/hypertableau/rules/built_ins.hpp"

namespace geminga::hypertableau {

[[nodiscard]] bool is_number(const Value& value);
/// The nearest double of a number.
[[nodiscard]] double double_of(const Value& value);
/// Numbers of different types are compared in the wider one. Nothing with a NaN.
[[nodiscard]] std::partial_ordering compare_numbers(const Value& a, const Value& b);

/// A result, or why there is none: `no`, or `unknown` where it is too large.
struct Computed {
  Holds holds = Holds::no;
  std::optional<Value> value{};
};
/// The value of an arithmetic built-in for these operands. Integers and decimals are worked with exactly; if an operand
/// is a double or float, all are taken as such.
[[nodiscard]] Computed compute(clauses::BuiltIn built_in, std::span<const Value> operands);

}  // namespace geminga::hypertableau

#endif
