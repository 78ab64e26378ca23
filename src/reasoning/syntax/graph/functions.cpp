// Functions of SPARQL on terms, texts, numbers and times (SPARQL 1.1 Query Language, sections 17.4 and 17.5).
#include <algorithm>
#include <cmath>

#include "base/text.hpp"
#include "base/utf8.hpp"
#include "reasoning/owl/datatypes.hpp"
#include "reasoning/syntax/graph/formulas.hpp"
#include "reasoning/syntax/graph/text_functions.hpp"
#include "reasoning/syntax/graph/times.hpp"

namespace geminga::graph {
namespace {

using Arguments = std::vector<Scalar>;
using Integer = boost::multiprecision::cpp_int;
using Rational = boost::multiprecision::cpp_rational;

constexpr std::string_view lang_string = "http://www.w3.org/1999/02/22-rdf-syntax-ns#langString";

bool is_any_literal(const Scalar& value) { return value && value->kind == Node::Kind::literal; }

std::string_view type_of_cast(const rasqal_expression& formula) {
  if (formula.name == nullptr) return {};
  const std::string_view name = reinterpret_cast<const char*>(raptor_uri_as_string(formula.name));
  if (!name.starts_with(owl::xsd_namespace)) return {};
  const std::string_view type = name.substr(owl::xsd_namespace.size());
  for (const std::string_view known : {"string", "boolean", "integer", "decimal", "float", "double", "dateTime"}) {
    if (type == known) return known;
  }
  return {};
}

Integer floor_of(const Rational& number) {
  const Integer numerator = boost::multiprecision::numerator(number);
  const Integer denominator = boost::multiprecision::denominator(number);
  Integer quotient = numerator / denominator;
  if (numerator < 0 && quotient * denominator != numerator) --quotient;
  return quotient;
}

Scalar rounded(rasqal_op op, const Scalar& value) {
  auto number = value ? number_of(*value) : std::nullopt;
  if (!number) return std::nullopt;
  Rational& exact = number->exact;
  double& approximate = number->approximate;
  switch (op) {
    case RASQAL_EXPR_ABS:
      exact = boost::multiprecision::abs(exact);
      approximate = std::abs(approximate);
      break;
    case RASQAL_EXPR_FLOOR:
      exact = Rational(floor_of(exact));
      approximate = std::floor(approximate);
      break;
    case RASQAL_EXPR_CEIL:
      exact = Rational(-floor_of(-exact));
      approximate = std::ceil(approximate);
      break;
    default:  // half up, as fn:round
      exact = Rational(floor_of(exact + Rational(1, 2)));
      approximate = std::floor(approximate + 0.5);
  }
  return node_of(*number);
}

Scalar cast(std::string_view type, const Scalar& value) {
  if (!value || value->kind == Node::Kind::blank) return std::nullopt;
  if (type == "string") return text(value->text);
  if (value->kind != Node::Kind::literal || !value->language.empty()) return std::nullopt;
  const auto number = number_of(*value);
  if (type == "boolean") {
    if (number) return boolean(truth_of(*value).value_or(false));
    if (value->text == "true" || value->text == "1") return boolean(true);
    if (value->text == "false" || value->text == "0") return boolean(false);
    return std::nullopt;
  }
  Node typed{Node::Kind::literal, value->text, std::string(owl::xsd_namespace).append(type), {}};
  if (type == "dateTime") {
    const bool fits = is_text(*value) || value->datatype == typed.datatype;
    return fits && instant_of(typed) ? Scalar(typed) : std::nullopt;
  }
  if (value->datatype == std::string(owl::xsd_namespace) + "boolean")
    typed.text = std::string(1, truth_of(*value).value_or(false) ? '1' : '0');
  if (!number) {
    const auto read = number_of(typed);
    return read ? Scalar(node_of(*read)) : std::nullopt;
  }
  const Numeric::Type wanted = number_of({Node::Kind::literal, "0", typed.datatype, {}})->type;
  Numeric converted = as_type(*number, wanted);
  if (wanted <= Numeric::Type::decimal) {
    if (number->type > Numeric::Type::decimal) {
      if (!std::isfinite(number->approximate)) return std::nullopt;
      converted.exact = Rational(number->approximate);
    }
    if (wanted == Numeric::Type::integer)
      converted.exact =
          converted.exact < 0 ? Rational(-floor_of(-converted.exact)) : Rational(floor_of(converted.exact));
  }
  return node_of(converted);
}

/// RFC 4647, section 3.3.1.
bool matches_language(std::string_view tag, std::string_view range) {
  if (range == "*") return !tag.empty();
  const std::string small_tag = base::in_lower_case(tag);
  const std::string small_range = base::in_lower_case(range);
  return small_tag == small_range || small_tag.starts_with(small_range + '-');
}

Scalar part_of_time(rasqal_op op, const Scalar& value) {
  const auto time = value ? instant_of(*value) : std::nullopt;
  if (!time) return std::nullopt;
  switch (op) {
    case RASQAL_EXPR_YEAR:
      return integer(time->year);
    case RASQAL_EXPR_MONTH:
      return integer(time->month);
    case RASQAL_EXPR_DAY:
      return integer(time->day);
    case RASQAL_EXPR_TZ:
      return text(time->written_zone);
    default:
      break;
  }
  if (time->is_date) return std::nullopt;
  if (op == RASQAL_EXPR_HOURS) return integer(time->hours);
  if (op == RASQAL_EXPR_MINUTES) return integer(time->minutes);
  const auto seconds = number_of({Node::Kind::literal, time->seconds, std::string(owl::xsd_namespace) + "decimal", {}});
  return seconds ? Scalar(node_of(*seconds)) : std::nullopt;
}

Scalar datatype_of(const Scalar& value) {
  if (!is_any_literal(value)) return std::nullopt;
  if (!value->language.empty()) return iri(lang_string);
  return iri(value->datatype.empty() ? std::string(owl::xsd_namespace) + "string" : value->datatype);
}

/// Functions of one term.
Scalar about_term(rasqal_op op, const Scalar& value) {
  if (!value) return std::nullopt;
  switch (op) {
    case RASQAL_EXPR_STR:
      return value->kind == Node::Kind::blank ? Scalar() : text(value->text);
    case RASQAL_EXPR_LANG:
      return is_any_literal(value) ? Scalar(text(value->language)) : std::nullopt;
    case RASQAL_EXPR_DATATYPE:
      return datatype_of(value);
    case RASQAL_EXPR_ISURI:
      return boolean(value->kind == Node::Kind::iri);
    case RASQAL_EXPR_ISBLANK:
      return boolean(value->kind == Node::Kind::blank);
    case RASQAL_EXPR_ISLITERAL:
      return boolean(is_any_literal(value));
    case RASQAL_EXPR_ISNUMERIC:
      return boolean(number_of(*value).has_value());
    case RASQAL_EXPR_STRLEN:
      return is_string(value) ? Scalar(integer(static_cast<std::int64_t>(base::count_characters(value->text))))
                              : std::nullopt;
    case RASQAL_EXPR_ENCODE_FOR_URI:
      return is_string(value) ? Scalar(text(for_uri(value->text))) : std::nullopt;
    default:  // URI, IRI
      return value->kind == Node::Kind::iri || is_text(*value) ? Scalar(iri(value->text)) : std::nullopt;
  }
}

/// Functions of two terms.
Scalar about_terms(rasqal_op op, const Scalar& first, const Scalar& second) {
  if (!first || !second) return std::nullopt;
  switch (op) {
    case RASQAL_EXPR_SAMETERM:
      return boolean(*first == *second);
    case RASQAL_EXPR_LANGMATCHES:
      return is_text(*first) && is_text(*second) ? Scalar(boolean(matches_language(first->text, second->text)))
                                                 : std::nullopt;
    case RASQAL_EXPR_STRLANG:
      return is_text(*first) && is_text(*second) && !second->text.empty()
                 ? Scalar(Node{Node::Kind::literal, first->text, {}, base::in_lower_case(second->text)})
                 : std::nullopt;
    default:  // STRDT
      if (!is_text(*first) || second->kind != Node::Kind::iri) return std::nullopt;
      return Node{Node::Kind::literal,
                  first->text,
                  second->text == std::string(owl::xsd_namespace) + "string" ? std::string() : second->text,
                  {}};
  }
}

}  // namespace

bool is_function(const rasqal_expression& formula) {
  switch (formula.op) {
    case RASQAL_EXPR_FUNCTION:
    case RASQAL_EXPR_CAST:
      return !type_of_cast(formula).empty();
    case RASQAL_EXPR_STR:
    case RASQAL_EXPR_LANG:
    case RASQAL_EXPR_DATATYPE:
    case RASQAL_EXPR_ISURI:
    case RASQAL_EXPR_ISBLANK:
    case RASQAL_EXPR_ISLITERAL:
    case RASQAL_EXPR_ISNUMERIC:
    case RASQAL_EXPR_STRLEN:
    case RASQAL_EXPR_ENCODE_FOR_URI:
    case RASQAL_EXPR_URI:
    case RASQAL_EXPR_IRI:
    case RASQAL_EXPR_SAMETERM:
    case RASQAL_EXPR_LANGMATCHES:
    case RASQAL_EXPR_STRLANG:
    case RASQAL_EXPR_STRDT:
    case RASQAL_EXPR_REGEX:
    case RASQAL_EXPR_REPLACE:
    case RASQAL_EXPR_CONCAT:
    case RASQAL_EXPR_SUBSTR:
    case RASQAL_EXPR_UCASE:
    case RASQAL_EXPR_LCASE:
    case RASQAL_EXPR_STRSTARTS:
    case RASQAL_EXPR_STRENDS:
    case RASQAL_EXPR_CONTAINS:
    case RASQAL_EXPR_STRBEFORE:
    case RASQAL_EXPR_STRAFTER:
    case RASQAL_EXPR_ABS:
    case RASQAL_EXPR_ROUND:
    case RASQAL_EXPR_CEIL:
    case RASQAL_EXPR_FLOOR:
    case RASQAL_EXPR_YEAR:
    case RASQAL_EXPR_MONTH:
    case RASQAL_EXPR_DAY:
    case RASQAL_EXPR_HOURS:
    case RASQAL_EXPR_MINUTES:
    case RASQAL_EXPR_SECONDS:
    case RASQAL_EXPR_TZ:
      return true;
    default:
      return false;
  }
}

Scalar call(const rasqal_expression& formula, const std::vector<Scalar>& arguments) {
  const rasqal_op op = formula.op;
  const Scalar none;
  const Scalar& first = arguments.empty() ? none : arguments[0];
  const Scalar& second = arguments.size() < 2 ? none : arguments[1];
  switch (op) {
    case RASQAL_EXPR_FUNCTION:
    case RASQAL_EXPR_CAST:
      return cast(type_of_cast(formula), first);
    case RASQAL_EXPR_REGEX:
      return matches(arguments);
    case RASQAL_EXPR_REPLACE:
      return replaced(arguments);
    case RASQAL_EXPR_CONCAT:
      return joined(arguments);
    case RASQAL_EXPR_SUBSTR:
      return part_of(arguments);
    case RASQAL_EXPR_UCASE:
    case RASQAL_EXPR_LCASE:
      return text_in_case(first, op == RASQAL_EXPR_UCASE);
    case RASQAL_EXPR_STRSTARTS:
    case RASQAL_EXPR_STRENDS:
    case RASQAL_EXPR_CONTAINS:
    case RASQAL_EXPR_STRBEFORE:
    case RASQAL_EXPR_STRAFTER:
      return compare_texts(op, first, second);
    case RASQAL_EXPR_ABS:
    case RASQAL_EXPR_ROUND:
    case RASQAL_EXPR_CEIL:
    case RASQAL_EXPR_FLOOR:
      return rounded(op, first);
    case RASQAL_EXPR_YEAR:
    case RASQAL_EXPR_MONTH:
    case RASQAL_EXPR_DAY:
    case RASQAL_EXPR_HOURS:
    case RASQAL_EXPR_MINUTES:
    case RASQAL_EXPR_SECONDS:
    case RASQAL_EXPR_TZ:
      return part_of_time(op, first);
    case RASQAL_EXPR_SAMETERM:
    case RASQAL_EXPR_LANGMATCHES:
    case RASQAL_EXPR_STRLANG:
    case RASQAL_EXPR_STRDT:
      return about_terms(op, first, second);
    default:
      return about_term(op, first);
  }
}

}  // namespace geminga::graph
