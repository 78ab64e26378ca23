// One function a form of atom.
#include "reasoning/syntax/rdf/mapping/rule_mapper.hpp"

#include <string>
#include <vector>

namespace geminga::rdf {

using owl::TermKind;
using syntax::Word;

void RuleMapper::map_all() {
  for (std::uint32_t number = 0; number < graph_.triple_count(); ++number) {
    const Triple& triple = graph_.triple(number);
    const bool is_type = triple.predicate == node_of(Word::rdf_type);
    if (!is_type || triple.object != node_of(Word::swrl_imp) || triples_.is_used(number)) continue;
    // A type that is stated twice says nothing more.
    for (const std::uint32_t about : graph_.about(triple.subject, Word::rdf_type)) triples_.use(about);
    const Mapped body = atoms(triple.subject, Word::swrl_body);
    const Mapped head = atoms(triple.subject, Word::swrl_head);
    axioms_.add(number, owl::AxiomKind::dl_safe_rule, {body, head});
    // Other statements about a rule without a name are its annotations and no facts, whatever their property is.
    if (graph_.is_blank(triple.subject)) use_all(triple.subject);
  }
}

Mapped RuleMapper::atoms(NodeId rule, Word part) {
  const NodeId head = triples_.object_of(rule, part);
  if (head == NodeId{}) return std::unexpected("a broken swrl:Imp");
  const MappedList members = triples_.terms(head, [this](NodeId node) { return atom(node); });
  if (!members) return std::unexpected(members.error());
  return ontology_.term(TermKind::atom_list, *members);
}

void RuleMapper::use_all(NodeId node) {
  for (const std::uint32_t about : graph_.about(node)) triples_.use(about);
}

Mapped RuleMapper::atom(NodeId node) {
  const auto is = [&](Word type) { return graph_.has(node, node_of(Word::rdf_type), node_of(type)); };
  const auto object = [&](Word predicate) { return triples_.object_of(node, predicate); };
  const NodeId first = object(Word::swrl_argument1);
  const NodeId second = object(Word::swrl_argument2);
  Mapped result = std::unexpected("a broken atom of a swrl:Imp");
  if (is(Word::swrl_builtin_atom)) {
    result = built_in(node);
  } else if (first == NodeId{}) {
    return result;
  } else if (is(Word::swrl_class_atom)) {
    const NodeId of = object(Word::swrl_class_predicate);
    if (of != NodeId{}) result = term(TermKind::class_atom, {expressions_.class_expression(of), argument(first)});
  } else if (is(Word::swrl_data_range_atom)) {
    const NodeId of = object(Word::swrl_data_range);
    if (of != NodeId{}) result = term(TermKind::data_range_atom, {ranges_.data_range(of), argument(first)});
  } else if (second == NodeId{}) {
    return result;
  } else if (is(Word::swrl_same_individual_atom)) {
    result = term(TermKind::same_individual_atom, {argument(first), argument(second)});
  } else if (is(Word::swrl_different_individuals_atom)) {
    result = term(TermKind::different_individuals_atom, {argument(first), argument(second)});
  } else if (is(Word::swrl_individual_property_atom) || is(Word::swrl_datavalued_property_atom)) {
    result = property_atom(node, is(Word::swrl_datavalued_property_atom));
  }
  use_all(node);
  return result;
}

// The declaration of the property decides if it has one, because tools confuse the two forms.
Mapped RuleMapper::property_atom(NodeId node, bool is_of_data) {
  const NodeId property = triples_.object_of(node, Word::swrl_property_predicate);
  if (property == NodeId{}) return std::unexpected("a broken atom of a swrl:Imp");
  if (types_.is_object_property(property) != types_.is_data_property(property))
    is_of_data = types_.is_data_property(property);
  const Mapped first = argument(triples_.object_of(node, Word::swrl_argument1));
  const Mapped second = argument(triples_.object_of(node, Word::swrl_argument2));
  if (is_of_data) return term(TermKind::data_property_atom, {expressions_.data_property(property), first, second});
  return term(TermKind::object_property_atom, {expressions_.object_property(property), first, second});
}

Mapped RuleMapper::built_in(NodeId node) {
  const NodeId name = triples_.object_of(node, Word::swrl_builtin);
  const NodeId head = triples_.object_of(node, Word::swrl_arguments);
  if (name == NodeId{} || !graph_.is_iri(name) || head == NodeId{})
    return std::unexpected("a broken atom of a swrl:Imp");
  const MappedList arguments = triples_.terms(head, [this](NodeId member) { return argument(member); });
  if (!arguments) return std::unexpected(arguments.error());
  return ontology_.built_in(graph_.text(name), *arguments);
}

Mapped RuleMapper::term(TermKind kind, std::initializer_list<Mapped> arguments) {
  std::vector<owl::TermId> terms;
  for (const Mapped& argument : arguments) {
    if (!argument) return argument;
    terms.push_back(*argument);
  }
  return ontology_.term(kind, terms);
}

Mapped RuleMapper::argument(NodeId node) {
  if (graph_.is_literal(node)) return ranges_.literal(node);
  const bool is_variable = graph_.has(node, node_of(Word::rdf_type), node_of(Word::swrl_variable));
  if (!is_variable) return expressions_.individual(node);
  if (graph_.is_iri(node)) return ontology_.entity(TermKind::variable, graph_.text(node));
  const Mapped blank = expressions_.individual(node);
  if (!blank) return blank;
  return ontology_.entity(TermKind::variable, std::string(ontology_.name_of(*blank)));
}

}  // namespace geminga::rdf
