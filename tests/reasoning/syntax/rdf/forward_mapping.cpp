// One function a kind of thing, each after its rows in table 1. Written from the recommendation, not from the reader.
#include "reasoning/syntax/rdf/forward_mapping.hpp"

#include <span>
#include <string_view>

#include "reasoning/syntax/vocabulary.hpp"

namespace geminga::rdf {
namespace {

using owl::AxiomKind;
using owl::TermKind;

std::string in_brackets(std::string_view iri) { return '<' + std::string(iri) + '>'; }
std::string rdf_word(std::string_view word) { return in_brackets(std::string(syntax::rdf_namespace).append(word)); }
std::string rdfs_word(std::string_view word) { return in_brackets(std::string(syntax::rdfs_namespace).append(word)); }
std::string owl_word(std::string_view word) { return in_brackets(std::string(syntax::owl_namespace).append(word)); }

class Writer {
 public:
  explicit Writer(const owl::Ontology& source) : source_(source) {}

  std::vector<std::string> take() { return std::move(lines_); }

  void axiom(const owl::Axiom& axiom, bool is_annotated) {
    const std::span<const owl::TermId> terms = axiom.arguments;
    switch (axiom.kind) {
      case AxiomKind::declaration:
        return main(term(terms[0]), rdf_word("type"), kind_of_entity(source_.kind(terms[0])), is_annotated);
      case AxiomKind::disjoint_classes:
        return several(terms, "disjointWith", "AllDisjointClasses", is_annotated);
      case AxiomKind::disjoint_object_properties:
      case AxiomKind::disjoint_data_properties:
        return several(terms, "propertyDisjointWith", "AllDisjointProperties", is_annotated);
      case AxiomKind::different_individuals:
        return several(terms, "differentFrom", "AllDifferent", is_annotated);
      case AxiomKind::disjoint_union:
        return main(term(terms[0]), owl_word("disjointUnionOf"), list(terms.subspan(1)), is_annotated);
      case AxiomKind::has_key:
        return main(term(terms[0]), owl_word("hasKey"), list(terms.subspan(1)), is_annotated);
      case AxiomKind::sub_object_property_of:
        if (source_.kind(terms[0]) == TermKind::object_property_chain)
          return main(term(terms[1]), owl_word("propertyChainAxiom"), list(source_.term(terms[0]).arguments),
                      is_annotated);
        return main(term(terms[0]), rdfs_word("subPropertyOf"), term(terms[1]), is_annotated);
      case AxiomKind::class_assertion:
        return main(term(terms[1]), rdf_word("type"), term(terms[0]), is_annotated);
      case AxiomKind::object_property_assertion:
      case AxiomKind::data_property_assertion:
        return main(term(terms[1]), term(terms[0]), term(terms[2]), is_annotated);
      case AxiomKind::negative_object_property_assertion:
      case AxiomKind::negative_data_property_assertion:
        return negative(axiom, is_annotated);
      default:
        if (terms.size() == 1) return main(term(terms[0]), rdf_word("type"), characteristic(axiom.kind), is_annotated);
        return main(term(terms[0]), binary(axiom.kind), term(terms[1]), is_annotated);
    }
  }

 private:
  void triple(const std::string& subject, const std::string& predicate, const std::string& object) {
    lines_.push_back(subject + ' ' + predicate + ' ' + object + " .");
  }
  std::string fresh() { return "_:n" + std::to_string(++blanks_); }

  void main(const std::string& subject, const std::string& predicate, const std::string& object, bool is_annotated) {
    triple(subject, predicate, object);
    if (!is_annotated) return;
    const std::string node = fresh();
    triple(node, rdf_word("type"), owl_word("Axiom"));
    triple(node, owl_word("annotatedSource"), subject);
    triple(node, owl_word("annotatedProperty"), predicate);
    triple(node, owl_word("annotatedTarget"), object);
    triple(node, "<http://e/note>", "\"why\"");
  }

  /// Two are a triple, more are a node of their own.
  void several(std::span<const owl::TermId> terms, std::string_view of_two, std::string_view of_more,
               bool is_annotated) {
    if (terms.size() == 2) return main(term(terms[0]), owl_word(of_two), term(terms[1]), is_annotated);
    const std::string node = fresh();
    triple(node, rdf_word("type"), owl_word(of_more));
    triple(node, owl_word("members"), list(terms));
    if (is_annotated) triple(node, "<http://e/note>", "\"why\"");
  }

  void negative(const owl::Axiom& axiom, bool is_annotated) {
    const bool is_of_data = axiom.kind == AxiomKind::negative_data_property_assertion;
    const std::string node = fresh();
    triple(node, rdf_word("type"), owl_word("NegativePropertyAssertion"));
    triple(node, owl_word("sourceIndividual"), term(axiom.arguments[1]));
    triple(node, owl_word("assertionProperty"), term(axiom.arguments[0]));
    triple(node, owl_word(is_of_data ? "targetValue" : "targetIndividual"), term(axiom.arguments[2]));
    if (is_annotated) triple(node, "<http://e/note>", "\"why\"");
  }

  std::string list(std::span<const owl::TermId> terms) {
    std::string rest = rdf_word("nil");
    for (std::size_t place = terms.size(); place-- > 0;) {
      const std::string node = fresh();
      triple(node, rdf_word("first"), term(terms[place]));
      triple(node, rdf_word("rest"), rest);
      rest = node;
    }
    return rest;
  }

  static std::string kind_of_entity(TermKind kind) {
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
        return rdfs_word("Datatype");
      default:
        return owl_word("NamedIndividual");
    }
  }

  static std::string characteristic(AxiomKind kind) {
    const std::string_view word = to_string(kind);  // "TransitiveObjectProperty", "FunctionalDataProperty"
    const std::size_t end = word.ends_with("ObjectProperty") ? word.size() - 14 : word.size() - 12;
    return owl_word(std::string(word.substr(0, end)) + "Property");
  }

  static std::string binary(AxiomKind kind) {
    switch (kind) {
      case AxiomKind::sub_class_of:
        return rdfs_word("subClassOf");
      case AxiomKind::sub_data_property_of:
        return rdfs_word("subPropertyOf");
      case AxiomKind::equivalent_object_properties:
      case AxiomKind::equivalent_data_properties:
        return owl_word("equivalentProperty");
      case AxiomKind::inverse_object_properties:
        return owl_word("inverseOf");
      case AxiomKind::object_property_domain:
      case AxiomKind::data_property_domain:
        return rdfs_word("domain");
      case AxiomKind::object_property_range:
      case AxiomKind::data_property_range:
        return rdfs_word("range");
      case AxiomKind::same_individual:
        return owl_word("sameAs");
      default:
        return owl_word("equivalentClass");  // of classes, and of a datatype and its definition
    }
  }

  std::string literal(const owl::Term& term) {
    std::string text = '"' + std::string(source_.name(term.name)) + '"';
    if (term.arguments.size() == 2) return text + '@' + std::string(source_.name_of(term.arguments[1]));
    return text + "^^" + in_brackets(source_.name_of(term.arguments[0]));
  }

  std::string number(std::uint32_t value) {
    return '"' + std::to_string(value) + "\"^^" +
           in_brackets(std::string(syntax::xsd_namespace) + "nonNegativeInteger");
  }

  std::string described(std::string_view type, std::string_view predicate, const std::string& object) {
    const std::string node = fresh();
    triple(node, rdf_word("type"), type == "Datatype" ? rdfs_word(type) : owl_word(type));
    triple(node, owl_word(predicate), object);
    return node;
  }

  std::string restriction(const owl::Term& term, std::string_view predicate, const std::string& object) {
    const std::string node = described("Restriction", predicate, object);
    triple(node, owl_word("onProperty"), this->term(term.arguments[0]));
    return node;
  }

  std::string cardinality(const owl::Term& term, std::string_view plain, std::string_view qualified,
                          std::string_view filler) {
    if (term.arguments.size() == 1) return restriction(term, plain, number(term.number));
    const std::string node = restriction(term, qualified, number(term.number));
    triple(node, owl_word(filler), this->term(term.arguments[1]));
    return node;
  }

  std::string facets(const owl::Term& term) {
    const std::string node = described("Datatype", "onDatatype", this->term(term.arguments[0]));
    std::string rest = rdf_word("nil");
    for (std::size_t place = term.arguments.size(); place-- > 1;) {
      const owl::Term facet = source_.term(term.arguments[place]);
      const std::string holder = fresh();
      const std::string item = fresh();
      triple(holder, in_brackets(source_.name(facet.name)), this->term(facet.arguments[0]));
      triple(item, rdf_word("first"), holder);
      triple(item, rdf_word("rest"), rest);
      rest = item;
    }
    triple(node, owl_word("withRestrictions"), rest);
    return node;
  }

  std::string term(owl::TermId id) {
    const owl::Term term = source_.term(id);
    const auto argument = [&](std::size_t place) { return this->term(term.arguments[place]); };
    switch (term.kind) {
      case TermKind::anonymous_individual:
        return std::string(source_.name(term.name));
      case TermKind::literal:
        return literal(term);
      case TermKind::object_inverse_of: {
        const std::string node = fresh();
        triple(node, owl_word("inverseOf"), argument(0));
        return node;
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
        return restriction(term, "hasSelf", "\"true\"^^" + in_brackets(std::string(syntax::xsd_namespace) + "boolean"));
      case TermKind::object_min_cardinality:
        return cardinality(term, "minCardinality", "minQualifiedCardinality", "onClass");
      case TermKind::object_max_cardinality:
        return cardinality(term, "maxCardinality", "maxQualifiedCardinality", "onClass");
      case TermKind::object_exact_cardinality:
        return cardinality(term, "cardinality", "qualifiedCardinality", "onClass");
      case TermKind::data_min_cardinality:
        return cardinality(term, "minCardinality", "minQualifiedCardinality", "onDataRange");
      case TermKind::data_max_cardinality:
        return cardinality(term, "maxCardinality", "maxQualifiedCardinality", "onDataRange");
      case TermKind::data_exact_cardinality:
        return cardinality(term, "cardinality", "qualifiedCardinality", "onDataRange");
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
        return in_brackets(source_.name(term.name));
    }
  }

  const owl::Ontology& source_;
  std::vector<std::string> lines_;
  std::size_t blanks_ = 0;
};

}  // namespace

std::vector<std::string> triples_of(const owl::Ontology& source, const std::function<bool(std::size_t)>& is_annotated) {
  Writer writer(source);
  for (std::size_t index = 0; index < source.axiom_count(); ++index)
    writer.axiom(source.axiom(index), is_annotated(index));
  return writer.take();
}

}  // namespace geminga::rdf
