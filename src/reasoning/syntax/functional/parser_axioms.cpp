// Axioms: an opening bracket, annotations, operands by the table of the grammar, a closing bracket.
#include "reasoning/syntax/document/lists.hpp"
#include "reasoning/syntax/functional/parser.hpp"

namespace geminga::functional {

using owl::AxiomKind;

bool Parser::axiom() {
  const Production* production = tokens_.is(TokenKind::word) ? find_production(tokens_.token().text) : nullptr;
  const bool is_axiom = production != nullptr && production->form >= Form::axiom;
  if (!is_axiom) return expected("an axiom, or ')' at the end of the ontology");
  const std::uint32_t line = tokens_.line();
  tokens_.advance();
  if (!expect(TokenKind::open, "'('")) return false;
  terms_.clear();
  obstacle_ = nullptr;
  names_.forget_cost();
  annotations_.begin();
  if (production->form == Form::extension) return extension(production->word, line);
  if (!annotations() || !axiom_operands(*production)) return false;
  if (!expect(TokenKind::close, "')' behind the operands")) return false;
  switch (production->form) {
    case Form::declaration:
      declare(line);
      break;
    case Form::has_key:
      add(AxiomKind::has_key, line);
      break;
    case Form::axiom:
      add_list_or_other(*production, line);
      break;
    default:
      ++document_.annotations;
      break;
  }
  return true;
}

bool Parser::axiom_operands(const Production& production) {
  switch (production.form) {
    case Form::declaration:
      return declaration();
    case Form::has_key:
      return operand(Operand::class_expression) && bracketed(Operand::object_property) &&
             bracketed(Operand::data_property);
    case Form::annotation_assertion:
      return annotation_assertion();
    case Form::annotation_axiom:
      return annotation_axiom(production.word);
    default:
      return operands(production);
  }
}

bool Parser::declaration() {
  const Production* production = tokens_.is(TokenKind::word) ? find_production(tokens_.token().text) : nullptr;
  if (production == nullptr || production->form != Form::entity)
    return expected("Class, Datatype, ObjectProperty, DataProperty, AnnotationProperty or NamedIndividual");
  tokens_.advance();
  return expect(TokenKind::open, "'('") && entity(production->term(), "an IRI") &&
         expect(TokenKind::close, "')' behind the declared name");
}

bool Parser::bracketed(Operand wanted) {
  if (!expect(TokenKind::open, "'(' before the properties of a key")) return false;
  if (!tokens_.is(TokenKind::close) && !repeated(wanted)) return false;
  return expect(TokenKind::close, "')' behind the properties of a key");
}

bool Parser::extension(std::string_view construct, std::uint32_t line) {
  for (std::uint64_t open = 1; open != 0; tokens_.advance()) {
    if (tokens_.is(TokenKind::end)) return expected("')'");
    if (tokens_.is(TokenKind::failed)) return false;
    if (tokens_.is(TokenKind::open)) ++open;
    if (tokens_.is(TokenKind::close)) --open;
  }
  source_.leave_out(construct, file_, line);
  return true;
}

void Parser::declare(std::uint32_t line) {
  const auto entity = static_cast<std::size_t>(terms_.front());
  if (entity >= declared_.size()) declared_.resize(entity * 2 + 64);
  if (declared_[entity]) return annotations_.drop();
  declared_[entity] = true;
  add(AxiomKind::declaration, line);
}

void Parser::add_list_or_other(const Production& production, std::uint32_t line) {
  if (production.repeated == Operand::none || obstacle_ != nullptr) return add(production.axiom(), line);
  if (production.axiom() == AxiomKind::disjoint_union) {
    if (terms_.size() > 1) return add(production.axiom(), line);
    document::add_empty_union(source_, terms_.front(), file_, line);
    ++document_.axioms;
    return annotations_.drop();
  }
  if (!document::says_nothing(source_, production.axiom(), terms_.size(), file_, line))
    return add(production.axiom(), line);
  ++document_.vacuous;
  annotations_.drop();
}

void Parser::add(owl::AxiomKind kind, std::uint32_t line) {
  if (obstacle_ != nullptr) {
    source_.leave_out(obstacle_, file_, line);
    return annotations_.drop();
  }
  const std::size_t before = source_.axiom_count();
  const std::size_t ill_typed = source_.ill_typed_count();
  source_.add(kind, terms_, file_, line);
  document_.axioms += source_.axiom_count() - before;
  annotations_.attach(source_, before, ill_typed);
}

}  // namespace geminga::functional
