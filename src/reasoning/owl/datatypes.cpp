// The table of datatypes, and the reading of lexical forms.
#include "reasoning/owl/datatypes.hpp"

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <type_traits>

#include "base/text.hpp"
#include "reasoning/owl/time_form.hpp"

namespace geminga::owl {
namespace {

constexpr std::string_view owl = "http://www.w3.org/2002/07/owl#";

/// How much of a family a datatype holds. Of numbers: which digits are allowed, and bounds as decimal integers ("":
/// none). Of texts: the position in the chain of ever smaller types.
enum class ValueSpace : std::uint8_t { whole_family, rational, decimal, integer, text_chain, time_with_zone };

struct Row {
  std::string_view prefix;
  std::string_view name;
  DataFamily family;
  ValueSpace space;
  std::string_view low;
  std::string_view high;
  std::uint8_t chain = 0;
};

using enum DataFamily;
constexpr std::array rows = {
    Row{owl, "real", number, ValueSpace::whole_family, "", ""},
    Row{owl, "rational", number, ValueSpace::rational, "", ""},
    Row{xsd_namespace, "decimal", number, ValueSpace::decimal, "", ""},
    Row{xsd_namespace, "integer", number, ValueSpace::integer, "", ""},
    Row{xsd_namespace, "nonNegativeInteger", number, ValueSpace::integer, "0", ""},
    Row{xsd_namespace, "positiveInteger", number, ValueSpace::integer, "1", ""},
    Row{xsd_namespace, "nonPositiveInteger", number, ValueSpace::integer, "", "0"},
    Row{xsd_namespace, "negativeInteger", number, ValueSpace::integer, "", "-1"},
    Row{xsd_namespace, "long", number, ValueSpace::integer, "-9223372036854775808", "9223372036854775807"},
    Row{xsd_namespace, "int", number, ValueSpace::integer, "-2147483648", "2147483647"},
    Row{xsd_namespace, "short", number, ValueSpace::integer, "-32768", "32767"},
    Row{xsd_namespace, "byte", number, ValueSpace::integer, "-128", "127"},
    Row{xsd_namespace, "unsignedLong", number, ValueSpace::integer, "0", "18446744073709551615"},
    Row{xsd_namespace, "unsignedInt", number, ValueSpace::integer, "0", "4294967295"},
    Row{xsd_namespace, "unsignedShort", number, ValueSpace::integer, "0", "65535"},
    Row{xsd_namespace, "unsignedByte", number, ValueSpace::integer, "0", "255"},
    // The chain of texts: plain literals may have a language, strings have none, and each further type is part of the
    // one before it.
    Row{rdf_namespace, "PlainLiteral", text, ValueSpace::text_chain, "", "", 0},
    Row{xsd_namespace, "string", text, ValueSpace::text_chain, "", "", 1},
    Row{xsd_namespace, "normalizedString", text, ValueSpace::text_chain, "", "", 2},
    Row{xsd_namespace, "token", text, ValueSpace::text_chain, "", "", 3},
    Row{xsd_namespace, "NMTOKEN", text, ValueSpace::text_chain, "", "", 4},
    Row{xsd_namespace, "Name", text, ValueSpace::text_chain, "", "", 5},
    Row{xsd_namespace, "NCName", text, ValueSpace::text_chain, "", "", 6},
    Row{xsd_namespace, "language", text, ValueSpace::text_chain, "", "", 7},
    Row{rdf_namespace, "langString", text, ValueSpace::text_chain, "", "", 255},
    Row{xsd_namespace, "double", double_, ValueSpace::whole_family, "", ""},
    Row{xsd_namespace, "float", float_, ValueSpace::whole_family, "", ""},
    Row{xsd_namespace, "boolean", boolean, ValueSpace::whole_family, "", ""},
    Row{xsd_namespace, "hexBinary", hex, ValueSpace::whole_family, "", ""},
    Row{xsd_namespace, "base64Binary", base64, ValueSpace::whole_family, "", ""},
    Row{xsd_namespace, "anyURI", uri, ValueSpace::whole_family, "", ""},
    Row{xsd_namespace, "dateTime", DataFamily::time, ValueSpace::whole_family, "", ""},
    Row{xsd_namespace, "dateTimeStamp", DataFamily::time, ValueSpace::time_with_zone, "", ""},
    Row{rdf_namespace, "XMLLiteral", xml, ValueSpace::whole_family, "", ""},
};
constexpr std::uint8_t lang_string_chain = 255;

/// Orders integers of any length in canonical form.
bool is_less(std::string_view a, std::string_view b) {
  const bool a_negative = a.starts_with('-');
  const bool b_negative = b.starts_with('-');
  if (a_negative != b_negative) return a_negative;
  if (a.size() != b.size()) return (a.size() < b.size()) != a_negative;
  return a_negative ? b < a : a < b;
}

bool is_at_least(std::string_view number, std::string_view low) { return low.empty() || !is_less(number, low); }
bool is_at_most(std::string_view number, std::string_view high) { return high.empty() || !is_less(high, number); }

/// The text with its white space collapsed as XML Schema says.
std::string collapsed(std::string_view text) {
  std::string result;
  for (const char character : text) {
    const bool is_space = character == ' ' || character == '\t' || character == '\n' || character == '\r';
    if (!is_space) {
      result += character;
    } else if (!result.empty() && result.back() != ' ') {
      result += ' ';
    }
  }
  if (result.ends_with(' ')) result.pop_back();
  return result;
}

bool is_digits(std::string_view text) {
  return !text.empty() && std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; });
}

std::optional<std::string> canonical_decimal(std::string_view text, bool may_have_fraction) {
  const bool is_negative = text.starts_with('-');
  if (is_negative || text.starts_with('+')) text.remove_prefix(1);
  const std::size_t point = text.find('.');
  std::string_view whole = text.substr(0, point);
  std::string_view fraction;
  if (point != std::string_view::npos) {
    if (!may_have_fraction) return std::nullopt;
    fraction = text.substr(point + 1);
    if (whole.empty() && fraction.empty()) return std::nullopt;
    if ((!whole.empty() && !is_digits(whole)) || (!fraction.empty() && !is_digits(fraction))) return std::nullopt;
  } else if (!is_digits(whole)) {
    return std::nullopt;
  }
  while (whole.starts_with('0')) whole.remove_prefix(1);
  while (fraction.ends_with('0')) fraction.remove_suffix(1);
  std::string result(whole.empty() ? "0" : whole);
  if (!fraction.empty()) result += "." + std::string(fraction);
  return is_negative && result != "0" ? "-" + result : result;
}

/// A number that is too large or too small for the type is rounded to infinity or zero (IEEE 754; XSD 1.1 part 2,
/// floatingPointRound). std::from_chars() says only that it does not fit.
template <typename Float>
Float rounded(const std::string& text) {
  if constexpr (std::is_same_v<Float, float>) {
    return std::strtof(text.c_str(), nullptr);
  } else {
    return std::strtod(text.c_str(), nullptr);
  }
}

template <typename Float>
std::optional<std::string> canonical_float(std::string_view text) {
  if (text == "NaN") return "NaN";
  if (text == "INF" || text == "+INF") return "INF";
  if (text == "-INF") return "-INF";
  if (text.starts_with('+')) text.remove_prefix(1);
  Float value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || end != text.data() + text.size() || error == std::errc::invalid_argument) return std::nullopt;
  if (text.find_first_of("0123456789") == std::string_view::npos) return std::nullopt;  // "inf", "nan"
  if (error == std::errc::result_out_of_range) value = rounded<Float>(std::string(text));
  if (std::isinf(value)) return value > 0 ? "INF" : "-INF";
  std::array<char, 64> buffer{};
  const auto written = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::hex);
  return std::string(buffer.data(), written.ptr);
}

/// The last type of the chain that a string without a language is in.
std::uint8_t chain_of(std::string_view text) {
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  const auto is_alphanumeric = [&](char c) { return is_letter(c) || (c >= '0' && c <= '9'); };
  if (text.find_first_of("\t\n\r") != std::string_view::npos) return 1;
  if (collapsed(text) != text) return 2;
  const auto is_name_character = [&](char c) {
    return is_alphanumeric(c) || std::string_view("._-:").find(c) != std::string_view::npos ||
           static_cast<unsigned char>(c) >= 0x80;
  };
  if (text.empty() || !std::ranges::all_of(text, is_name_character)) return 3;
  const char first = text.front();
  if (!is_letter(first) && first != '_' && first != ':' && static_cast<unsigned char>(first) < 0x80) return 4;
  if (text.find(':') != std::string_view::npos) return 5;
  std::size_t length = 0;
  bool is_first_part = true;
  for (std::size_t at = 0; at <= text.size(); ++at) {
    if (at == text.size() || text[at] == '-') {
      if (length == 0 || length > 8) return 6;
      length = 0;
      is_first_part = false;
    } else {
      if (is_first_part ? !is_letter(text[at]) : !is_alphanumeric(text[at])) return 6;
      ++length;
    }
  }
  return 7;
}

std::optional<std::string> canonical_text(const Row& row, std::string_view lexical, std::string_view language) {
  // The canonical form of a text is "s" and the text, or "l", the language, a NUL and the text.
  std::string lower(language);
  if (row.chain == 0 && language.empty()) {
    const std::size_t at = lexical.rfind('@');
    if (at == std::string_view::npos) return std::nullopt;
    lower = lexical.substr(at + 1);
    lexical = lexical.substr(0, at);
  }
  if (row.chain == lang_string_chain && lower.empty()) return std::nullopt;
  for (char& character : lower) {
    if (character >= 'A' && character <= 'Z') character = static_cast<char>(character - 'A' + 'a');
  }
  if (!lower.empty()) return "l" + lower + '\0' + std::string(lexical);
  std::string value(lexical);
  if (row.chain >= 3) value = collapsed(lexical);
  if (row.chain == 2) std::ranges::replace_if(value, [](char c) { return c == '\t' || c == '\n' || c == '\r'; }, ' ');
  if (chain_of(value) < row.chain) return std::nullopt;
  return "s" + value;
}

std::optional<std::string> canonical_hex(std::string_view text) {
  std::string upper(text);
  for (char& character : upper) {
    if (character >= 'a' && character <= 'f') character = static_cast<char>(character - 'a' + 'A');
    if (!((character >= '0' && character <= '9') || (character >= 'A' && character <= 'F'))) return std::nullopt;
  }
  return upper.size() % 2 == 0 ? std::optional(upper) : std::nullopt;
}

/// Base64 consists of groups of four characters. Only where '=' ends the last group may it have bits that are not used
/// (RFC 3548, section 3).
std::optional<std::string> canonical_base64(std::string packed) {
  static constexpr std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::erase(packed, ' ');
  if (packed.size() % 4 != 0) return std::nullopt;
  std::string_view digits = packed;
  while (digits.ends_with('=')) digits.remove_suffix(1);
  const std::size_t padding = packed.size() - digits.size();
  if (padding > 2 || digits.find_first_not_of(alphabet) != std::string_view::npos) return std::nullopt;
  const std::size_t free_bits = padding * 2;
  if (padding > 0 && (alphabet.find(digits.back()) & ((1U << free_bits) - 1)) != 0) return std::nullopt;
  return packed;
}

/// The same numeral for the same number: a decimal where there is one, otherwise count and over without a common
/// divisor. Both are canonical, and `over` is positive. Very long ones stay as they are, since dividing them takes
/// long.
std::string canonical_fraction(const std::string& count, const std::string& over, bool& is_exact) {
  using Integer =
      boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>, boost::multiprecision::et_off>;
  constexpr std::size_t max_digits = 400;
  if (over == "1") return count;
  if (count.size() > max_digits || over.size() > max_digits) {
    is_exact = false;
    return count + "/" + over;
  }
  Integer above(count);
  Integer below(over);
  const Integer common = boost::multiprecision::gcd(above, below);
  above /= common;
  below /= common;
  // A decimal needs as many places as the divisor has factors 2, or 5.
  Integer rest = below;
  std::size_t places = 0;
  for (const unsigned factor : {2U, 5U}) {
    std::size_t times = 0;
    for (; rest % factor == 0; rest /= factor) ++times;
    places = std::max(places, times);
  }
  if (rest != 1) return above.str() + "/" + below.str();
  const bool is_negative = above < 0;
  const Integer shifted = boost::multiprecision::abs(above) *
                          boost::multiprecision::pow(Integer(10), static_cast<unsigned>(places)) / below;
  std::string digits = shifted.str();
  if (digits.size() <= places) digits.insert(0, places + 1 - digits.size(), '0');
  if (places > 0) digits.insert(digits.size() - places, 1, '.');
  return (is_negative ? "-" : "") + digits;
}

std::optional<std::string> canonical_number(const Row& row, std::string_view text, bool& is_exact) {
  if (row.space == ValueSpace::whole_family) return std::nullopt;  // owl:real has no lexical forms
  if (row.space == ValueSpace::rational) {
    const std::size_t slash = text.find('/');
    if (slash == std::string_view::npos) return std::nullopt;
    const auto over = canonical_decimal(text.substr(slash + 1), false);
    auto count = canonical_decimal(text.substr(0, slash), false);
    if (!over || !count || *over == "0" || over->starts_with('-')) return std::nullopt;
    return canonical_fraction(*count, *over, is_exact);
  }
  auto value = canonical_decimal(text, row.space == ValueSpace::decimal);
  if (!value || !is_at_least(*value, row.low) || !is_at_most(*value, row.high)) return std::nullopt;
  return value;
}

std::optional<std::string> canonical_form(const Row& row, std::string_view lexical, std::string_view language,
                                          bool& is_exact) {
  if (row.family == text) return canonical_text(row, lexical, language);
  std::string trimmed = collapsed(lexical);
  switch (row.family) {
    case number:
      return canonical_number(row, trimmed, is_exact);
    case double_:
      return canonical_float<double>(trimmed);
    case float_:
      return canonical_float<float>(trimmed);
    case boolean:
      if (trimmed == "true" || trimmed == "1") return "true";
      if (trimmed == "false" || trimmed == "0") return "false";
      return std::nullopt;
    case hex:
      return canonical_hex(trimmed);
    case base64:
      return canonical_base64(trimmed);
    case uri:
      return trimmed;
    case DataFamily::time: {
      auto value = canonical_time(trimmed);
      const bool has_zone = value && (value->ends_with('Z') || value->rfind(':') > value->find('T') + 6);
      if (row.space == ValueSpace::time_with_zone && !has_zone) return std::nullopt;
      return value;
    }
    default:
      is_exact = false;
      return std::string(lexical);
  }
}

}  // namespace

std::optional<owl::Datatype> Datatype::find(std::string_view iri) {
  for (std::size_t row = 0; row < rows.size(); ++row) {
    if (iri.size() == rows[row].prefix.size() + rows[row].name.size() && iri.starts_with(rows[row].prefix) &&
        iri.ends_with(rows[row].name)) {
      return owl::Datatype(static_cast<std::uint8_t>(row));
    }
  }
  return std::nullopt;
}

DataFamily Datatype::family() const { return rows[row_].family; }

bool Datatype::is_within(owl::Datatype other) const {
  const Row& a = rows[row_];
  const Row& b = rows[other.row_];
  if (a.family != b.family) return false;
  if (row_ == other.row_ || b.space == ValueSpace::whole_family) return true;
  if (a.family == text) {
    if (a.chain == lang_string_chain || b.chain == lang_string_chain) return b.chain == 0;
    return a.chain >= b.chain;
  }
  if (a.family != number) return false;
  if (a.space < b.space) return false;
  if (b.space != ValueSpace::integer) return true;
  return (b.low.empty() || (!a.low.empty() && is_at_least(a.low, b.low))) &&
         (b.high.empty() || (!a.high.empty() && is_at_most(a.high, b.high)));
}

bool Datatype::is_disjoint(owl::Datatype other) const {
  const Row& a = rows[row_];
  const Row& b = rows[other.row_];
  if (a.family != b.family) return true;
  if (a.family == text) {
    const bool one_has_language = (a.chain == lang_string_chain) != (b.chain == lang_string_chain);
    return one_has_language && a.chain != 0 && b.chain != 0;
  }
  if (a.space != ValueSpace::integer || b.space != ValueSpace::integer) return false;
  const auto is_above = [](const Row& upper, const Row& lower) {
    return !upper.low.empty() && !lower.high.empty() && is_less(lower.high, upper.low);
  };
  return is_above(a, b) || is_above(b, a);
}

bool Datatype::is_finite() const {
  const Row& row = rows[row_];
  return row.family == boolean || row.family == double_ || row.family == float_ ||
         (row.space == ValueSpace::integer && !row.low.empty() && !row.high.empty());
}

std::optional<owl::DataValue> DataValue::read(std::string_view lexical, std::string_view datatype_iri,
                                              std::string_view language, bool& is_ill_formed) {
  is_ill_formed = false;
  const auto type = Datatype::find(datatype_iri);
  if (!type) return std::nullopt;
  owl::DataValue value;
  value.family = type->family();
  auto canonical = owl::canonical_form(rows[type->row_], lexical, language, value.is_exact);
  if (!canonical) {
    is_ill_formed = true;
    return std::nullopt;
  }
  value.canonical = std::move(*canonical);
  return value;
}

bool DataValue::is_in(owl::Datatype type) const {
  const Row& row = rows[type.row_];
  if (row.family != family) return false;
  if (row.space == ValueSpace::whole_family) return true;
  if (family == text) {
    if (canonical.front() == 'l') return row.chain == 0 || row.chain == lang_string_chain;
    return row.chain != lang_string_chain && chain_of(std::string_view(canonical).substr(1)) >= row.chain;
  }
  if (family == number) {
    if (row.space == ValueSpace::rational) return true;
    if (canonical.find('/') != std::string::npos) return false;
    if (row.space == ValueSpace::decimal) return true;
    return canonical.find('.') == std::string::npos && is_at_least(canonical, row.low) &&
           is_at_most(canonical, row.high);
  }
  // A time remains, with or without a zone.
  return canonical.ends_with('Z') || canonical.rfind(':') > canonical.find('T') + 6;
}

}  // namespace geminga::owl
