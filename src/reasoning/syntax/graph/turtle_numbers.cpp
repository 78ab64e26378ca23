#include "reasoning/syntax/graph/turtle_numbers.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "base/text.hpp"
#include "reasoning/syntax/vocabulary.hpp"

namespace geminga::graph {
namespace {

bool are_digits(std::string_view text) {
  return std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; });
}

/// The parts of a number. Nothing if the text is no number.
struct Parts {
  std::string sign, whole, fraction, exponent;
  bool has_point = false;
};

std::optional<Parts> parts_of(std::string_view text) {
  Parts parts;
  if (text.starts_with('+') || text.starts_with('-')) {
    parts.sign = text.substr(0, 1);
    text.remove_prefix(1);
  }
  const std::size_t e = text.find_first_of("eE");
  if (e != std::string_view::npos) {
    parts.exponent = text.substr(e + 1);
    std::string_view digits = parts.exponent;
    if (digits.starts_with('+') || digits.starts_with('-')) digits.remove_prefix(1);
    if (digits.empty() || !are_digits(digits)) return std::nullopt;
    text = text.substr(0, e);
  }
  const std::size_t point = text.find('.');
  parts.has_point = point != std::string_view::npos;
  parts.whole = text.substr(0, point);
  if (parts.has_point) parts.fraction = text.substr(point + 1);
  if (!are_digits(parts.whole) || !are_digits(parts.fraction) || (parts.whole.empty() && parts.fraction.empty()))
    return std::nullopt;
  return parts;
}

std::optional<std::string> safe_form(std::string_view text, std::string_view datatype) {
  if (datatype == "boolean") {
    if (text == "true" || text == "1") return "true";
    if (text == "false" || text == "0") return "false";
    return std::nullopt;
  }
  const auto parts = parts_of(text);
  if (!parts) return std::nullopt;
  const bool is_integer = !parts->has_point && parts->exponent.empty();
  if (datatype == "integer") return is_integer ? std::optional(std::string(text)) : std::nullopt;
  const std::string number = parts->sign + (parts->whole.empty() ? "0" : parts->whole) + '.' +
                             (parts->fraction.empty() ? "0" : parts->fraction);
  if (datatype == "double") return number + 'e' + (parts->exponent.empty() ? "0" : parts->exponent);
  return parts->exponent.empty() ? std::optional(number) : std::nullopt;
}

}  // namespace

std::optional<Node> turtle_number(const Node& literal) {
  const std::string_view datatype = literal.datatype;
  if (literal.kind != Node::Kind::literal || !datatype.starts_with(syntax::xsd_namespace)) return std::nullopt;
  const std::string_view word = datatype.substr(syntax::xsd_namespace.size());
  if (word != "integer" && word != "decimal" && word != "double" && word != "boolean") return std::nullopt;
  auto form = safe_form(base::trimmed(literal.text), word);
  if (form && *form == literal.text) return std::nullopt;
  Node written = literal;
  if (form) {
    written.text = std::move(*form);
  } else {
    written.datatype += in_quotes;
  }
  return written;
}

}  // namespace geminga::graph
