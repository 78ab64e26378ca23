// What an rdf:type says: declarations, characteristics, assertions, and axioms that have a node of their own
// (mapping, tables 7, 16 and 17).
#include <array>

#include "reasoning/syntax/rdf/mapping.hpp"

namespace geminga::rdf {

using Kind = owl::AxiomKind;

namespace {

/// Whether the triples of this predicate have a class as their object.
bool is_class_valued(syntax::Word predicate) {
  return predicate == syntax::Word::rdfs_sub_class_of || predicate == syntax::Word::owl_equivalent_class ||
         predicate == syntax::Word::owl_disjoint_with || predicate == syntax::Word::rdfs_domain ||
         predicate == syntax::Word::rdfs_range;
}

/// In OWL 1 these were classes of object properties (mapping, table 6).
bool declares_object_property(syntax::Word type) {
  return type == syntax::Word::owl_inverse_functional_property || type == syntax::Word::owl_symmetric_property ||
         type == syntax::Word::owl_transitive_property;
}

}  // namespace

void Mapping::map_type(std::uint32_t number) {
  const Triple& triple = graph_.triple(number);
  const NodeId node = triple.subject;
  used_[number] = true;
  if (declares_object_property(word(triple.object)) && !has_type(node, syntax::Word::owl_datatype_property) &&
      !graph_.text(node).starts_with(syntax::owl_namespace))
    declare(number, owl::TermKind::object_property);
  switch (word(triple.object)) {
    case syntax::Word::owl_class:
    case syntax::Word::rdfs_class:
    case syntax::Word::owl_deprecated_class:
      if (has_role(node, is_datatype) && word(triple.object) == syntax::Word::rdfs_class) return;
      return declare(number, owl::TermKind::named_class);
    case syntax::Word::rdfs_datatype:
    case syntax::Word::owl_data_range:
      return declare(number, owl::TermKind::datatype);
    case syntax::Word::owl_object_property:
      return declare(number, owl::TermKind::object_property);
    case syntax::Word::owl_datatype_property:
      return declare(number, owl::TermKind::data_property);
    case syntax::Word::owl_annotation_property:
    case syntax::Word::owl_ontology_property:
      return declare(number, owl::TermKind::annotation_property);
    case syntax::Word::rdf_property:
    case syntax::Word::owl_deprecated_property:
      return;
    case syntax::Word::owl_named_individual:
      return declare(number, owl::TermKind::individual);
    case syntax::Word::owl_functional_property:
      return map_functional(number);
    case syntax::Word::owl_inverse_functional_property:
      return map_characteristic(number, Kind::inverse_functional_object_property);
    case syntax::Word::owl_reflexive_property:
      return map_characteristic(number, Kind::reflexive_object_property);
    case syntax::Word::owl_irreflexive_property:
      return map_characteristic(number, Kind::irreflexive_object_property);
    case syntax::Word::owl_symmetric_property:
      return map_characteristic(number, Kind::symmetric_object_property);
    case syntax::Word::owl_asymmetric_property:
      return map_characteristic(number, Kind::asymmetric_object_property);
    case syntax::Word::owl_transitive_property:
      return map_characteristic(number, Kind::transitive_object_property);
    case syntax::Word::owl_all_disjoint_classes:
      return add_list_axiom(number, Kind::disjoint_classes, object_of(node, syntax::Word::owl_members),
                            &Mapping::class_expression);
    case syntax::Word::owl_all_disjoint_properties:
      return map_all_disjoint_properties(number);
    case syntax::Word::owl_all_different:
      return map_all_different(number);
    case syntax::Word::owl_negative_property_assertion:
      return map_negative_assertion(number);
    case syntax::Word::owl_axiom:
      return map_reified(number);
    case syntax::Word::owl_annotation:
    case syntax::Word::owl_ontology:
    case syntax::Word::rdf_list:
    case syntax::Word::rdfs_resource:
      return;
    case syntax::Word::owl_restriction:
      return;  // an expression, mapped where it is used or where its owl:onProperty stands
    case syntax::Word::rdfs_literal:
    case syntax::Word::rdf_plain_literal:
    case syntax::Word::rdf_xml_literal:
    case syntax::Word::rdf_lang_string:
      return leave_out(number, "rdf:type " + syntax::short_word(graph_.text(triple.object)));
    default:
      break;
  }
  if (graph_.is_iri(triple.object) && word(triple.object) != syntax::Word::owl_thing &&
      word(triple.object) != syntax::Word::owl_nothing) {
    const std::string_view type = graph_.text(triple.object);
    if (type.starts_with(syntax::owl_namespace)) return leave_out(number, "rdf:type " + syntax::short_word(type));
    if (type.starts_with(syntax::swrl_namespace)) {
      if (type.substr(syntax::swrl_namespace.size()) == "Imp") leave_out(number, "swrl:Imp");
      return;
    }
    if (type.starts_with(syntax::rdf_namespace)) return;  // rdf:Bag and the like say nothing here
  }
  add(number, Kind::class_assertion, {class_expression(triple.object), individual(node)});
}

void Mapping::map_all_disjoint_properties(std::uint32_t number) {
  const NodeId head = object_of(graph_.triple(number).subject, syntax::Word::owl_members);
  const auto members = list(head);
  if (!members) return leave_out(number, "a broken rdf:List");
  const bool is_of_data = !members->empty() && is_data(members->front());
  if (is_of_data) return add_list_axiom(number, Kind::disjoint_data_properties, head, &Mapping::data_property);
  add_list_axiom(number, Kind::disjoint_object_properties, head, &Mapping::object_property);
}

void Mapping::map_all_different(std::uint32_t number) {
  const NodeId node = graph_.triple(number).subject;
  const NodeId members = object_of(node, syntax::Word::owl_members);
  const NodeId distinct = object_of(node, syntax::Word::owl_distinct_members);
  add_list_axiom(number, Kind::different_individuals, members != NodeId{} ? members : distinct, &Mapping::individual);
}

void Mapping::map_negative_assertion(std::uint32_t number) {
  const NodeId node = graph_.triple(number).subject;
  const NodeId source = object_of(node, syntax::Word::owl_source_individual);
  const NodeId property = object_of(node, syntax::Word::owl_assertion_property);
  const NodeId target = object_of(node, syntax::Word::owl_target_individual);
  const NodeId value = object_of(node, syntax::Word::owl_target_value);
  if (source == NodeId{} || property == NodeId{} || (target == NodeId{}) == (value == NodeId{}))
    return leave_out(number, "a broken owl:NegativePropertyAssertion");
  if (value != NodeId{})
    return add(number, Kind::negative_data_property_assertion,
               {data_property(property), individual(source), literal(value)});
  add(number, Kind::negative_object_property_assertion,
      {object_property(property), individual(source), individual(target)});
}

void Mapping::map_reified(std::uint32_t number) {
  // The annotated axiom's own triple must be there, too (mapping, section 3.2.5); then it has been mapped as such. An
  // annotation's triple may be missing: some are not kept (redland.cpp).
  const NodeId node = graph_.triple(number).subject;
  const NodeId source = object_of(node, syntax::Word::owl_annotated_source);
  const NodeId property = object_of(node, syntax::Word::owl_annotated_property);
  const NodeId target = object_of(node, syntax::Word::owl_annotated_target);
  if (source == NodeId{} || property == NodeId{} || target == NodeId{}) return leave_out(number, "a broken owl:Axiom");
  if (has_role(property, is_annotation_property) ||
      (word(property) == syntax::Word::none && !has_role(property, property_kinds)))
    return;
  // Writers repeat a blank node's description instead of its name. Lists and the like are taken on trust.
  if (graph_.is_blank(source) || (graph_.is_blank(target) && !is_class_valued(word(property)))) return;
  if (graph_.has(source, property, target)) return;
  if (graph_.is_blank(target)) {
    if (is_range(target)) return;
    if (const Mapped described = class_expression(target); described && has_described(source, property, *described))
      return;
  }
  leave_out(number, "an owl:Axiom whose own triple is missing");
}

bool Mapping::has_described(NodeId subject, NodeId property, owl::TermId described) {
  const auto key_of = [](NodeId predicate, owl::TermId term) {
    return std::uint64_t{static_cast<std::uint32_t>(predicate)} << 32U | static_cast<std::uint32_t>(term);
  };
  const auto [place, is_new] = repeated_by_.try_emplace(static_cast<std::uint32_t>(subject));
  if (is_new) {
    for (const std::uint32_t number : graph_.about(subject)) {
      const Triple& triple = graph_.triple(number);
      if (!graph_.is_blank(triple.object) || !is_class_valued(word(triple.predicate)) || is_range(triple.object))
        continue;
      if (const Mapped same = class_expression(triple.object)) place->second.insert(key_of(triple.predicate, *same));
    }
  }
  return place->second.contains(key_of(property, described));
}

void Mapping::map_labels() {
  for (std::uint32_t node = 0; node < graph_.node_count(); ++node) {
    const NodeId named{node};
    if (!graph_.is_iri(named) || graph_.about(named).empty()) continue;
    if (!has_role(named, is_class) && classes_[node].state != Memo::State::mapped) continue;
    for (const std::uint32_t number : graph_.about(named)) {
      const Triple& triple = graph_.triple(number);
      const syntax::Word predicate = word(triple.predicate);
      if (predicate != syntax::Word::rdfs_label && predicate != syntax::Word::skos_pref_label) continue;
      const Node label = graph_.node(triple.object);
      if (label.kind != NodeKind::literal) continue;
      source_.add_label(graph_.text(named), label.text,
                        label.language == NodeId{} ? std::string_view() : graph_.text(label.language));
    }
  }
}

void Mapping::report_leftovers() {
  for (std::uint32_t number = 0; number < graph_.triple_count(); ++number) {
    if (used_[number]) continue;
    const Triple& triple = graph_.triple(number);
    const std::string_view predicate = graph_.text(triple.predicate);
    // A class expression in no axiom says nothing, but it must be one.
    if (graph_.is_blank(triple.subject) && predicate.starts_with(syntax::owl_namespace)) {
      const bool was_tried = classes_[static_cast<std::size_t>(triple.subject)].state != Memo::State::unknown ||
                             ranges_.contains(static_cast<std::uint32_t>(triple.subject));
      if (was_tried) continue;  // and counted where it was used
      const Mapped mapped = is_range(triple.subject)                                 ? data_range(triple.subject)
                            : word(triple.predicate) == syntax::Word::owl_inverse_of ? object_property(triple.subject)
                                                                                     : class_expression(triple.subject);
      if (!mapped) leave_out(number, mapped.error());
      for (const std::uint32_t other : graph_.about(triple.subject)) used_[other] = true;
      continue;
    }
    if (predicate.starts_with(syntax::owl_namespace) || word(triple.predicate) == syntax::Word::rdfs_domain ||
        word(triple.predicate) == syntax::Word::rdfs_range)
      leave_out(number, syntax::short_word(predicate));
  }
}

}  // namespace geminga::rdf
