// Rules of SWRL, as the OWL API writes them in Manchester syntax. The grammar stands above each function.

#include <array>
#include <utility>
#include <vector>

#include "base/text.hpp"
#include "reasoning/owl/datatypes.hpp"
#include "reasoning/syntax/frames/parser.hpp"

namespace geminga::frames {

using manchester::ParseError;
using manchester::Token;
using manchester::Tokenizer;
using manchester::TokenKind;
using owl::AxiomKind;
using owl::TermKind;

namespace {

constexpr std::string_view swrl_variables = "urn:swrl:var#";
constexpr std::string_view swrl_built_ins = "http://www.w3.org/2003/11/swrlb#";

}  // namespace

// rule = "Rule:" [ annotations ] [ atoms ] "->" [ atoms ]
//
// A rule in other words is left out by name: the grammar of rules is in no recommendation.
void Parser::rule() {
  const std::uint32_t line = this->line();
  const Tokenizer begin = tokens_;
  take();
  annotations();
  const Term body = atoms();
  if (!take_symbol("->")) expected("',' or '->'");
  const Term head = atoms();
  if (!failed() && !is_section() && tokens_.token().kind != TokenKind::end) expected("',' or the end of the rule");
  if (!failed()) return add(AxiomKind::dl_safe_rule, std::array{body, head}, line);
  annotations_.drop();
  if (problem()->kind == ParseError::Kind::too_large || is_endless_text()) return;
  problem_.reset();
  tokens_ = begin;
  skip_rule(line);
}

void Parser::skip_rule(std::uint32_t line) {
  source_.leave_out("swrl:Imp", file_, line);
  take();
  while (!failed() && !is_section() && tokens_.token().kind != TokenKind::end) {
    if (is_endless_text()) {
      expected("a rule");
      return;
    }
    take();
  }
}

// atoms = atom *( "," atom )
owl::TermId Parser::atoms() {
  std::vector<Term> parts;
  const bool is_empty = is_symbol("->") || is_section() || tokens_.token().kind == TokenKind::end;
  if (!is_empty) {
    do {
      parts.push_back(atom());
    } while (!failed() && take_comma());
  }
  return failed() ? owl::thing_term : source_.term(TermKind::atom_list, parts);
}

// atom = ( name / primary / dataPrimary / "inverse" name ) "(" [ argument *( "," argument ) ] ")"
owl::TermId Parser::atom() {
  if (failed()) return owl::thing_term;
  Tokenizer behind = tokens_;
  behind.advance();
  const bool is_applied = behind.token().kind == TokenKind::symbol && behind.token().text == "(";
  if (is_name() && is_applied) {
    const Token predicate = take();
    return named_atom(predicate, rule_arguments());
  }
  const bool is_inverse = is_keyword("inverse");
  const bool is_range = !is_inverse && is_value_of_data(tokens_);
  const Term predicate = is_inverse ? property() : is_range ? data_primary() : primary();
  std::vector<Term> arguments = rule_arguments();
  const TermKind kind = is_inverse ? TermKind::object_property_atom
                        : is_range ? TermKind::data_range_atom
                                   : TermKind::class_atom;
  return made_atom(kind, predicate, arguments);
}

std::vector<owl::TermId> Parser::rule_arguments() {
  std::vector<Term> arguments;
  expect_symbol("(", "'('");
  while (!failed() && !is_symbol(")")) {
    arguments.push_back(rule_argument());
    if (!take_comma()) break;
  }
  expect_symbol(")", "',' or ')'");
  return arguments;
}

// argument = "?" ( word / "<" IRI ">" ) / literal / individual
owl::TermId Parser::rule_argument() {
  if (failed()) return owl::thing_term;
  if (is_literal()) return literal();
  const Token token = tokens_.token();
  if (token.kind != TokenKind::name || !token.text.starts_with('?')) return individual();
  if (++parts_ > limits_.parts)
    return fail(ParseError::Kind::too_large, token.begin,
                "more than " + std::to_string(limits_.parts) + " names and values");
  take();
  if (token.text.size() > 1)
    return source_.entity(TermKind::variable, std::string(swrl_variables) += token.text.substr(1));
  const std::string name = tokens_.token().text.starts_with('<') ? iri("the name of a variable") : std::string();
  return name.empty() ? expected("the name of a variable behind '?'") : source_.entity(TermKind::variable, name);
}

/// The kind of an atom follows from the declaration of its predicate and the number of arguments. A name with two of
/// them that is declared nowhere is taken for a built-in, which nobody knows: as a property it would be one without
/// facts.
owl::TermId Parser::named_atom(const Token& predicate, const std::vector<Term>& arguments) {
  if (failed()) return owl::thing_term;
  if (predicate.text == "SameAs" || predicate.text == "DifferentFrom") {
    const bool is_same = predicate.text == "SameAs";
    return source_.term(is_same ? TermKind::same_individual_atom : TermKind::different_individuals_atom, arguments);
  }
  if (arguments.size() == 1) {
    const bool is_range = names_datatype(predicate);
    return made_atom(is_range ? TermKind::data_range_atom : TermKind::class_atom,
                     entity(is_range ? TermKind::datatype : TermKind::named_class, predicate), arguments);
  }
  const auto name = iri_of(TermKind::object_property, predicate);
  if (!name) return fail(ParseError::Kind::name, predicate.begin, name.error());
  const bool is_object = declared_.has(TermKind::object_property, *name) || *name == owl::owl_top_object_property;
  const bool is_data = declared_.has(TermKind::data_property, *name) || *name == owl::owl_top_data_property;
  if (arguments.size() != 2 || name->starts_with(swrl_built_ins) || (!is_object && !is_data))
    return source_.built_in(*name, arguments);
  const bool is_of_data = is_data && (!is_object || source_.kind(arguments[1]) == TermKind::literal);
  return made_atom(is_of_data ? TermKind::data_property_atom : TermKind::object_property_atom,
                   entity(is_of_data ? TermKind::data_property : TermKind::object_property, predicate), arguments);
}

owl::TermId Parser::made_atom(TermKind kind, Term predicate, std::vector<Term> arguments) {
  if (failed()) return owl::thing_term;
  arguments.insert(arguments.begin(), predicate);
  return source_.term(kind, arguments);
}

}  // namespace geminga::frames
