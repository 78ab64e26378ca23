#include "reasoning/syntax/graph/axioms/axiom_triples.hpp"

namespace geminga::graph {
namespace {

using owl::AxiomKind;
using owl::TermKind;

/// The predicate of an axiom that is one triple with its two arguments.
std::string predicate_of(AxiomKind kind) {
  switch (kind) {
    case AxiomKind::sub_class_of:
      return std::string(rdfs_sub_class_of);
    case AxiomKind::sub_data_property_of:
      return std::string(rdfs_sub_property_of);
    case AxiomKind::object_property_domain:
    case AxiomKind::data_property_domain:
      return std::string(syntax::rdfs_namespace) + "domain";
    case AxiomKind::object_property_range:
    case AxiomKind::data_property_range:
      return std::string(syntax::rdfs_namespace) + "range";
    default:
      return owl("equivalentClass");  // of a datatype and its definition
  }
}

/// The RDF class of a property with an axiom of one argument: `TransitiveProperty` for TransitiveObjectProperty.
std::string characteristic_of(AxiomKind kind) {
  std::string word(to_string(kind));
  for (const std::string_view properties : {"Object", "Data"}) {
    if (const std::size_t at = word.find(properties); at != std::string::npos) word.erase(at, properties.size());
  }
  return owl(word);
}

}  // namespace

Node owl_word(std::string_view word) { return iri(owl(word)); }

Node type_of_entity(TermKind kind) {
  switch (kind) {
    case TermKind::named_class:
      return owl_word("Class");
    case TermKind::object_property:
      return owl_word("ObjectProperty");
    case TermKind::data_property:
      return owl_word("DatatypeProperty");
    case TermKind::annotation_property:
      return owl_word("AnnotationProperty");
    case TermKind::datatype:
      return iri(std::string(syntax::rdfs_namespace) + "Datatype");
    default:
      return owl_word("NamedIndividual");
  }
}

void AxiomTriples::add(const owl::Axiom& axiom) {
  const Terms terms = axiom.arguments;
  said_.clear();
  holder_.reset();
  switch (axiom.kind) {
    case AxiomKind::declaration:
      return say(node(terms[0]), rdf_type, type_of_entity(source_.kind(terms[0])));
    case AxiomKind::equivalent_classes:
      return chained(terms, owl("equivalentClass"));
    case AxiomKind::equivalent_object_properties:
    case AxiomKind::equivalent_data_properties:
      return chained(terms, owl("equivalentProperty"));
    case AxiomKind::same_individual:
      return chained(terms, owl("sameAs"));
    case AxiomKind::disjoint_classes:
      return several(terms, "disjointWith", "AllDisjointClasses");
    case AxiomKind::disjoint_object_properties:
    case AxiomKind::disjoint_data_properties:
      return several(terms, "propertyDisjointWith", "AllDisjointProperties");
    case AxiomKind::different_individuals:
      return several(terms, "differentFrom", "AllDifferent");
    case AxiomKind::disjoint_union:
      return say(node(terms[0]), owl("disjointUnionOf"), list(terms.subspan(1)));
    case AxiomKind::has_key:
      return say(node(terms[0]), owl("hasKey"), list(terms.subspan(1)));
    case AxiomKind::sub_object_property_of:
      return sub_property(terms);
    case AxiomKind::inverse_object_properties:
      return inverse(terms);
    case AxiomKind::class_assertion:
      return say(node(terms[1]), rdf_type, node(terms[0]));
    case AxiomKind::object_property_assertion: {
      // A fact about an inverse is written as the reverse fact, because table 1 has no predicate that is a blank node.
      const bool is_inverse = source_.kind(terms[0]) == TermKind::object_inverse_of;
      const owl::TermId property = is_inverse ? source_.term(terms[0]).arguments[0] : terms[0];
      return say(node(terms[is_inverse ? 2 : 1]), source_.name_of(property), node(terms[is_inverse ? 1 : 2]));
    }
    case AxiomKind::data_property_assertion:
      return say(node(terms[1]), source_.name_of(terms[0]), node(terms[2]));
    case AxiomKind::negative_object_property_assertion:
    case AxiomKind::negative_data_property_assertion:
      return negative(axiom);
    case AxiomKind::dl_safe_rule:
      return rule(terms);
    default:
      if (terms.size() == 1) return say(node(terms[0]), rdf_type, iri(characteristic_of(axiom.kind)));
      return say(node(terms[0]), predicate_of(axiom.kind), node(terms[1]));
  }
}

void AxiomTriples::say(const Node& subject, std::string_view predicate, const Node& object) {
  link(subject, predicate, object);
  said_.push_back({subject, iri(predicate), object});
}

void AxiomTriples::link(const Node& subject, std::string_view predicate, const Node& object) {
  sink_(subject, iri(predicate), object);
}

/// EQ(T1 ... Tn) is T1 = T2, ..., Tn-1 = Tn.
void AxiomTriples::chained(Terms terms, std::string_view predicate) {
  Node before = node(terms[0]);
  for (const owl::TermId id : terms.subspan(1)) {
    Node next = node(id);
    say(before, predicate, next);
    before = std::move(next);
  }
}

/// Two members are one triple. More are a node of their own.
void AxiomTriples::several(Terms terms, std::string_view of_two, std::string_view of_more) {
  if (terms.size() == 2) return say(node(terms[0]), owl(of_two), node(terms[1]));
  const Node all = fresh();
  holder_ = all;
  link(all, rdf_type, owl_word(of_more));
  link(all, owl("members"), list(terms));
}

void AxiomTriples::negative(const owl::Axiom& axiom) {
  const bool is_of_data = axiom.kind == AxiomKind::negative_data_property_assertion;
  const Node fact = fresh();
  holder_ = fact;
  link(fact, rdf_type, owl_word("NegativePropertyAssertion"));
  link(fact, owl("sourceIndividual"), node(axiom.arguments[1]));
  link(fact, owl("assertionProperty"), node(axiom.arguments[0]));
  link(fact, owl(is_of_data ? "targetValue" : "targetIndividual"), node(axiom.arguments[2]));
}

void AxiomTriples::sub_property(Terms terms) {
  if (source_.kind(terms[0]) != TermKind::object_property_chain)
    return say(node(terms[0]), rdfs_sub_property_of, node(terms[1]));
  say(node(terms[1]), owl("propertyChainAxiom"), list(source_.term(terms[0]).arguments));
}

/// A blank subject of owl:inverseOf is an expression, so that the axiom has a name as its subject. The axiom has no
/// order, and of two inverses it says the same as of their properties.
void AxiomTriples::inverse(Terms terms) {
  const auto property = [&](owl::TermId id) {
    return source_.kind(id) == TermKind::object_inverse_of ? source_.term(id).arguments[0] : id;
  };
  const bool is_first = property(terms[0]) != terms[0];
  const bool is_second = property(terms[1]) != terms[1];
  if (is_first && is_second) return say(node(property(terms[0])), owl("inverseOf"), node(property(terms[1])));
  const Node object = node(terms[is_first ? 0 : 1]);
  say(node(terms[is_first ? 1 : 0]), owl("inverseOf"), object);
}

Node AxiomTriples::list(Terms terms) {
  Node rest = iri(std::string(syntax::rdf_namespace) + "nil");
  for (std::size_t place = terms.size(); place-- > 0;) {
    const Node item = fresh();
    link(item, std::string(syntax::rdf_namespace) + "first", node(terms[place]));
    link(item, std::string(syntax::rdf_namespace) + "rest", rest);
    rest = item;
  }
  return rest;
}

}  // namespace geminga::graph
