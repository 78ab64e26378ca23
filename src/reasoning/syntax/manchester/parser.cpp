// Class expressions. The grammar of MANCHESTER.md stands above each function.
#include "reasoning/syntax/manchester/parser.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "base/text.hpp"

namespace geminga::manchester {
namespace {

using owl::TermKind;

constexpr std::array<std::string_view, 7> words_of_restrictions{"some", "only", "value",  "Self",
                                                                "min",  "max",  "exactly"};

bool begins_restriction(const Token& token) {
  return token.kind == TokenKind::keyword &&
         std::ranges::find(words_of_restrictions, token.text) != words_of_restrictions.end();
}

}  // namespace

Parser::Level::Level(Parser& parser) : parser_(parser) {
  if (parser.depth_++ <= parser.limits_.nesting) return;  // level 0 is the text itself
  parser.fail(ParseError::Kind::too_large, parser.tokens_.token().begin,
              "more than " + std::to_string(parser.limits_.nesting) + " levels of nesting");
}

// description = conjunction *( "or" conjunction )
owl::TermId Parser::description() {
  const Level level(*this);
  std::vector<Term> parts{conjunction()};
  while (!failed() && take_keyword("or")) parts.push_back(conjunction());
  return failed() || parts.size() == 1 ? parts.front() : source_.term(TermKind::object_union_of, parts);
}

// conjunction = primary *( ( "and" / "that" ) primary ), "that" behind a class only
owl::TermId Parser::conjunction() {
  std::vector<Term> parts{primary()};
  while (!failed()) {
    const bool is_that = is_keyword("that");
    if (is_that && (parts.size() > 1 || source_.kind(parts.front()) != TermKind::named_class)) {
      return expected("'and' ('that' stands behind a class)");
    }
    if (!take_keyword("and") && !take_keyword("that")) break;
    parts.push_back(primary());
  }
  return failed() || parts.size() == 1 ? parts.front() : source_.term(TermKind::object_intersection_of, parts);
}

// primary = "not" primary / restriction / class / "{" individual *( "," individual ) "}" / "(" description ")"
owl::TermId Parser::primary() {
  if (failed()) return owl::thing_term;
  if (is_keyword("not")) return negation();
  if (is_symbol("{")) return enumeration();
  if (take_symbol("(")) {
    const Term inner = description();
    expect_symbol(")", "'and', 'or' or ')'");
    return inner;
  }
  if (is_keyword("inverse")) return restriction();
  if (!is_name()) return expected("a class, a property, 'not', 'inverse', '(' or '{'");
  return is_restriction_next() ? restriction() : entity(TermKind::named_class, take());
}

owl::TermId Parser::negation() {
  const Level level(*this);
  take();
  const Term inner = primary();
  return failed() ? owl::thing_term : source_.term(TermKind::object_complement_of, {inner});
}

owl::TermId Parser::enumeration() {
  take();
  if (take_symbol("}")) {
    remark("ObjectOneOf of nothing, read as owl:Nothing");
    return owl::nothing_term;
  }
  std::vector<Term> members{individual()};
  while (!failed() && take_symbol(",")) members.push_back(individual());
  expect_symbol("}", "',' or '}'");
  return failed() ? owl::thing_term : source_.term(TermKind::object_one_of, members);
}

owl::TermId Parser::individual() {
  if (failed()) return owl::thing_term;
  return is_name() ? entity(TermKind::individual, take()) : expected("an individual");
}

// restriction = property ( "some" / "only" ) primary / property "value" individual / property "Self"
//             / property ( "min" / "max" / "exactly" ) number [ primary ]
//             / property ( "some" / "only" ) dataPrimary / property "value" literal
//             / property ( "min" / "max" / "exactly" ) number [ dataPrimary ]
owl::TermId Parser::restriction() {
  const Level level(*this);
  const Term of = property();
  if (failed()) return of;
  const bool is_data = source_.kind(of) == TermKind::data_property;
  const auto with = [&](Term filler, TermKind of_objects, TermKind of_data) {
    return failed() ? filler : source_.term(is_data ? of_data : of_objects, {of, filler});
  };
  if (take_keyword("some"))
    return with(is_data ? data_primary() : primary(), TermKind::object_some_values_from,
                TermKind::data_some_values_from);
  if (take_keyword("only"))
    return with(is_data ? data_primary() : primary(), TermKind::object_all_values_from, TermKind::data_all_values_from);
  if (take_keyword("value"))
    return with(is_data ? literal() : individual(), TermKind::object_has_value, TermKind::data_has_value);
  if (!is_data && take_keyword("Self")) return source_.term(TermKind::object_has_self, {of});
  return cardinality(of, is_data);
}

owl::TermId Parser::cardinality(Term of, bool is_data) {
  TermKind kind = TermKind::object_exact_cardinality;
  if (is_keyword("min")) kind = TermKind::object_min_cardinality;
  if (is_keyword("max")) kind = TermKind::object_max_cardinality;
  if (kind == TermKind::object_exact_cardinality && !is_keyword("exactly")) {
    return expected(is_data ? "'some', 'only', 'value', 'min', 'max' or 'exactly'"
                            : "'some', 'only', 'value', 'Self', 'min', 'max' or 'exactly'");
  }
  if (is_data) {
    kind = static_cast<TermKind>(static_cast<int>(kind) - static_cast<int>(TermKind::object_min_cardinality) +
                                 static_cast<int>(TermKind::data_min_cardinality));
  }
  take();
  const auto count = base::parse_number<std::uint32_t>(tokens_.token().text);
  if (tokens_.token().kind != TokenKind::number || !count) return expected("a number from 0 to 4294967295");
  take();
  if (!has_filler()) return source_.term(kind, {of}, *count);
  const Term filler = is_data ? data_primary() : primary();
  return failed() ? filler : source_.term(kind, {of, filler}, *count);
}

// property = "inverse" name / "inverse" "(" name ")" / name
owl::TermId Parser::property() {
  if (take_keyword("inverse")) {
    const bool is_nested = take_symbol("(");
    if (!is_name()) return expected("an object property");
    const Term of = entity(TermKind::object_property, take());
    if (is_nested) expect_symbol(")", "')'");
    return failed() ? of : source_.term(TermKind::object_inverse_of, {of});
  }
  const Token name = take();
  const auto kind = kind_of_property(name);
  if (!kind) return fail(ParseError::Kind::name, name.begin, kind.error());
  return entity(*kind, name);
}

owl::TermId Parser::entity(owl::TermKind kind, const Token& token) {
  if (failed()) return owl::thing_term;
  if (++parts_ > limits_.parts) {
    return fail(ParseError::Kind::too_large, token.begin,
                "more than " + std::to_string(limits_.parts) + " names and values");
  }
  const auto iri = iri_of(kind, token);
  if (!iri) return fail(ParseError::Kind::name, token.begin, iri.error());
  return source_.entity(kind, *iri);
}

bool Parser::is_restriction_next() const {
  Tokenizer ahead = tokens_;
  ahead.advance();
  return begins_restriction(ahead.token());
}

bool Parser::is_literal() const {
  const TokenKind kind = tokens_.token().kind;
  return kind == TokenKind::string || kind == TokenKind::number || is_keyword("true") || is_keyword("false");
}

bool Parser::has_filler() const {
  return is_name() || is_symbol("(") || is_symbol("{") || is_keyword("not") || is_keyword("inverse");
}

bool Parser::is(TokenKind kind, std::string_view text) const {
  return tokens_.token().kind == kind && tokens_.token().text == text;
}

bool Parser::is_name() const {
  return tokens_.token().kind == TokenKind::name || tokens_.token().kind == TokenKind::label;
}

bool Parser::take_keyword(std::string_view word) {
  if (failed() || !is_keyword(word)) return false;
  tokens_.advance();
  return true;
}

bool Parser::take_symbol(std::string_view symbol) {
  if (failed() || !is_symbol(symbol)) return false;
  tokens_.advance();
  return true;
}

void Parser::expect_symbol(std::string_view symbol, std::string_view what) {
  if (!take_symbol(symbol)) expected(what);
}

Token Parser::take() {
  Token token = tokens_.token();
  tokens_.advance();
  return token;
}

owl::TermId Parser::expected(std::string_view what) {
  const Token& found = tokens_.token();
  if (found.kind == TokenKind::bad) return fail(ParseError::Kind::malformed, found.begin, found.value);
  return fail(ParseError::Kind::malformed, found.begin,
              "expected " + std::string(what) + ", found " +
                  (found.kind == TokenKind::end ? "the end" : "'" + base::printable(found.text) + "'"));
}

owl::TermId Parser::fail(ParseError::Kind kind, std::size_t octet, std::string text) {
  if (!problem_) problem_ = Problem{kind, octet, std::move(text)};
  return owl::thing_term;
}

}  // namespace geminga::manchester
