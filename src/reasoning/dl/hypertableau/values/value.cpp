// From canonical forms to positions.
#include "reasoning/dl/hypertableau/values/value.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>

#include "base/utf8.hpp"
#include "reasoning/owl/literal_value.hpp"

namespace geminga::hypertableau {
namespace {

using owl::DataFamily;

Number read_decimal(std::string_view text) {
  const bool is_negative = text.starts_with('-');
  if (is_negative) text.remove_prefix(1);
  boost::multiprecision::cpp_int digits = 0;
  boost::multiprecision::cpp_int scale = 1;
  bool is_fraction = false;
  for (const char character : text) {
    if (character == '.') {
      is_fraction = true;
      continue;
    }
    digits = digits * 10 + (character - '0');
    if (is_fraction) scale *= 10;
  }
  const Number number(digits, scale);
  return is_negative ? Number(-number) : number;
}

/// Whether a rational has a finite decimal form: its denominator has no prime factors but 2 and 5.
bool is_decimal(const Number& number) {
  boost::multiprecision::cpp_int denominator = boost::multiprecision::denominator(number);
  while (denominator % 2 == 0) denominator /= 2;
  while (denominator % 5 == 0) denominator /= 5;
  return denominator == 1;
}

std::optional<Value> number_value(std::string_view canonical) {
  if (canonical.size() > max_number_digits) return std::nullopt;
  const std::size_t slash = canonical.find('/');
  Number number = read_decimal(canonical.substr(0, slash));
  if (slash != std::string_view::npos) number /= read_decimal(canonical.substr(slash + 1));
  return value_of_number(number);
}

template <typename Float>
Value float_value(DataFamily family, std::string_view canonical) {
  Value value{family, 0, 0, {}};
  if (canonical == "NaN") {
    value.layer = 1;
    return value;
  }
  Float number = std::numeric_limits<Float>::infinity();
  if (canonical == "-INF") {
    number = -number;
  } else if (canonical != "INF") {
    const bool is_negative = canonical.starts_with('-');
    if (is_negative) canonical.remove_prefix(1);
    std::from_chars(canonical.data(), canonical.data() + canonical.size(), number, std::chars_format::hex);
    if (is_negative) number = -number;
  }
  value.position = rank_of(number);
  return value;
}

/// Days from 1970-01-01 in the proleptic Gregorian calendar.
boost::multiprecision::cpp_int days_of(boost::multiprecision::cpp_int year, int month, int day) {
  if (month <= 2) --year;
  boost::multiprecision::cpp_int era = year / 400;
  if (year < 0 && era * 400 != year) --era;
  const boost::multiprecision::cpp_int of_era = year - era * 400;
  const int of_year = (153 * (month + (month > 2 ? -3 : 9)) + 2) / 5 + day - 1;
  return era * 146097 + of_era * 365 + of_era / 4 - of_era / 100 + of_year - 719468;
}

int two_digits(std::string_view text) { return (text[0] - '0') * 10 + (text[1] - '0'); }

/// [-]YYYY-MM-DDThh:mm:ss[.fff][Z|+hh:mm]
std::optional<Value> time_value(std::string_view canonical) {
  if (canonical.size() > max_number_digits) return std::nullopt;
  const std::size_t dash = canonical.find('-', 1);
  const std::string_view rest = canonical.substr(dash + 1);
  Number seconds(days_of(boost::multiprecision::numerator(read_decimal(canonical.substr(0, dash))), two_digits(rest),
                         two_digits(rest.substr(3))));
  seconds = seconds * 86400 + two_digits(rest.substr(6)) * 3600 + two_digits(rest.substr(9)) * 60;
  std::string_view second = rest.substr(12);
  const std::size_t zone = second.find_first_of("Z+-");
  seconds += read_decimal(second.substr(0, zone));
  if (zone == std::string_view::npos) return Value{DataFamily::time, 1, seconds, {}};
  second.remove_prefix(zone);
  int offset = 0;
  if (second != "Z") offset = (two_digits(second.substr(1)) * 60 + two_digits(second.substr(4))) * 60;
  if (second.starts_with('-')) offset = -offset;
  // The zone is part of the value: the same instant in another is equal in order only.
  return Value{DataFamily::time, 0, seconds - offset, std::to_string(offset)};
}

Value text_value(std::string canonical) {
  if (canonical.starts_with('l')) {
    const std::size_t length = base::count_characters(std::string_view(canonical).substr(canonical.find('\0') + 1));
    return {DataFamily::text, language_layer, length, std::move(canonical)};
  }
  static constexpr std::array<std::string_view, 6> chain = {"normalizedString", "token",   "NMTOKEN", "Name",
                                                            "NCName",           "language"};
  const owl::DataValue value{DataFamily::text, canonical, true};
  std::uint8_t layer = 0;
  while (layer < chain.size()) {
    const auto type = owl::Datatype::find("http://www.w3.org/2001/XMLSchema#" + std::string(chain[layer]));
    if (!type || !value.is_in(*type)) break;
    ++layer;
  }
  const std::size_t length = base::count_characters(canonical) - 1;
  return {DataFamily::text, layer, length, std::move(canonical)};
}

}  // namespace

Number rank_of(double value) {
  const auto bits = std::bit_cast<std::int64_t>(value);
  return bits >= 0 ? Number(bits) : Number(std::numeric_limits<std::int64_t>::min()) - Number(bits) - 1;
}

Number rank_of(float value) {
  const auto bits = std::bit_cast<std::int32_t>(value);
  return bits >= 0 ? Number(bits) : Number(std::numeric_limits<std::int32_t>::min()) - Number(bits) - 1;
}

std::uint8_t layer_count(DataFamily family) {
  switch (family) {
    case DataFamily::number:
      return number_layers;
    case DataFamily::text:
      return text_layers;
    case DataFamily::double_:
    case DataFamily::float_:
    case DataFamily::time:
      return 2;
    default:
      return 1;
  }
}

std::optional<Value> value_of(const owl::Ontology& source, owl::TermId literal) {
  auto read = owl::value_of(source, source.term(literal));
  if (!read) return std::nullopt;
  return value_of(std::move(*read));
}

Value value_of_number(const Number& number) {
  Value value{DataFamily::number, 0, number, {}};
  if (boost::multiprecision::denominator(number) != 1) value.layer = is_decimal(number) ? 1 : 2;
  return value;
}

std::optional<Value> value_of(owl::DataValue read) {
  std::string& canonical = read.canonical;
  switch (read.family) {
    case DataFamily::number:
      return number_value(canonical);
    case DataFamily::text:
      return text_value(std::move(canonical));
    case DataFamily::double_:
      return float_value<double>(read.family, canonical);
    case DataFamily::float_:
      return float_value<float>(read.family, canonical);
    case DataFamily::boolean:
      return Value{read.family, 0, canonical == "true" ? 1 : 0, {}};
    case DataFamily::hex:
      return Value{read.family, 0, canonical.size() / 2, std::move(canonical)};
    case DataFamily::base64: {
      std::erase(canonical, '=');
      return Value{read.family, 0, canonical.size() * 3 / 4, std::move(canonical)};
    }
    case DataFamily::uri:
      return Value{read.family, 0, base::count_characters(canonical), std::move(canonical)};
    case DataFamily::time:
      return time_value(canonical);
    case DataFamily::xml:
      // The lexical forms are canonical XML (RDF Concepts 2004, section 5.1), and then different ones are different
      // values. A value that does not look canonical is unknown.
      for (const std::string_view other : {"/>", "<!", "'", "\r"}) {
        if (canonical.find(other) != std::string::npos) return std::nullopt;
      }
      return Value{read.family, 0, canonical.size(), std::move(canonical)};
  }
  return std::nullopt;
}

}  // namespace geminga::hypertableau
