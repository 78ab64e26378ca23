// Rules as triples of SWRL (W3C member submission of 21 May 2004, section 5).
#include "reasoning/syntax/graph/axioms/axiom_triples.hpp"

namespace geminga::graph {
namespace {

using owl::TermKind;

std::string swrl(std::string_view word) { return std::string(syntax::swrl_namespace).append(word); }

std::string_view type_of_atom(TermKind kind) {
  switch (kind) {
    case TermKind::class_atom:
      return "ClassAtom";
    case TermKind::data_range_atom:
      return "DataRangeAtom";
    case TermKind::object_property_atom:
      return "IndividualPropertyAtom";
    case TermKind::data_property_atom:
      return "DatavaluedPropertyAtom";
    case TermKind::same_individual_atom:
      return "SameIndividualAtom";
    case TermKind::different_individuals_atom:
      return "DifferentIndividualsAtom";
    default:
      return "BuiltinAtom";
  }
}

std::string_view predicate_of_atom(TermKind kind) {
  switch (kind) {
    case TermKind::class_atom:
      return "classPredicate";
    case TermKind::data_range_atom:
      return "dataRange";
    default:
      return "propertyPredicate";
  }
}

}  // namespace

void AxiomTriples::rule(Terms parts) {
  const Node rule = fresh();
  holder_ = rule;
  link(rule, rdf_type, iri(swrl("Imp")));
  link(rule, swrl("body"), list(source_.term(parts[0]).arguments));
  link(rule, swrl("head"), list(source_.term(parts[1]).arguments));
}

Node AxiomTriples::variable(const owl::Term& term) {
  const std::string_view name = source_.name(term.name);
  const Node made = name.starts_with("_:") ? individual(name) : iri(name);
  link(made, rdf_type, iri(swrl("Variable")));
  return made;
}

Node AxiomTriples::atom(const owl::Term& term) {
  const Node made = fresh();
  link(made, rdf_type, iri(swrl(type_of_atom(term.kind))));
  if (term.kind == TermKind::built_in_atom) {
    link(made, swrl("builtin"), iri(source_.name(term.name)));
    link(made, swrl("arguments"), list(term.arguments));
    return made;
  }
  const bool is_about_identity =
      term.kind == TermKind::same_individual_atom || term.kind == TermKind::different_individuals_atom;
  if (!is_about_identity) link(made, swrl(predicate_of_atom(term.kind)), node(term.arguments[0]));
  const Terms about = term.arguments.subspan(is_about_identity ? 0 : 1);
  link(made, swrl("argument1"), node(about[0]));
  if (about.size() > 1) link(made, swrl("argument2"), node(about[1]));
  return made;
}

}  // namespace geminga::graph
