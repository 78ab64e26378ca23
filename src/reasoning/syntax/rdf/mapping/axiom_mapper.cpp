// One function a form of axiom, in the order of the mapping's tables.
#include "reasoning/syntax/rdf/mapping/axiom_mapper.hpp"

#include <algorithm>
#include <vector>

#include "reasoning/owl/datatypes.hpp"

namespace geminga::rdf {

using Kind = owl::AxiomKind;
using syntax::Word;

void AxiomMapper::map(std::uint32_t number) {
  const Triple& triple = graph_.triple(number);
  if (types_.has_annotations_only(triple.subject) && word_of(triple.predicate) != Word::rdf_type) {
    triples_.use(number);  // annotations; imports are the loader's business
    return;
  }
  switch (word_of(triple.predicate)) {
    case Word::rdf_type:
      return type_mapper_.map(number);
    case Word::rdfs_sub_class_of:
      return map_class_axiom(number, Kind::sub_class_of);
    case Word::owl_equivalent_class:
    case Word::owl_intersection_of:
    case Word::owl_union_of:
    case Word::owl_complement_of:
    case Word::owl_one_of:
    case Word::owl_on_property:
      return map_definition(number);
    case Word::owl_disjoint_with:
      return map_class_axiom(number, Kind::disjoint_classes);
    case Word::owl_disjoint_union_of:
      return map_disjoint_union(number);
    case Word::rdfs_sub_property_of:
      if (const NodeId links = types_.chain_of(graph_.triple(number).subject); links != NodeId{})
        return map_chain(number, links, graph_.triple(number).object);
      return map_property_axiom(number, Kind::sub_object_property_of, Kind::sub_data_property_of);
    case Word::owl_equivalent_property:
      return map_property_axiom(number, Kind::equivalent_object_properties, Kind::equivalent_data_properties);
    case Word::owl_property_disjoint_with:
      return map_property_axiom(number, Kind::disjoint_object_properties, Kind::disjoint_data_properties);
    case Word::owl_inverse_of:
      return map_inverse(number);
    case Word::owl_property_chain_axiom:
      return map_chain(number, graph_.triple(number).object, graph_.triple(number).subject);
    case Word::rdfs_domain:
      return map_domain(number);
    case Word::rdfs_range:
      return map_range(number);
    case Word::owl_has_key:
      return map_key(number);
    case Word::owl_same_as:
      return map_identity(number, Kind::same_individual);
    case Word::owl_different_from:
      return map_identity(number, Kind::different_individuals);
    default:
      return map_assertion(number);
  }
}

void AxiomMapper::map_class_axiom(std::uint32_t number, owl::AxiomKind kind) {
  const Triple& triple = triples_.take(number);
  axioms_.add(number, kind,
              {expressions_.class_expression(triple.subject), expressions_.class_expression(triple.object)});
}

void AxiomMapper::map_definition(std::uint32_t number) {
  const Triple& triple = graph_.triple(number);
  const Word predicate = word_of(triple.predicate);
  const bool is_equivalence = predicate == Word::owl_equivalent_class;
  if (graph_.is_blank(triple.subject) && !is_equivalence) return;  // an expression, mapped where it is used
  triples_.use(number);
  const bool is_of_ranges =
      types_.is_data_range(triple.subject) || (is_equivalence && graph_.is_iri(triple.subject) &&
                                               !types_.is_class(triple.subject) && types_.is_data_range(triple.object));
  if (is_of_ranges) {
    const Mapped range = is_equivalence ? ranges_.data_range(triple.object) : ranges_.described_range(triple.subject);
    return axioms_.add(number, Kind::datatype_definition, {ranges_.data_range(triple.subject), range});
  }
  if (is_equivalence)
    return axioms_.add(number, Kind::equivalent_classes,
                       {expressions_.class_expression(triple.subject), expressions_.class_expression(triple.object)});
  if (predicate == Word::owl_on_property &&
      !named_restrictions_.insert(static_cast<std::uint32_t>(triple.subject)).second)
    return axioms_.leave_out(number, "an owl:Restriction with several constraints");
  // OWL 1 described a named class without owl:equivalentClass (mapping, table 18).
  const Mapped description = predicate == Word::owl_on_property ? expressions_.restriction(triple.subject)
                                                                : expressions_.boolean_class(number);
  axioms_.add(number, Kind::equivalent_classes, {expressions_.class_expression(triple.subject), description});
}

void AxiomMapper::map_disjoint_union(std::uint32_t number) {
  const Triple& triple = triples_.take(number);
  const Mapped whole = expressions_.class_expression(triple.subject);
  if (!whole) return axioms_.leave_out(number, whole.error());
  auto parts = expressions_.class_expressions(triple.object);
  if (!parts) return axioms_.leave_out(number, parts.error());
  parts->insert(parts->begin(), *whole);
  axioms_.add(number, Kind::disjoint_union, *parts);
}

void AxiomMapper::map_property_axiom(std::uint32_t number, owl::AxiomKind of_objects, owl::AxiomKind of_data) {
  const Triple& triple = triples_.take(number);
  bool is_mapped = false;
  if (types_.is_object_property_expression(triple.subject) && types_.is_object_property_expression(triple.object)) {
    axioms_.add(number, of_objects,
                {expressions_.object_property(triple.subject), expressions_.object_property(triple.object)});
    is_mapped = true;
  }
  if (types_.is_data_property(triple.subject) && types_.is_data_property(triple.object)) {
    axioms_.add(number, of_data,
                {expressions_.data_property(triple.subject), expressions_.data_property(triple.object)});
    is_mapped = true;
  }
  // A reasoner cannot use axioms about annotation properties.
  if (is_mapped || types_.is_annotation_property(triple.subject) || types_.is_annotation_property(triple.object))
    return;
  axioms_.leave_out(number,
                    syntax::short_word(graph_.text(triple.predicate)) + " between properties of different kinds");
}

/// A blank subject is the inverse of a named property, and a further triple is an axiom about it. Which of several
/// named properties is that of the expression is not said. In either case each is the other's equivalent.
void AxiomMapper::map_inverse(std::uint32_t number) {
  const Triple& triple = graph_.triple(number);
  if (graph_.is_blank(triple.subject) && graph_.is_iri(triple.object)) {
    const NodeId first = expressions_.inverse_of(triple.subject);
    if (first == triple.object) return;  // the expression
    triples_.use(number);
    return axioms_.add(number, Kind::equivalent_object_properties,
                       {expressions_.object_property(first), expressions_.object_property(triple.object)});
  }
  triples_.use(number);
  axioms_.add(number, Kind::inverse_object_properties,
              {expressions_.object_property(triple.subject), expressions_.object_property(triple.object)});
}

void AxiomMapper::map_domain(std::uint32_t number) {
  const Triple& triple = triples_.take(number);
  if (types_.is_object_property_expression(triple.subject))
    axioms_.add(number, Kind::object_property_domain,
                {expressions_.object_property(triple.subject), expressions_.class_expression(triple.object)});
  if (types_.is_data_property(triple.subject))
    axioms_.add(number, Kind::data_property_domain,
                {expressions_.data_property(triple.subject), expressions_.class_expression(triple.object)});
}

void AxiomMapper::map_range(std::uint32_t number) {
  const Triple& triple = triples_.take(number);
  const bool is_of_data = types_.is_data_property(triple.subject);
  const bool is_of_objects = types_.is_object_property_expression(triple.subject);
  const bool is_data_object = types_.is_data_range(triple.object);
  if (is_of_data && (is_data_object || !is_of_objects))
    axioms_.add(number, Kind::data_property_range,
                {expressions_.data_property(triple.subject), ranges_.data_range(triple.object)});
  if (is_of_objects && (!is_data_object || !is_of_data))
    axioms_.add(number, Kind::object_property_range,
                {expressions_.object_property(triple.subject), expressions_.class_expression(triple.object)});
}

void AxiomMapper::map_chain(std::uint32_t number, NodeId list, NodeId whole) {
  triples_.use(number);
  if (graph_.is_blank(graph_.triple(number).subject))
    triples_.object_of(graph_.triple(number).subject, Word::owl_property_chain);  // uses it
  const auto links = expressions_.object_properties(list);
  if (!links) return axioms_.leave_out(number, links.error());
  const Mapped super = expressions_.object_property(whole);
  if (links->empty()) return axioms_.leave_out(number, "an empty owl:propertyChainAxiom");
  if (links->size() == 1) return axioms_.add(number, Kind::sub_object_property_of, {links->front(), super});
  axioms_.add(number, Kind::sub_object_property_of, {expressions_.property_chain(*links), super});
}

void AxiomMapper::map_key(std::uint32_t number) {
  const Triple& triple = triples_.take(number);
  const Mapped keyed = expressions_.class_expression(triple.subject);
  if (!keyed) return axioms_.leave_out(number, keyed.error());
  const auto members = triples_.list(triple.object);
  if (!members) return axioms_.leave_out(number, "a broken rdf:List");
  std::vector<owl::TermId> arguments{*keyed};
  std::vector<owl::TermId> data;
  for (const NodeId member : *members) {
    const Mapped property = types_.is_data_property_only(member) ? expressions_.data_property(member)
                                                                 : expressions_.object_property(member);
    if (!property) return axioms_.leave_out(number, property.error());
    (types_.is_data_property_only(member) ? data : arguments).push_back(*property);
  }
  arguments.insert(arguments.end(), data.begin(), data.end());
  axioms_.add(number, Kind::has_key, arguments);
}

void AxiomMapper::map_identity(std::uint32_t number, owl::AxiomKind kind) {
  const Triple& triple = triples_.take(number);
  axioms_.add(number, kind, {expressions_.individual(triple.subject), expressions_.individual(triple.object)});
}

void AxiomMapper::map_assertion(std::uint32_t number) {
  const Triple& triple = graph_.triple(number);
  // The cells of lists stay cells where a file declares rdf:first as a property, in whatever order triples come.
  const Word word = word_of(triple.predicate);
  if (graph_.is_blank(triple.subject) && (word == Word::rdf_first || word == Word::rdf_rest)) return;
  const bool is_of_statement =
      word == Word::rdf_subject || word == Word::rdf_predicate || word == Word::rdf_object;  // of an rdf:Statement
  if (!types_.is_property(triple.predicate) && !is_of_statement &&
      (word != Word::none || graph_.text(triple.predicate).starts_with(syntax::owl_namespace)))
    return;              // vocabulary
  triples_.use(number);  // where it becomes no axiom, as an annotation
  const bool is_value = graph_.is_literal(triple.object);
  if (types_.is_object_property(triple.predicate) && !is_value) {
    axioms_.add(number, Kind::object_property_assertion,
                {expressions_.object_property(triple.predicate), expressions_.individual(triple.subject),
                 expressions_.individual(triple.object)});
  } else if (types_.is_data_property(triple.predicate) && is_value) {
    axioms_.add(number, Kind::data_property_assertion,
                {expressions_.data_property(triple.predicate), expressions_.individual(triple.subject),
                 ranges_.literal(triple.object)});
  } else if (!types_.is_annotation_property(triple.predicate) && types_.is_property(triple.predicate)) {
    axioms_.leave_out(number, is_value ? "an object property with a literal" : "a data property with an individual");
  } else if (!types_.is_property(triple.predicate) && is_individual(triple.subject)) {
    remark_undeclared(number);
  }
}

bool AxiomMapper::is_individual(NodeId node) const {
  return std::ranges::any_of(graph_.about(node, Word::rdf_type), [&](std::uint32_t number) {
    const NodeId type = graph_.triple(number).object;
    const Word word = word_of(type);
    if (word == Word::owl_thing || word == Word::owl_named_individual) return true;
    return word == Word::none && !graph_.text(type).starts_with(syntax::owl_namespace);
  });
}

void AxiomMapper::remark_undeclared(std::uint32_t number) {
  const std::string_view predicate = graph_.text(graph_.triple(number).predicate);
  if (predicate.starts_with(owl::rdf_namespace)) return;  // members of a container
  if (undeclared_.empty())
    undeclared_ = "facts of properties that nothing declares, such as <" + std::string(predicate) +
                  ">, read as annotations (declare them as owl:ObjectProperty or owl:DatatypeProperty)";
  axioms_.remark(number, undeclared_);
}

}  // namespace geminga::rdf
