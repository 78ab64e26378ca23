// Expressions of classes, properties and data ranges, by the table of the grammar.
#include <algorithm>

#include "base/text.hpp"
#include "reasoning/syntax/document/lists.hpp"
#include "reasoning/syntax/functional/parser.hpp"

namespace geminga::functional {

using owl::TermKind;

bool Parser::operand(Operand wanted) {
  switch (wanted) {
    case Operand::named_class:
      return entity(TermKind::named_class, to_string(wanted));
    case Operand::named_object_property:
      return entity(TermKind::object_property, to_string(wanted));
    case Operand::data_property:
      return entity(TermKind::data_property, to_string(wanted));
    case Operand::datatype:
      return entity(TermKind::datatype, to_string(wanted));
    case Operand::individual:
      return individual(to_string(wanted));
    case Operand::class_expression:
      return is_name() ? entity(TermKind::named_class, to_string(wanted)) : expression(wanted);
    case Operand::object_property:
    case Operand::property_chain:
      return is_name() ? entity(TermKind::object_property, to_string(wanted)) : expression(wanted);
    case Operand::data_range:
      return is_name() ? entity(TermKind::datatype, to_string(wanted)) : expression(wanted);
    case Operand::literal:
      if (!literal()) return false;
      terms_.push_back(source_.literal(lexical_, iri_, language_));
      return true;
    case Operand::facet:
      return facet();
    case Operand::rule_argument:
      if (tokens_.is(TokenKind::word)) return expression(wanted);
      return operand(is_name() || tokens_.is(TokenKind::node_id) ? Operand::individual : Operand::literal);
    case Operand::atom:
    case Operand::body:
    case Operand::head:
      return expression(wanted);
    case Operand::none:
      break;
  }
  return true;
}

bool Parser::operands(const Production& production) {
  for (const Operand wanted : production.first) {
    if (wanted == Operand::none) break;
    if (!operand(wanted)) return false;
  }
  if (production.optional != Operand::none && !tokens_.is(TokenKind::close)) return operand(production.optional);
  if (production.repeated == Operand::none) return true;
  return (tokens_.is(TokenKind::close) && production.may_be_empty()) || repeated(production.repeated);
}

bool Parser::repeated(Operand wanted) {
  std::size_t count = 0;
  do {
    if (++count > limits_.operands) return too_many_operands();
    if (!operand(wanted)) return false;
  } while (!tokens_.is(TokenKind::close));
  return true;
}

bool Parser::too_many_operands() {
  tokens_.fail("more than " + std::to_string(limits_.operands) + " operands");
  return false;
}

bool Parser::descend() {
  if (depth_ >= limits_.nesting) {
    tokens_.fail("more than " + std::to_string(limits_.nesting) + " levels of nesting");
    return false;
  }
  ++depth_;
  return true;
}

bool Parser::expression(Operand wanted) {
  const Production* production = tokens_.is(TokenKind::word) ? find_production(tokens_.token().text) : nullptr;
  const bool fits =
      production != nullptr && (production->result == wanted ||
                                (wanted == Operand::property_chain && production->result == Operand::object_property));
  if (!fits) return expected(to_string(wanted));
  if (!descend()) return false;
  const std::uint32_t line = tokens_.line();
  tokens_.advance();
  if (!expect(TokenKind::open, "'('")) return false;
  std::uint32_t number = 0;
  if (production->is_counted && !counted(number)) return false;
  const std::size_t base = terms_.size();
  std::string name;
  const bool is_read = production->form == Form::n_ary_data   ? n_ary_data()
                       : production->form == Form::expression ? operands(*production)
                                                              : rule_operands(*production, name);
  --depth_;
  if (!is_read || !expect(TokenKind::close, "')' behind the operands")) return false;
  const auto arguments = std::span<const owl::TermId>(terms_).subspan(base);
  owl::TermId term{};
  if (production->form != Form::expression && production->form != Form::n_ary_data) {
    term = source_.copy(production->term(), name, 0, arguments);
  } else if (production->repeated != Operand::none) {
    term = document::term_of_list(source_, production->term(), arguments, file_, line);
  } else {
    term = source_.term(production->term(), arguments, number);
  }
  terms_.resize(base);
  terms_.push_back(term);
  return true;
}

bool Parser::rule_operands(const Production& production, std::string& name) {
  const Operand repeated = production.form == Form::atoms ? Operand::atom : Operand::rule_argument;
  if (production.form != Form::atoms) {
    if (!iri(production.form == Form::variable ? "the IRI of a variable" : "the IRI of a built-in")) return false;
    name = iri_;
  }
  return production.form == Form::variable || tokens_.is(TokenKind::close) || this->repeated(repeated);
}

bool Parser::counted(std::uint32_t& number) {
  if (!tokens_.is(TokenKind::number)) return expected("a number");
  std::string_view digits = tokens_.token().text;
  digits.remove_prefix(std::min(digits.find_first_not_of('0'), digits.size() - 1));
  const auto parsed = base::parse_number<std::uint32_t>(digits);
  if (!parsed) obstacle_ = "a cardinality above 4294967295";
  number = parsed.value_or(0);
  tokens_.advance();
  return true;
}

bool Parser::n_ary_data() {
  if (!operand(Operand::data_property)) return false;
  for (std::size_t properties = 1; is_name(); ++properties) {
    if (!iri(to_string(Operand::data_range))) return false;
    if (tokens_.is(TokenKind::close)) {
      terms_.push_back(source_.datatype(iri_));
      return true;
    }
    // The term before was one more property. No data range of OWL 2 has several values, so that no axiom can express
    // it.
    obstacle_ = "owl:onProperties";
    if (properties >= limits_.operands) return too_many_operands();
  }
  return operand(Operand::data_range);
}

bool Parser::facet() {
  if (!iri("the IRI of a facet")) return false;
  const std::string facet_iri(iri_);
  if (!operand(Operand::literal)) return false;
  terms_.back() = source_.facet(facet_iri, terms_.back());
  return true;
}

}  // namespace geminga::functional
