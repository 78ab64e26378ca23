#include "reasoning/dl/hypertableau/values/written_value.hpp"

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <limits>

namespace geminga::hypertableau {
namespace {

using owl::DataFamily;
using Integer = boost::multiprecision::cpp_int;

WrittenValue of_type(std::string lexical, std::string_view name) {
  return {std::move(lexical), std::string(owl::xsd_namespace).append(name), {}};
}

WrittenValue written_number(const Number& number) {
  const Integer above = boost::multiprecision::numerator(number);
  Integer below = boost::multiprecision::denominator(number);
  if (below == 1) return of_type(above.str(), "integer");
  // Decimal digits until the denominator is a power of ten; 2 and 5 are its only prime factors, or there are none.
  unsigned digits = 0;
  for (const unsigned factor : {2U, 5U}) {
    unsigned count = 0;
    for (; below % factor == 0; ++count) below /= factor;
    digits = std::max(digits, count);
  }
  if (below != 1)
    return {above.str() + '/' + boost::multiprecision::denominator(number).str(),
            "http://www.w3.org/2002/07/owl#rational",
            {}};
  const Integer scaled =
      boost::multiprecision::numerator(Number(number * Number(boost::multiprecision::pow(Integer(10), digits))));
  std::string text = Integer(boost::multiprecision::abs(scaled)).str();
  if (text.size() <= digits) text.insert(0, digits + 1 - text.size(), '0');
  text.insert(text.size() - digits, 1, '.');
  return of_type(number < 0 ? '-' + text : text, "decimal");
}

WrittenValue written_float(const Value& value) {
  const bool is_single = value.family == DataFamily::float_;
  const std::string_view name = is_single ? "float" : "double";
  const double number = float_of(value);
  if (std::isnan(number)) return of_type("NaN", name);
  if (std::isinf(number)) return of_type(number < 0 ? "-INF" : "INF", name);
  std::array<char, 64> room{};
  const auto end = is_single ? std::to_chars(room.begin(), room.end(), static_cast<float>(number))
                             : std::to_chars(room.begin(), room.end(), number);
  return of_type(std::string(room.begin(), end.ptr), name);
}

/// The canonical form of a text begins with a mark; that of one with a language is the mark, the language, and the text
/// behind a zero (owl::DataValue).
WrittenValue written_text(const Value& value) {
  const std::string_view canonical = value.text;
  if (value.layer != language_layer) return of_type(std::string(canonical.substr(1)), "string");
  const std::size_t end = canonical.find('\0');
  return {std::string(canonical.substr(end + 1)), {}, std::string(canonical.substr(1, end - 1))};
}

}  // namespace

std::optional<WrittenValue> written(const Value& value) {
  switch (value.family) {
    case DataFamily::number:
      return written_number(value.position);
    case DataFamily::text:
      return written_text(value);
    case DataFamily::double_:
    case DataFamily::float_:
      return written_float(value);
    case DataFamily::boolean:
      return of_type(value.position == 1 ? "true" : "false", "boolean");
    default:
      return std::nullopt;
  }
}

double float_of(const Value& value) {
  if (value.layer == 1) return std::numeric_limits<double>::quiet_NaN();
  const auto rank = boost::multiprecision::numerator(value.position).convert_to<std::int64_t>();
  if (value.family == DataFamily::float_) {
    const std::int64_t bits = rank >= 0 ? rank : std::int64_t{std::numeric_limits<std::int32_t>::min()} - rank - 1;
    return std::bit_cast<float>(static_cast<std::int32_t>(bits));
  }
  return std::bit_cast<double>(rank >= 0 ? rank : std::numeric_limits<std::int64_t>::min() - (rank + 1));
}

}  // namespace geminga::hypertableau
