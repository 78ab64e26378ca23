// Expressions, literals and names as nodes. An expression is nested a bounded number of levels (owl::SourceLimits).
#include <string>

#include "reasoning/syntax/graph/axioms/axiom_triples.hpp"

namespace geminga::graph {
namespace {

using owl::TermKind;

Node typed(std::string text, std::string_view datatype) {
  return {Node::Kind::literal, std::move(text), std::string(syntax::xsd_namespace).append(datatype), {}};
}

bool is_of_data(TermKind kind) {
  return kind >= TermKind::data_some_values_from && kind <= TermKind::data_exact_cardinality;
}

}  // namespace

Node AxiomTriples::literal(const owl::Term& term) const {
  const bool has_language = term.arguments.size() == 2;
  const std::string_view datatype = source_.name_of(term.arguments[0]);
  return {Node::Kind::literal, std::string(source_.name(term.name)), std::string(has_language ? "" : datatype),
          std::string(has_language ? source_.name_of(term.arguments[1]) : "")};
}

Node AxiomTriples::described(std::string_view type, std::string_view predicate, const Node& object) {
  const Node made = fresh();
  link(made, rdf_type, type == "Datatype" ? type_of_entity(TermKind::datatype) : owl_word(type));
  link(made, owl(predicate), object);
  return made;
}

Node AxiomTriples::restriction(const owl::Term& term, std::string_view predicate, const Node& object) {
  const Node made = described("Restriction", predicate, object);
  link(made, owl("onProperty"), node(term.arguments[0]));
  return made;
}

Node AxiomTriples::cardinality(const owl::Term& term) {
  const bool is_qualified = term.arguments.size() == 2;
  std::string_view word = is_qualified ? "qualifiedCardinality" : "cardinality";
  if (term.kind == TermKind::object_min_cardinality || term.kind == TermKind::data_min_cardinality)
    word = is_qualified ? "minQualifiedCardinality" : "minCardinality";
  if (term.kind == TermKind::object_max_cardinality || term.kind == TermKind::data_max_cardinality)
    word = is_qualified ? "maxQualifiedCardinality" : "maxCardinality";
  const Node made = restriction(term, word, typed(std::to_string(term.number), "nonNegativeInteger"));
  if (is_qualified) link(made, owl(is_of_data(term.kind) ? "onDataRange" : "onClass"), node(term.arguments[1]));
  return made;
}

Node AxiomTriples::facets(const owl::Term& term) {
  const Node made = described("Datatype", "onDatatype", node(term.arguments[0]));
  Node rest = iri(std::string(syntax::rdf_namespace) + "nil");
  for (std::size_t place = term.arguments.size(); place-- > 1;) {
    const owl::Term facet = source_.term(term.arguments[place]);
    const Node holder = fresh();
    const Node item = fresh();
    link(holder, source_.name(facet.name), node(facet.arguments[0]));
    link(item, std::string(syntax::rdf_namespace) + "first", holder);
    link(item, std::string(syntax::rdf_namespace) + "rest", rest);
    rest = item;
  }
  link(made, owl("withRestrictions"), rest);
  return made;
}

Node AxiomTriples::expression(const owl::Term& term) {
  const auto argument = [&](std::size_t place) { return node(term.arguments[place]); };
  switch (term.kind) {
    case TermKind::object_inverse_of: {
      const Node made = fresh();
      link(made, owl("inverseOf"), argument(0));
      return made;
    }
    case TermKind::object_intersection_of:
      return described("Class", "intersectionOf", list(term.arguments));
    case TermKind::object_union_of:
      return described("Class", "unionOf", list(term.arguments));
    case TermKind::object_complement_of:
      return described("Class", "complementOf", argument(0));
    case TermKind::object_one_of:
      return described("Class", "oneOf", list(term.arguments));
    case TermKind::object_some_values_from:
    case TermKind::data_some_values_from:
      return restriction(term, "someValuesFrom", argument(1));
    case TermKind::object_all_values_from:
    case TermKind::data_all_values_from:
      return restriction(term, "allValuesFrom", argument(1));
    case TermKind::object_has_value:
    case TermKind::data_has_value:
      return restriction(term, "hasValue", argument(1));
    case TermKind::object_has_self:
      return restriction(term, "hasSelf", typed("true", "boolean"));
    case TermKind::data_intersection_of:
      return described("Datatype", "intersectionOf", list(term.arguments));
    case TermKind::data_union_of:
      return described("Datatype", "unionOf", list(term.arguments));
    case TermKind::data_complement_of:
      return described("Datatype", "datatypeComplementOf", argument(0));
    case TermKind::data_one_of:
      return described("Datatype", "oneOf", list(term.arguments));
    case TermKind::datatype_restriction:
      return facets(term);
    default:
      return cardinality(term);
  }
}

Node AxiomTriples::node(owl::TermId id) {
  const owl::Term term = source_.term(id);
  if (term.kind <= TermKind::individual) return iri(source_.name(term.name));
  if (term.kind == TermKind::literal) return literal(term);
  if (term.kind == TermKind::variable) return variable(term);
  if (term.kind >= TermKind::class_atom) return atom(term);
  if (term.kind != TermKind::anonymous_individual) return expression(term);
  return individual(source_.name(term.name));
}

/// The name is unique among all files.
Node AxiomTriples::individual(std::string_view name) { return blank('i' + label_of(name.substr(2))); }

}  // namespace geminga::graph
