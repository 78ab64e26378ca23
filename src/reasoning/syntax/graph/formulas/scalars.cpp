#include "reasoning/syntax/graph/formulas/scalars.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <string>
#include <tuple>

#include "base/text.hpp"
#include "reasoning/owl/datatypes.hpp"
#include "reasoning/syntax/graph/formulas/times.hpp"

namespace geminga::graph {
namespace {

using Integer = boost::multiprecision::cpp_int;
using Rational = boost::multiprecision::cpp_rational;

/// The most digits of an exact number, and those behind the point of a quotient.
constexpr std::size_t most_digits = 1000;
constexpr unsigned fraction_digits = 18;

Integer power_of_ten(std::size_t exponent) { return Integer('1' + std::string(exponent, '0')); }

/// The local name of a datatype of XML Schema; empty for another one.
std::string_view xsd_name(const Node& node) {
  const std::string_view type = node.datatype;
  return node.kind == Node::Kind::literal && type.starts_with(owl::xsd_namespace)
             ? type.substr(owl::xsd_namespace.size())
             : std::string_view();
}

Node typed(std::string value, std::string_view type) {
  return {Node::Kind::literal, std::move(value), std::string(owl::xsd_namespace).append(type), {}};
}

constexpr std::array<std::string_view, 12> whole_types{
    "nonPositiveInteger", "negativeInteger", "long",        "int",           "short",        "byte",
    "nonNegativeInteger", "unsignedLong",    "unsignedInt", "unsignedShort", "unsignedByte", "positiveInteger"};

std::optional<Numeric::Type> numeric_type(std::string_view name) {
  if (name == "integer") return Numeric::Type::integer;
  if (name == "decimal") return Numeric::Type::decimal;
  if (name == "float") return Numeric::Type::single;
  if (name == "double") return Numeric::Type::double_;
  for (const std::string_view whole : whole_types) {
    if (name == whole) return Numeric::Type::integer;
  }
  return std::nullopt;
}

std::string_view trimmed(std::string_view value) {
  const std::size_t begin = value.find_first_not_of(" \t\r\n");
  if (begin == std::string_view::npos) return {};
  return value.substr(begin, value.find_last_not_of(" \t\r\n") - begin + 1);
}

std::optional<Rational> read_exact(std::string_view value, bool is_whole) {
  const bool is_negative = value.starts_with('-');
  if (is_negative || value.starts_with('+')) value.remove_prefix(1);
  std::string digits;
  std::size_t behind = 0;
  bool has_point = false;
  for (const char c : value) {
    if (c == '.' && !has_point && !is_whole) {
      has_point = true;
    } else if (c >= '0' && c <= '9') {
      digits += c;
      behind += has_point ? 1U : 0U;
    } else {
      return std::nullopt;
    }
  }
  if (digits.empty() || digits.size() > most_digits) return std::nullopt;
  // Most numbers are short and whole. A leading zero would mean octal to the longer ones.
  constexpr std::size_t short_digits = 18;
  const std::size_t first = std::min(digits.find_first_not_of('0'), digits.size() - 1);
  const Integer whole = digits.size() <= short_digits ? Integer(base::parse_number<std::int64_t>(digits).value_or(0))
                                                      : Integer(digits.substr(first));
  const Rational number = behind == 0 ? Rational(whole) : Rational(whole, power_of_ten(behind));
  return is_negative ? Rational(-number) : number;
}

std::optional<double> read_double(std::string_view value) {
  if (value == "INF" || value == "+INF") return std::numeric_limits<double>::infinity();
  if (value == "-INF") return -std::numeric_limits<double>::infinity();
  if (value == "NaN") return std::numeric_limits<double>::quiet_NaN();
  if (value.starts_with('+')) value.remove_prefix(1);
  if (value.find_first_not_of("0123456789.eE+-") != std::string_view::npos) return std::nullopt;
  double number = 0;
  const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), number);
  if (end != value.data() + value.size()) return std::nullopt;
  if (error == std::errc::result_out_of_range) return std::nullopt;
  return error == std::errc() ? std::optional(number) : std::nullopt;
}

bool is_exact(Numeric::Type type) { return type <= Numeric::Type::decimal; }

std::string exact_text(const Rational& number) {
  using boost::multiprecision::denominator;
  using boost::multiprecision::numerator;
  const Integer scale = power_of_ten(fraction_digits);
  const bool is_negative = number < 0;
  const Integer above = is_negative ? Integer(-numerator(number)) : numerator(number);
  Integer scaled = above * scale / denominator(number);
  std::string text = Integer(scaled / scale).str();
  std::string behind = Integer(scaled % scale).str();
  behind.insert(0, fraction_digits - behind.size(), '0');
  behind.erase(behind.find_last_not_of('0') + 1);
  if (!behind.empty()) text.append(1, '.').append(behind);
  return is_negative && scaled != 0 ? '-' + text : text;
}

std::string double_text(double number, bool is_single) {
  if (std::isnan(number)) return "NaN";
  if (std::isinf(number)) return number < 0 ? "-INF" : "INF";
  std::array<char, 64> room{};
  const auto result =
      is_single ? std::to_chars(room.begin(), room.end(), static_cast<float>(number), std::chars_format::scientific)
                : std::to_chars(room.begin(), room.end(), number, std::chars_format::scientific);
  std::string written(room.begin(), result.ptr);
  const std::size_t e = written.find('e');
  std::string mantissa = written.substr(0, e);
  if (mantissa.find('.') == std::string::npos) mantissa += ".0";
  const int exponent = base::parse_number<int>(written.substr(written[e + 1] == '+' ? e + 2 : e + 1)).value_or(0);
  return mantissa + 'E' + std::to_string(exponent);
}

bool is_too_long(const Rational& number) {
  static const Integer bound = power_of_ten(most_digits);
  const Integer& numerator = boost::multiprecision::numerator(number);
  return numerator > bound || numerator < -bound || boost::multiprecision::denominator(number) > bound;
}

double calculate_double(char operation, double a, double b) {
  switch (operation) {
    case '+':
      return a + b;
    case '-':
      return a - b;
    case '*':
      return a * b;
    default:
      return a / b;
  }
}

std::optional<bool> boolean_of(const Node& node) {
  if (xsd_name(node) != "boolean") return std::nullopt;
  const std::string_view value = trimmed(node.text);
  if (value == "true" || value == "1") return true;
  if (value == "false" || value == "0") return false;
  return std::nullopt;
}

/// Kinds of values that are compared with one another; the last is any other datatype.
enum class Kind : std::uint8_t { number, text, with_language, boolean, time, unknown };

Kind kind_of(const Node& node) {
  if (!node.language.empty()) return Kind::with_language;
  if (is_text(node)) return Kind::text;
  if (number_of(node)) return Kind::number;
  if (boolean_of(node)) return Kind::boolean;
  if (instant_of(node)) return Kind::time;
  return Kind::unknown;
}

}  // namespace

std::optional<Numeric> number_of(const Node& node) {
  const auto type = numeric_type(xsd_name(node));
  if (!type) return std::nullopt;
  const std::string_view value = trimmed(node.text);
  if (is_exact(*type)) {
    auto exact = read_exact(value, *type == Numeric::Type::integer);
    if (!exact) return std::nullopt;
    return Numeric{*type, std::move(*exact), 0};
  }
  const auto approximate = read_double(value);
  if (!approximate) return std::nullopt;
  return as_type({Numeric::Type::double_, 0, *approximate}, *type);
}

Numeric as_type(const Numeric& number, Numeric::Type type) {
  if (is_exact(type)) return {type, number.exact, 0};
  double value = is_exact(number.type) ? number.exact.convert_to<double>() : number.approximate;
  if (type == Numeric::Type::single) value = static_cast<double>(static_cast<float>(value));
  return {type, 0, value};
}

Node node_of(const Numeric& number) {
  switch (number.type) {
    case Numeric::Type::integer:
      return typed(exact_text(number.exact), "integer");
    case Numeric::Type::decimal:
      return typed(exact_text(number.exact), "decimal");
    case Numeric::Type::single:
      return typed(double_text(number.approximate, true), "float");
    case Numeric::Type::double_:
      break;
  }
  return typed(double_text(number.approximate, false), "double");
}

std::optional<Numeric> calculate(char operation, const Numeric& a, const Numeric& b) {
  Numeric::Type type = std::max(a.type, b.type);
  if (!is_exact(type)) {
    const double result = calculate_double(operation, as_type(a, type).approximate, as_type(b, type).approximate);
    return as_type({Numeric::Type::double_, 0, result}, type);
  }
  Rational result;
  if (operation == '+') result = a.exact + b.exact;
  if (operation == '-') result = a.exact - b.exact;
  if (operation == '*') result = a.exact * b.exact;
  if (operation == '/') {
    if (b.exact == 0) return std::nullopt;
    result = a.exact / b.exact;
    type = Numeric::Type::decimal;
  }
  if (is_too_long(result)) return std::nullopt;
  return Numeric{type, std::move(result), 0};
}

std::partial_ordering compare(const Numeric& a, const Numeric& b) {
  const Numeric::Type type = std::max(a.type, b.type);
  if (!is_exact(type)) return as_type(a, type).approximate <=> as_type(b, type).approximate;
  if (a.exact == b.exact) return std::partial_ordering::equivalent;
  return a.exact < b.exact ? std::partial_ordering::less : std::partial_ordering::greater;
}

Node boolean(bool value) { return typed(value ? "true" : "false", "boolean"); }
Node integer(std::int64_t value) { return typed(std::to_string(value), "integer"); }
Node text(std::string value) { return {Node::Kind::literal, std::move(value), {}, {}}; }

bool is_text(const Node& node) {
  return node.kind == Node::Kind::literal && node.language.empty() &&
         (node.datatype.empty() || xsd_name(node) == "string");
}

std::optional<bool> truth_of(const Node& node) {
  if (xsd_name(node) == "boolean") return boolean_of(node).value_or(false);
  if (is_text(node)) return !node.text.empty();
  if (numeric_type(xsd_name(node))) {
    const auto number = number_of(node);
    if (!number) return false;
    return is_exact(number->type) ? number->exact != 0 : number->approximate != 0 && !std::isnan(number->approximate);
  }
  return std::nullopt;
}

std::optional<bool> are_equal(const Node& a, const Node& b) {
  if (const auto order = order_of(a, b)) return *order == std::partial_ordering::equivalent;
  if (a == b) return true;
  if (a.kind != Node::Kind::literal || b.kind != Node::Kind::literal) return false;
  const Kind kind = kind_of(a);
  const Kind other = kind_of(b);
  if (kind == Kind::unknown || other == Kind::unknown || (kind == other && kind == Kind::time)) return std::nullopt;
  return false;
}

std::optional<std::partial_ordering> order_of(const Node& a, const Node& b) {
  if (a.kind != Node::Kind::literal || b.kind != Node::Kind::literal) return std::nullopt;
  if (is_text(a) && is_text(b)) return a.text <=> b.text;
  if (const auto number = number_of(a)) {
    const auto other = number_of(b);
    if (!other) return std::nullopt;
    return compare(*number, *other);
  }
  if (const auto value = boolean_of(a)) {
    const auto other = boolean_of(b);
    if (!other) return std::nullopt;
    return *value <=> *other;
  }
  const auto time = instant_of(a);
  const auto other = instant_of(b);
  if (!time || !other) return std::nullopt;
  return compare(*time, *other);
}

std::strong_ordering sorted_before(const Scalar& a, const Scalar& b) {
  if (!a || !b) return a.has_value() <=> b.has_value();
  const auto rank = [](const Node& node) {
    if (node.kind == Node::Kind::blank) return 0;
    if (node.kind == Node::Kind::iri) return 1;
    const Kind kind = kind_of(node);  // texts of all languages are one
    return 2 + static_cast<int>(kind == Kind::with_language ? Kind::text : kind);
  };
  if (const auto order = rank(*a) <=> rank(*b); order != std::strong_ordering::equal) return order;
  if (a->kind == Node::Kind::literal) {
    if (const auto order = order_of(*a, *b)) {
      if (*order == std::partial_ordering::less) return std::strong_ordering::less;
      if (*order == std::partial_ordering::greater) return std::strong_ordering::greater;
      if (*order == std::partial_ordering::unordered) {  // NaN comes first
        const bool is_nan = a->text == "NaN";
        if (is_nan != (b->text == "NaN")) return is_nan ? std::strong_ordering::less : std::strong_ordering::greater;
      }
    }
  }
  return std::tie(a->text, a->language, a->datatype) <=> std::tie(b->text, b->language, b->datatype);
}

}  // namespace geminga::graph
