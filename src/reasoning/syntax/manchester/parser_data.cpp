// Data ranges and literals. The grammar of MANCHESTER.md stands above each function.
#include <array>
#include <utility>

#include "reasoning/syntax/manchester/parser.hpp"

namespace geminga::manchester {
namespace {

using owl::TermKind;

constexpr std::string_view xsd = "http://www.w3.org/2001/XMLSchema#";

/// Facets as they are written, and the last part of their IRIs.
constexpr std::array<std::pair<std::string_view, std::string_view>, 9> facets{{
    {"<=", "maxInclusive"},
    {"<", "maxExclusive"},
    {">=", "minInclusive"},
    {">", "minExclusive"},
    {"length", "length"},
    {"minLength", "minLength"},
    {"maxLength", "maxLength"},
    {"pattern", "pattern"},
    {"langRange", ""},
}};

std::string iri_of_facet(std::string_view written) {
  for (const auto& [word, local] : facets) {
    if (word == written && !local.empty()) return std::string(xsd) += local;
  }
  return "http://www.w3.org/1999/02/22-rdf-syntax-ns#langRange";
}

}  // namespace

// dataRange = dataConjunction *( "or" dataConjunction )
owl::TermId Parser::data_range() {
  std::vector<Term> parts{data_conjunction()};
  while (!failed() && take_keyword("or")) parts.push_back(data_conjunction());
  return failed() || parts.size() == 1 ? parts.front() : source_.term(TermKind::data_union_of, parts);
}

// dataConjunction = dataPrimary *( "and" dataPrimary )
owl::TermId Parser::data_conjunction() {
  std::vector<Term> parts{data_primary()};
  while (!failed() && take_keyword("and")) parts.push_back(data_primary());
  return failed() || parts.size() == 1 ? parts.front() : source_.term(TermKind::data_intersection_of, parts);
}

// dataPrimary = "not" dataPrimary / datatype [ "[" facet literal *( "," facet literal ) "]" ]
//             / "{" literal *( "," literal ) "}" / "(" dataRange ")"
owl::TermId Parser::data_primary() {
  if (failed()) return owl::thing_term;
  const Level level(*this);
  if (take_keyword("not")) {
    const Term inner = data_primary();
    return failed() ? inner : source_.term(TermKind::data_complement_of, {inner});
  }
  if (take_symbol("(")) {
    const Term inner = data_range();
    expect_symbol(")", "'and', 'or' or ')'");
    return inner;
  }
  if (take_symbol("{")) {
    if (take_symbol("}")) {
      remark("DataOneOf of nothing, read as no value");
      return source_.term(TermKind::data_complement_of,
                          {source_.datatype("http://www.w3.org/2000/01/rdf-schema#Literal")});
    }
    std::vector<Term> members{literal()};
    while (!failed() && take_symbol(",")) members.push_back(literal());
    expect_symbol("}", "',' or '}'");
    return failed() ? owl::thing_term : source_.term(TermKind::data_one_of, members);
  }
  if (!is_name()) return expected("a datatype, 'not', '(' or '{'");
  const Term datatype = entity(TermKind::datatype, take());
  return is_symbol("[") && !failed() ? datatype_restriction(datatype) : datatype;
}

owl::TermId Parser::datatype_restriction(Term datatype) {
  std::vector<Term> arguments{datatype};
  do {
    tokens_.set_facets(true);
    take();  // the bracket, or a comma
    tokens_.set_facets(false);
    arguments.push_back(facet());
  } while (!failed() && is_symbol(","));
  expect_symbol("]", "',' or ']'");
  return failed() ? owl::thing_term : source_.term(TermKind::datatype_restriction, arguments);
}

owl::TermId Parser::facet() {
  if (tokens_.token().kind != TokenKind::facet) {
    return expected("'<', '<=', '>', '>=', 'length', 'minLength', 'maxLength', 'pattern' or 'langRange'");
  }
  const std::string iri = iri_of_facet(take().text);
  const Term value = literal();
  return failed() ? value : source_.facet(iri, value);
}

// literal = string [ "@" language / "^^" datatype ] / number / "true" / "false"
owl::TermId Parser::literal() {
  if (failed()) return owl::thing_term;
  if (tokens_.token().kind == TokenKind::number) return number();
  if (is_keyword("true") || is_keyword("false")) {
    return source_.literal(take().text, std::string(xsd) + "boolean");
  }
  if (tokens_.token().kind != TokenKind::string) return expected("a literal: a number, \"text\", true or false");
  if (++parts_ > limits_.parts) {
    return fail(ParseError::Kind::too_large, tokens_.token().begin,
                "more than " + std::to_string(limits_.parts) + " names and values");
  }
  const Token text = take();
  if (tokens_.token().kind == TokenKind::language) {
    if (tokens_.token().value.empty()) return expected("a language behind '@'");
    return literal_of(text, {}, take().value);
  }
  if (tokens_.token().kind != TokenKind::carets) return literal_of(text, {}, {});
  take();
  if (!is_name()) return expected("a datatype");
  const Term datatype = entity(TermKind::datatype, take());
  return failed() ? datatype : literal_of(text, source_.name_of(datatype), {});
}

// A whole number is an xsd:integer, one with a point an xsd:decimal, one with an exponent or f an xsd:float.
owl::TermId Parser::number() {
  if (++parts_ > limits_.parts) {
    return fail(ParseError::Kind::too_large, tokens_.token().begin,
                "more than " + std::to_string(limits_.parts) + " names and values");
  }
  std::string_view text = take().text;
  std::string_view type = text.find('.') == std::string_view::npos ? "integer" : "decimal";
  if (text.find_first_of("eEfF") != std::string_view::npos) type = "float";
  if (text.back() == 'f' || text.back() == 'F') text.remove_suffix(1);
  return source_.literal(text, std::string(xsd) += type);
}

}  // namespace geminga::manchester
