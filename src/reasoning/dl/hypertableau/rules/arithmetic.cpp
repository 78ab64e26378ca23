// Exact arithmetic on rationals, and that of IEEE 754.
#include "reasoning/dl/hypertableau/rules/arithmetic.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "reasoning/dl/hypertableau/values/written_value.hpp"

namespace geminga::hypertableau {
namespace {

using clauses::BuiltIn;
using owl::DataFamily;
using Integer = boost::multiprecision::cpp_int;

/// Digits behind the point of a quotient that has no finite decimal form.
constexpr unsigned quotient_digits = 18;
/// 10^n for numbers of max_number_digits digits.
const Integer& largest() {
  static const Integer bound('1' + std::string(max_number_digits, '0'));
  return bound;
}

Integer floor_of(const Number& number) {
  const Integer& numerator = boost::multiprecision::numerator(number);
  const Integer& denominator = boost::multiprecision::denominator(number);
  Integer quotient = numerator / denominator;
  if (numerator < 0 && quotient * denominator != numerator) --quotient;
  return quotient;
}

Integer truncated(const Number& number) { return number < 0 ? Integer(-floor_of(-number)) : floor_of(number); }

Integer half_to_even(const Number& number) {
  const Integer below = floor_of(number);
  const Number rest = number - below;
  const bool is_up = rest > Number(1, 2) || (rest == Number(1, 2) && below % 2 != 0);
  return is_up ? Integer(below + 1) : below;
}

Computed exactly(const Number& number) {
  const Integer& numerator = boost::multiprecision::numerator(number);
  const bool is_large =
      numerator > largest() || numerator < -largest() || boost::multiprecision::denominator(number) > largest();
  if (is_large) return {Holds::unknown, std::nullopt};
  return {Holds::yes, value_of_number(number)};
}

/// A power of ten.
Number ten_to(int exponent) {
  const Integer power('1' + std::string(static_cast<std::size_t>(std::abs(exponent)), '0'));
  return exponent < 0 ? Number(1, power) : Number(power);
}

Computed quotient_of(const Number& a, const Number& b) {
  if (b == 0) return {};
  const Number quotient = a / b;
  Integer denominator = boost::multiprecision::denominator(quotient);
  while (denominator % 2 == 0) denominator /= 2;
  while (denominator % 5 == 0) denominator /= 5;
  if (denominator == 1) return exactly(quotient);
  const Number scale = ten_to(quotient_digits);
  return exactly(Number(half_to_even(quotient * scale)) / scale);
}

Computed power_of(const Number& base, const Number& exponent) {
  if (boost::multiprecision::denominator(exponent) != 1 || exponent > max_exponent || -exponent > max_exponent)
    return {Holds::unknown, std::nullopt};
  if (base == 0 && exponent < 0) return {};
  const Integer& whole = boost::multiprecision::numerator(exponent);
  const auto times = (whole < 0 ? Integer(-whole) : whole).convert_to<unsigned>();
  const auto bits = [](const Integer& number) { return number == 0 ? 0U : msb(number) + 1; };
  const Integer top = boost::multiprecision::abs(boost::multiprecision::numerator(base));
  const Integer bottom = boost::multiprecision::denominator(base);
  if (std::max(bits(top), bits(bottom)) * times > 4 * max_number_digits) return {Holds::unknown, std::nullopt};
  Number result(boost::multiprecision::pow(boost::multiprecision::numerator(base), times),
                boost::multiprecision::pow(bottom, times));
  if (exponent < 0) return quotient_of(1, result);
  return exactly(result);
}

Computed compute_exactly(BuiltIn built_in, std::span<const Value> operands) {
  const auto at = [&](std::size_t place) -> const Number& { return operands[place].position; };
  Number result = at(0);
  switch (built_in) {
    case BuiltIn::add:
      for (const Value& one : operands.subspan(1)) result += one.position;
      return exactly(result);
    case BuiltIn::multiply:
      for (const Value& one : operands.subspan(1)) {
        result *= one.position;
        if (exactly(result).holds == Holds::unknown) return {Holds::unknown, std::nullopt};
      }
      return exactly(result);
    case BuiltIn::subtract:
      return exactly(result - at(1));
    case BuiltIn::divide:
      return quotient_of(at(0), at(1));
    case BuiltIn::integer_divide:
      return at(1) == 0 ? Computed{} : exactly(truncated(at(0) / at(1)));
    case BuiltIn::mod:
      return at(1) == 0 ? Computed{} : exactly(at(0) - at(1) * truncated(at(0) / at(1)));
    case BuiltIn::pow:
      return power_of(at(0), at(1));
    case BuiltIn::unary_plus:
      return exactly(result);
    case BuiltIn::unary_minus:
      return exactly(-result);
    case BuiltIn::abs:
      return exactly(result < 0 ? Number(-result) : result);
    case BuiltIn::floor:
      return exactly(floor_of(result));
    case BuiltIn::ceiling:
      return exactly(-floor_of(-result));
    case BuiltIn::round:
      return exactly(floor_of(result + Number(1, 2)));
    case BuiltIn::round_half_to_even: {
      if (operands.size() == 1) return exactly(half_to_even(result));
      if (boost::multiprecision::denominator(at(1)) != 1) return {};
      if (boost::multiprecision::abs(at(1)) > max_exponent) return {Holds::unknown, std::nullopt};
      const Number scale = ten_to(boost::multiprecision::numerator(at(1)).convert_to<int>());
      return exactly(Number(half_to_even(result * scale)) / scale);
    }
    default:
      return {};
  }
}

template <typename Float>
Value value_of_float(DataFamily family, Float number) {
  Value value{family, 0, 0, {}};
  if (std::isnan(number)) {
    value.layer = 1;
  } else {
    value.position = rank_of(number);
  }
  return value;
}

template <typename Float>
std::optional<Float> compute_float(BuiltIn built_in, std::span<const Value> operands) {
  std::vector<Float> numbers;
  for (const Value& one : operands) numbers.push_back(static_cast<Float>(double_of(one)));
  Float result = numbers[0];
  switch (built_in) {
    case BuiltIn::add:
      for (const Float one : std::span(numbers).subspan(1)) result += one;
      return result;
    case BuiltIn::multiply:
      for (const Float one : std::span(numbers).subspan(1)) result *= one;
      return result;
    case BuiltIn::subtract:
      return result - numbers[1];
    case BuiltIn::divide:
      return result / numbers[1];
    case BuiltIn::integer_divide:
      if (numbers[1] == 0 || !std::isfinite(result) || std::isnan(numbers[1])) return std::nullopt;
      return std::trunc(result / numbers[1]);
    case BuiltIn::mod:
      return std::fmod(result, numbers[1]);
    case BuiltIn::pow:
      return std::pow(result, numbers[1]);
    case BuiltIn::unary_plus:
      return result;
    case BuiltIn::unary_minus:
      return -result;
    case BuiltIn::abs:
      return std::fabs(result);
    case BuiltIn::floor:
      return std::floor(result);
    case BuiltIn::ceiling:
      return std::ceil(result);
    case BuiltIn::round: {  // half up; a sum with a half may itself be rounded, and what is above -0.5 becomes -0
      const Float below = std::floor(result);
      return std::copysign(result - below >= Float{0.5} ? below + 1 : below, result);
    }
    case BuiltIn::round_half_to_even:
      return std::nearbyint(result);
    case BuiltIn::sin:
      return std::sin(result);
    case BuiltIn::cos:
      return std::cos(result);
    case BuiltIn::tan:
      return std::tan(result);
    default:
      return std::nullopt;
  }
}

/// A double or float to so many digits: by way of a decimal (fn:round-half-to-even).
Computed rounded_to_digits(std::span<const Value> operands) {
  const double number = double_of(operands[0]);
  if (operands[1].family != DataFamily::number) return {};
  if (number == 0 || !std::isfinite(number)) return {Holds::yes, operands[0]};
  const Value exact[] = {value_of_number(Number(number)), operands[1]};
  Computed result = compute_exactly(BuiltIn::round_half_to_even, exact);
  if (result.holds != Holds::yes) return result;
  const DataFamily family = operands[0].family;
  const Number& rounded = result.value->position;
  return {Holds::yes, family == DataFamily::float_ ? value_of_float(family, rounded.convert_to<float>())
                                                   : value_of_float(family, rounded.convert_to<double>())};
}

/// The quotient of integerDivide is an integer, whatever its operands are (op:numeric-integer-divide).
template <typename Float>
Computed compute_rounded(DataFamily family, BuiltIn built_in, std::span<const Value> operands) {
  const auto result = compute_float<Float>(built_in, operands);
  if (!result) return {};
  if (built_in != BuiltIn::integer_divide) return {Holds::yes, value_of_float(family, *result)};
  return std::isfinite(*result) ? exactly(Number(*result)) : Computed{};
}

}  // namespace

bool is_number(const Value& value) {
  return value.family == DataFamily::number || value.family == DataFamily::double_ ||
         value.family == DataFamily::float_;
}

double double_of(const Value& value) {
  return value.family == DataFamily::number ? value.position.convert_to<double>() : float_of(value);
}

std::partial_ordering compare_numbers(const Value& a, const Value& b) {
  if (a.family == DataFamily::number && b.family == DataFamily::number) {
    if (a.position == b.position) return std::partial_ordering::equivalent;
    return a.position < b.position ? std::partial_ordering::less : std::partial_ordering::greater;
  }
  if (a.family != DataFamily::double_ && b.family != DataFamily::double_)
    return static_cast<float>(double_of(a)) <=> static_cast<float>(double_of(b));
  return double_of(a) <=> double_of(b);
}

Computed compute(BuiltIn built_in, std::span<const Value> operands) {
  if (operands.empty() || !std::ranges::all_of(operands, is_number)) return {};
  const auto has = [&](DataFamily family) {
    return std::ranges::any_of(operands, [&](const Value& one) { return one.family == family; });
  };
  if (built_in == BuiltIn::round_half_to_even && operands.size() > 1 && operands[0].family != DataFamily::number)
    return rounded_to_digits(operands);
  const bool is_curve = built_in == BuiltIn::sin || built_in == BuiltIn::cos || built_in == BuiltIn::tan;
  if (has(DataFamily::double_) || (is_curve && !has(DataFamily::float_)))
    return compute_rounded<double>(DataFamily::double_, built_in, operands);
  if (has(DataFamily::float_)) return compute_rounded<float>(DataFamily::float_, built_in, operands);
  return compute_exactly(built_in, operands);
}

}  // namespace geminga::hypertableau
