// The end of an element: it becomes an operand of the element around it, or an axiom.
#include <algorithm>
#include <span>

#include "reasoning/owl/unit.hpp"
#include "reasoning/syntax/document/lists.hpp"
#include "reasoning/syntax/owlxml/builder.hpp"

namespace geminga::owlxml {
namespace {

using functional::Form;
using owl::TermKind;
using Wanted = functional::Operand;

}  // namespace

bool Builder::fits(Wanted wanted, const Operand& operand) const {
  if (operand.kind != Operand::Kind::term) return false;
  const TermKind kind = source_.kind(operand.term);
  switch (wanted) {
    case Wanted::none:
      return false;
    case Wanted::named_class:
      return kind == TermKind::named_class;
    case Wanted::class_expression:
      return owl::is_class_expression(kind);
    case Wanted::named_object_property:
      return kind == TermKind::object_property;
    case Wanted::object_property:
      return owl::is_object_property_expression(kind);
    case Wanted::property_chain:
      return owl::is_object_property_expression(kind) || kind == TermKind::object_property_chain;
    case Wanted::data_property:
      return kind == TermKind::data_property;
    case Wanted::datatype:
      return kind == TermKind::datatype;
    case Wanted::data_range:
      return owl::is_data_range(kind);
    case Wanted::individual:
      return owl::is_individual(kind);
    case Wanted::literal:
      return kind == TermKind::literal;
    case Wanted::facet:
      return kind == TermKind::facet;
    case Wanted::rule_argument:
      return owl::is_individual(kind) || kind == TermKind::literal || kind == TermKind::variable;
    case Wanted::atom:
      return kind >= TermKind::class_atom && kind <= TermKind::built_in_atom;
    case Wanted::body:
    case Wanted::head:
      return kind == TermKind::atom_list;
  }
  return false;
}

Listener::Refusal Builder::expected(std::string_view what, const Open& open, std::size_t place) const {
  std::string found = "the end of the element";
  if (place < operands_.size()) {
    const Operand& operand = operands_[place];
    found = operand.kind == Operand::Kind::term ? std::string(owl::to_string(source_.kind(operand.term)))
                                                : std::string("something of annotations");
  }
  return "expected " + std::string(what) + " in <" + std::string(open.production->word) + ">, found " + found;
}

Listener::Refusal Builder::check_n_ary_data(const Open& open) {
  std::size_t place = open.first;
  while (place < operands_.size() && fits(Wanted::data_property, operands_[place])) ++place;
  if (place == open.first) return expected(functional::to_string(Wanted::data_property), open, place);
  // No data range of OWL 2 has several values, so such a class is not understood.
  if (place > open.first + 1) obstacle_ = "owl:onProperties";
  if (place + 1 != operands_.size() || !fits(Wanted::data_range, operands_[place]))
    return expected(functional::to_string(Wanted::data_range), open, place);
  return std::nullopt;
}

Listener::Refusal Builder::check_operands(const Open& open) {
  const functional::Production& production = *open.production;
  std::size_t place = open.first;
  const auto has = [&](Wanted wanted) { return place < operands_.size() && fits(wanted, operands_[place]); };
  for (const Wanted wanted : production.first) {
    if (wanted == Wanted::none) break;
    if (!has(wanted)) return expected(functional::to_string(wanted), open, place);
    ++place;
  }
  if (production.optional != Wanted::none && has(production.optional)) ++place;
  if (production.repeated != Wanted::none) {
    if (place == operands_.size() && !production.may_be_empty())
      return expected(functional::to_string(production.repeated), open, place);
    for (; place < operands_.size(); ++place) {
      if (!has(production.repeated)) return expected(functional::to_string(production.repeated), open, place);
    }
  }
  return place == operands_.size() ? std::nullopt : expected("no more", open, place);
}

Listener::Refusal Builder::end_expression(const Open& open) {
  const functional::Production& production = *open.production;
  if (auto refusal = production.form == Form::n_ary_data ? check_n_ary_data(open) : check_operands(open))
    return refusal;
  std::vector<owl::TermId> arguments;
  for (std::size_t place = open.first; place < operands_.size(); ++place) arguments.push_back(operands_[place].term);
  operands_.resize(open.first);
  const owl::TermId term = production.repeated != Wanted::none
                               ? document::term_of_list(source_, production.term(), arguments, file_, open.line)
                               : source_.term(production.term(), arguments, open.number);
  operands_.push_back({Operand::Kind::term, term, {}, {}, {}, {}});
  return std::nullopt;
}

Listener::Refusal Builder::end_part_of_rule(const Open& open) {
  const functional::Production& production = *open.production;
  const Wanted wanted = production.form == Form::atoms ? Wanted::atom : Wanted::rule_argument;
  std::vector<owl::TermId> arguments;
  for (std::size_t place = open.first; place < operands_.size(); ++place) {
    if (production.form == Form::variable) return expected("no more", open, place);
    if (!fits(wanted, operands_[place])) return expected(functional::to_string(wanted), open, place);
    arguments.push_back(operands_[place].term);
  }
  operands_.resize(open.first);
  const owl::TermId term = source_.copy(production.term(), open.name, 0, arguments);
  operands_.push_back({Operand::Kind::term, term, {}, {}, {}, {}});
  return std::nullopt;
}

void Builder::drop_annotations(const Open& open) {
  const auto first = operands_.begin() + static_cast<std::ptrdiff_t>(open.first);
  operands_.erase(std::remove_if(first, operands_.end(),
                                 [](const Operand& operand) { return operand.kind == Operand::Kind::annotation; }),
                  operands_.end());
}

void Builder::add(owl::AxiomKind kind, const Open& open) {
  if (obstacle_ != nullptr) {
    source_.leave_out(obstacle_, file_, open.line);
    return annotations_.drop();
  }
  std::vector<owl::TermId> arguments;
  for (std::size_t place = open.first; place < operands_.size(); ++place) arguments.push_back(operands_[place].term);
  const std::size_t before = source_.axiom_count();
  const std::size_t ill_typed = source_.ill_typed_count();
  source_.add(kind, arguments, file_, open.line);
  document_.axioms += source_.axiom_count() - before;
  annotations_.attach(source_, before, ill_typed);
}

void Builder::add_list_or_other(const Open& open) {
  const functional::Production& production = *open.production;
  const std::size_t count = operands_.size() - open.first;
  if (production.repeated == Wanted::none || obstacle_ != nullptr) return add(production.axiom(), open);
  if (production.axiom() == owl::AxiomKind::disjoint_union) {
    if (count > 1) return add(production.axiom(), open);
    document::add_empty_union(source_, operands_.back().term, file_, open.line);
    ++document_.axioms;
    return annotations_.drop();
  }
  if (!document::says_nothing(source_, production.axiom(), count, file_, open.line))
    return add(production.axiom(), open);
  ++document_.vacuous;
  annotations_.drop();
}

Listener::Refusal Builder::end_axiom(const Open& open) {
  drop_annotations(open);
  const functional::Production& production = *open.production;
  const std::size_t count = operands_.size() - open.first;
  Refusal refusal;
  switch (production.form) {
    case Form::declaration: {
      const bool is_entity = count == 1 && operands_.back().kind == Operand::Kind::term &&
                             source_.kind(operands_.back().term) <= TermKind::individual;
      if (!is_entity) return expected("one name", open, open.first);
      if (declared_.insert(operands_.back().term).second) {
        add(owl::AxiomKind::declaration, open);
      } else {
        annotations_.drop();
      }
      break;
    }
    case Form::has_key:
      for (std::size_t place = open.first; place < operands_.size() && !refusal; ++place) {
        const Wanted property =
            fits(Wanted::data_property, operands_[place]) ? Wanted::data_property : Wanted::object_property;
        const Wanted wanted = place == open.first ? Wanted::class_expression : property;
        if (!fits(wanted, operands_[place])) refusal = expected("a class, then properties", open, place);
      }
      if (count == 0) return expected("a class, then properties", open, open.first);
      if (!refusal) add(owl::AxiomKind::has_key, open);
      break;
    case Form::annotation_assertion:
      refusal = end_annotation_assertion(open);
      break;
    case Form::annotation_axiom:
      if (count != 2) return expected("two names", open, open.first);
      ++document_.annotations;
      if (operands_[open.first].kind != Operand::Kind::iri) break;
      keep(owl::annotation_of(operands_[open.first].iri, owl::property_of_annotation_axiom(production.word)),
           operands_[open.first + 1], 0);
      break;
    default:
      refusal = check_operands(open);
      if (refusal) break;
      add_list_or_other(open);
      break;
  }
  operands_.resize(open.first);
  return refusal;
}

void Builder::keep(owl::Annotation annotation, const Operand& value, std::size_t level) {
  if (!annotations_.is_wanted()) return;
  annotation.is_literal = value.kind == Operand::Kind::text;
  annotation.value = annotation.is_literal ? value.text : value.iri;
  annotation.datatype = value.datatype;
  annotation.language = value.language;
  annotations_.add(std::move(annotation), level);
}

// A property, then a value, with annotations of the annotation before or behind them.
Listener::Refusal Builder::end_annotation(const Open& open) {
  drop_annotations(open);
  const bool is_whole = operands_.size() == open.first + 2 && operands_[open.first].kind == Operand::Kind::iri;
  if (!is_whole) return expected("an annotation property and a value", open, open.first);
  const bool is_cost = operands_[open.first].iri == owl::conversion_cost;
  if (is_cost && operands_[open.first + 1].kind == Operand::Kind::text)
    names_.set_cost(operands_[open.first + 1].text, open.line);
  owl::Annotation read = owl::annotation_of({}, operands_[open.first].iri);
  if (open_.size() == 1) {
    read.of = owl::Annotation::Of::ontology;
    read.number = static_cast<std::uint32_t>(file_);
  }
  const bool is_in_axiom = open_.size() > 1 && form_of(open_[1]) != Form::annotation;
  keep(std::move(read), operands_[open.first + 1], open_.size() - (is_in_axiom ? 1 : 0));
  operands_.resize(open.first);
  ++document_.annotations;
  // An annotation of the ontology is no operand.
  if (open_.size() > 1) operands_.push_back({Operand::Kind::annotation, {}, {}, {}, {}, {}});
  return std::nullopt;
}

Listener::Refusal Builder::end_annotation_assertion(const Open& open) {
  const std::span<const Operand> of = std::span<const Operand>(operands_).subspan(open.first);
  const bool is_whole = of.size() == 3 && of[0].kind == Operand::Kind::iri && of[1].kind == Operand::Kind::iri;
  if (!is_whole) return expected("an annotation property, a subject and a value", open, open.first);
  ++document_.annotations;
  using ValueForm = document::AnnotationValue::Form;
  const bool is_text = of[2].kind == Operand::Kind::text;
  const ValueForm form = is_text ? ValueForm::text : of[2].iri.starts_with("_:") ? ValueForm::blank : ValueForm::iri;
  names_.add(of[0].iri, of[1].iri, {form, is_text ? of[2].text : of[2].iri, of[2].language}, open.line);
  keep(owl::annotation_of(of[1].iri, of[0].iri), of[2], 0);
  return std::nullopt;
}

}  // namespace geminga::owlxml
