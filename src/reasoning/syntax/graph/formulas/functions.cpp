// Functions of SPARQL on terms, texts, numbers and times (SPARQL 1.1 Query Language, sections 17.4 and 17.5).
#include <algorithm>
#include <cmath>
#include <utility>

#include "base/text.hpp"
#include "base/utf8.hpp"
#include "reasoning/owl/datatypes.hpp"
#include "reasoning/syntax/graph/formulas/formulas.hpp"
#include "reasoning/syntax/graph/formulas/text_functions.hpp"
#include "reasoning/syntax/graph/formulas/times.hpp"

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
      if (exact < 0) exact = -exact;
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

/// The value of the function of an operator for its arguments. Arguments that are missing are errors.
using Function = Scalar (*)(rasqal_op op, const Arguments& arguments);

Scalar argument(const Arguments& arguments, std::size_t at) {
  return at < arguments.size() ? arguments[at] : std::nullopt;
}

template <Scalar (*function)(rasqal_op, const Scalar&)>
Scalar of_one(rasqal_op op, const Arguments& arguments) {
  return function(op, argument(arguments, 0));
}

template <Scalar (*function)(rasqal_op, const Scalar&, const Scalar&)>
Scalar of_two(rasqal_op op, const Arguments& arguments) {
  return function(op, argument(arguments, 0), argument(arguments, 1));
}

template <Scalar (*function)(const Arguments&)>
Scalar of_all(rasqal_op /*op*/, const Arguments& arguments) {
  return function(arguments);
}

Scalar cased(rasqal_op op, const Scalar& value) { return text_in_case(value, op == RASQAL_EXPR_UCASE); }

/// The functions that have an operator of their own.
constexpr std::pair<rasqal_op, Function> functions[] = {
    {RASQAL_EXPR_STR, of_one<about_term>},
    {RASQAL_EXPR_LANG, of_one<about_term>},
    {RASQAL_EXPR_DATATYPE, of_one<about_term>},
    {RASQAL_EXPR_ISURI, of_one<about_term>},
    {RASQAL_EXPR_ISBLANK, of_one<about_term>},
    {RASQAL_EXPR_ISLITERAL, of_one<about_term>},
    {RASQAL_EXPR_ISNUMERIC, of_one<about_term>},
    {RASQAL_EXPR_STRLEN, of_one<about_term>},
    {RASQAL_EXPR_ENCODE_FOR_URI, of_one<about_term>},
    {RASQAL_EXPR_URI, of_one<about_term>},
    {RASQAL_EXPR_IRI, of_one<about_term>},
    {RASQAL_EXPR_SAMETERM, of_two<about_terms>},
    {RASQAL_EXPR_LANGMATCHES, of_two<about_terms>},
    {RASQAL_EXPR_STRLANG, of_two<about_terms>},
    {RASQAL_EXPR_STRDT, of_two<about_terms>},
    {RASQAL_EXPR_REGEX, of_all<matches>},
    {RASQAL_EXPR_REPLACE, of_all<replaced>},
    {RASQAL_EXPR_CONCAT, of_all<joined>},
    {RASQAL_EXPR_SUBSTR, of_all<part_of>},
    {RASQAL_EXPR_UCASE, of_one<cased>},
    {RASQAL_EXPR_LCASE, of_one<cased>},
    {RASQAL_EXPR_STRSTARTS, of_two<compare_texts>},
    {RASQAL_EXPR_STRENDS, of_two<compare_texts>},
    {RASQAL_EXPR_CONTAINS, of_two<compare_texts>},
    {RASQAL_EXPR_STRBEFORE, of_two<compare_texts>},
    {RASQAL_EXPR_STRAFTER, of_two<compare_texts>},
    {RASQAL_EXPR_ABS, of_one<rounded>},
    {RASQAL_EXPR_ROUND, of_one<rounded>},
    {RASQAL_EXPR_CEIL, of_one<rounded>},
    {RASQAL_EXPR_FLOOR, of_one<rounded>},
    {RASQAL_EXPR_YEAR, of_one<part_of_time>},
    {RASQAL_EXPR_MONTH, of_one<part_of_time>},
    {RASQAL_EXPR_DAY, of_one<part_of_time>},
    {RASQAL_EXPR_HOURS, of_one<part_of_time>},
    {RASQAL_EXPR_MINUTES, of_one<part_of_time>},
    {RASQAL_EXPR_SECONDS, of_one<part_of_time>},
    {RASQAL_EXPR_TZ, of_one<part_of_time>},
};

/// Null where there is none.
Function function_of(rasqal_op op) {
  const auto* const found = std::ranges::find(functions, op, &std::pair<rasqal_op, Function>::first);
  return found == std::end(functions) ? nullptr : found->second;
}

/// Whether the function has a name instead of an operator.
bool is_named(const rasqal_expression& formula) {
  return formula.op == RASQAL_EXPR_FUNCTION || formula.op == RASQAL_EXPR_CAST;
}

}  // namespace

bool is_function(const rasqal_expression& formula) {
  return is_named(formula) ? !type_of_cast(formula).empty() : function_of(formula.op) != nullptr;
}

Scalar call(const rasqal_expression& formula, const Arguments& arguments) {
  if (is_named(formula)) return cast(type_of_cast(formula), argument(arguments, 0));
  return function_of(formula.op)(formula.op, arguments);
}

}  // namespace geminga::graph
