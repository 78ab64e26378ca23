// Axioms that are one triple, or begin with one (mapping, tables 7 and 16).
#include "reasoning/syntax/rdf/mapping.hpp"

namespace geminga::rdf {

using Kind = owl::AxiomKind;

void Mapping::map_triple(std::uint32_t number) {
  const Triple& triple = graph_.triple(number);
  if (has_role(triple.subject, is_header | is_reified) && word(triple.predicate) != syntax::Word::rdf_type) {
    used_[number] = true;  // annotations; imports are the loader's business
    return;
  }
  switch (word(triple.predicate)) {
    case syntax::Word::rdf_type:
      return map_type(number);
    case syntax::Word::rdfs_sub_class_of:
      return map_class_axiom(number, Kind::sub_class_of);
    case syntax::Word::owl_equivalent_class:
    case syntax::Word::owl_intersection_of:
    case syntax::Word::owl_union_of:
    case syntax::Word::owl_complement_of:
    case syntax::Word::owl_one_of:
    case syntax::Word::owl_on_property:
      return map_definition(number);
    case syntax::Word::owl_disjoint_with:
      return map_class_axiom(number, Kind::disjoint_classes);
    case syntax::Word::owl_disjoint_union_of:
      return map_disjoint_union(number);
    case syntax::Word::rdfs_sub_property_of:
      return map_property_axiom(number, Kind::sub_object_property_of, Kind::sub_data_property_of);
    case syntax::Word::owl_equivalent_property:
      return map_property_axiom(number, Kind::equivalent_object_properties, Kind::equivalent_data_properties);
    case syntax::Word::owl_property_disjoint_with:
      return map_property_axiom(number, Kind::disjoint_object_properties, Kind::disjoint_data_properties);
    case syntax::Word::owl_inverse_of:
      if (graph_.is_blank(triple.subject)) return;  // an expression
      used_[number] = true;
      return add(number, Kind::inverse_object_properties,
                 {object_property(triple.subject), object_property(triple.object)});
    case syntax::Word::owl_property_chain_axiom:
      return map_chain(number);
    case syntax::Word::rdfs_domain:
      return map_domain(number);
    case syntax::Word::rdfs_range:
      return map_range(number);
    case syntax::Word::owl_has_key:
      return map_key(number);
    case syntax::Word::owl_same_as:
      return map_identity(number, Kind::same_individual);
    case syntax::Word::owl_different_from:
      return map_identity(number, Kind::different_individuals);
    default:
      return map_assertion(number);
  }
}

void Mapping::map_class_axiom(std::uint32_t number, owl::AxiomKind kind) {
  used_[number] = true;
  const Triple& triple = graph_.triple(number);
  add(number, kind, {class_expression(triple.subject), class_expression(triple.object)});
}

void Mapping::map_definition(std::uint32_t number) {
  const Triple& triple = graph_.triple(number);
  const syntax::Word predicate = word(triple.predicate);
  const bool is_equivalence = predicate == syntax::Word::owl_equivalent_class;
  if (graph_.is_blank(triple.subject) && !is_equivalence) return;  // an expression, mapped where it is used
  used_[number] = true;
  const bool is_of_ranges =
      is_range(triple.subject) || (is_equivalence && graph_.is_iri(triple.subject) &&
                                   !has_role(triple.subject, is_class) && is_range(triple.object));
  if (is_of_ranges) {
    const Mapped range = is_equivalence ? data_range(triple.object) : described_range(triple.subject);
    return add(number, Kind::datatype_definition, {data_range(triple.subject), range});
  }
  if (is_equivalence)
    return add(number, Kind::equivalent_classes, {class_expression(triple.subject), class_expression(triple.object)});
  if (predicate == syntax::Word::owl_on_property &&
      !named_restrictions_.insert(static_cast<std::uint32_t>(triple.subject)).second)
    return leave_out(number, "an owl:Restriction with several constraints");
  // OWL 1 described a named class without owl:equivalentClass (mapping, table 18).
  const Mapped description = predicate == syntax::Word::owl_on_property
                                 ? restriction(triple.subject)
                                 : boolean_class(triple.subject, predicate, triple.object);
  add(number, Kind::equivalent_classes, {class_expression(triple.subject), description});
}

void Mapping::map_disjoint_union(std::uint32_t number) {
  used_[number] = true;
  const Triple& triple = graph_.triple(number);
  const Mapped whole = class_expression(triple.subject);
  if (!whole) return leave_out(number, whole.error());
  auto parts = terms(triple.object, &Mapping::class_expression);
  if (!parts) return leave_out(number, parts.error());
  parts->insert(parts->begin(), *whole);
  add(number, Kind::disjoint_union, *parts);
}

void Mapping::map_property_axiom(std::uint32_t number, owl::AxiomKind of_objects, owl::AxiomKind of_data) {
  used_[number] = true;
  const Triple& triple = graph_.triple(number);
  bool is_mapped = false;
  if (is_object(triple.subject) && is_object(triple.object)) {
    add(number, of_objects, {object_property(triple.subject), object_property(triple.object)});
    is_mapped = true;
  }
  if (has_role(triple.subject, is_data_property) && has_role(triple.object, is_data_property)) {
    add(number, of_data, {data_property(triple.subject), data_property(triple.object)});
    is_mapped = true;
  }
  // About annotation properties nothing is said that a reasoner could use.
  if (is_mapped || has_role(triple.subject, is_annotation_property) || has_role(triple.object, is_annotation_property))
    return;
  leave_out(number, syntax::short_word(graph_.text(triple.predicate)) + " between properties of different kinds");
}

void Mapping::map_domain(std::uint32_t number) {
  used_[number] = true;
  const Triple& triple = graph_.triple(number);
  if (is_object(triple.subject))
    add(number, Kind::object_property_domain, {object_property(triple.subject), class_expression(triple.object)});
  if (has_role(triple.subject, is_data_property))
    add(number, Kind::data_property_domain, {data_property(triple.subject), class_expression(triple.object)});
}

void Mapping::map_range(std::uint32_t number) {
  used_[number] = true;
  const Triple& triple = graph_.triple(number);
  const bool is_of_data = has_role(triple.subject, is_data_property);
  const bool is_of_objects = is_object(triple.subject);
  const bool is_data_object = is_range(triple.object);
  if (is_of_data && (is_data_object || !is_of_objects))
    add(number, Kind::data_property_range, {data_property(triple.subject), data_range(triple.object)});
  if (is_of_objects && (!is_data_object || !is_of_data))
    add(number, Kind::object_property_range, {object_property(triple.subject), class_expression(triple.object)});
}

void Mapping::map_characteristic(std::uint32_t number, owl::AxiomKind kind) {
  add(number, kind, {object_property(graph_.triple(number).subject)});
}

void Mapping::map_functional(std::uint32_t number) {
  const NodeId property = graph_.triple(number).subject;
  if (is_object(property)) add(number, Kind::functional_object_property, {object_property(property)});
  if (has_role(property, is_data_property)) add(number, Kind::functional_data_property, {data_property(property)});
}

void Mapping::map_chain(std::uint32_t number) {
  used_[number] = true;
  const Triple& triple = graph_.triple(number);
  const auto links = terms(triple.object, &Mapping::object_property);
  if (!links) return leave_out(number, links.error());
  const Mapped super = object_property(triple.subject);
  if (links->empty()) return leave_out(number, "an empty owl:propertyChainAxiom");
  if (links->size() == 1) return add(number, Kind::sub_object_property_of, {links->front(), super});
  add(number, Kind::sub_object_property_of, {source_.term(owl::TermKind::object_property_chain, *links), super});
}

void Mapping::map_key(std::uint32_t number) {
  used_[number] = true;
  const Triple& triple = graph_.triple(number);
  const Mapped keyed = class_expression(triple.subject);
  if (!keyed) return leave_out(number, keyed.error());
  const auto members = list(triple.object);
  if (!members) return leave_out(number, "a broken rdf:List");
  std::vector<owl::TermId> arguments{*keyed};
  std::vector<owl::TermId> data;
  for (const NodeId member : *members) {
    const Mapped property = is_data(member) ? data_property(member) : object_property(member);
    if (!property) return leave_out(number, property.error());
    (is_data(member) ? data : arguments).push_back(*property);
  }
  arguments.insert(arguments.end(), data.begin(), data.end());
  add(number, Kind::has_key, arguments);
}

void Mapping::map_identity(std::uint32_t number, owl::AxiomKind kind) {
  used_[number] = true;
  const Triple& triple = graph_.triple(number);
  add(number, kind, {individual(triple.subject), individual(triple.object)});
}

void Mapping::map_assertion(std::uint32_t number) {
  const Triple& triple = graph_.triple(number);
  if (!has_role(triple.predicate, property_kinds) && (word(triple.predicate) != syntax::Word::none ||
                                                      graph_.text(triple.predicate).starts_with(syntax::owl_namespace)))
    return;  // vocabulary
  const bool is_value = graph_.is_literal(triple.object);
  if (has_role(triple.predicate, is_object_property) && !is_value) {
    used_[number] = true;
    add(number, Kind::object_property_assertion,
        {object_property(triple.predicate), individual(triple.subject), individual(triple.object)});
  } else if (has_role(triple.predicate, is_data_property) && is_value) {
    used_[number] = true;
    add(number, Kind::data_property_assertion,
        {data_property(triple.predicate), individual(triple.subject), literal(triple.object)});
  } else if (has_role(triple.predicate, is_object_property | is_data_property) &&
             !has_role(triple.predicate, is_annotation_property)) {
    used_[number] = true;
    leave_out(number, is_value ? "an object property with a literal" : "a data property with an individual");
  } else {
    used_[number] = true;  // an annotation
  }
}

}  // namespace geminga::rdf
