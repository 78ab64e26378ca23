// One function a type, and the triples around its node.
#include "reasoning/syntax/rdf/mapping/type_mapper.hpp"

#include <array>
#include <string_view>
#include <utility>

namespace geminga::rdf {

using syntax::Word;

namespace {

/// Whether the triples of this predicate have a class as their object.
bool is_class_valued(Word predicate) {
  return predicate == Word::rdfs_sub_class_of || predicate == Word::owl_equivalent_class ||
         predicate == Word::owl_disjoint_with || predicate == Word::rdfs_domain || predicate == Word::rdfs_range;
}

/// In OWL 1 these were classes of object properties (mapping, table 6).
bool is_class_of_object_properties(Word type) {
  return type == Word::owl_inverse_functional_property || type == Word::owl_symmetric_property ||
         type == Word::owl_transitive_property;
}

/// The kind of entity that a type declares.
constexpr std::array<std::pair<Word, owl::TermKind>, 10> declarations{{
    {Word::owl_class, owl::TermKind::named_class},
    {Word::rdfs_class, owl::TermKind::named_class},
    {Word::owl_deprecated_class, owl::TermKind::named_class},
    {Word::rdfs_datatype, owl::TermKind::datatype},
    {Word::owl_data_range, owl::TermKind::datatype},
    {Word::owl_object_property, owl::TermKind::object_property},
    {Word::owl_datatype_property, owl::TermKind::data_property},
    {Word::owl_annotation_property, owl::TermKind::annotation_property},
    {Word::owl_ontology_property, owl::TermKind::annotation_property},
    {Word::owl_named_individual, owl::TermKind::individual},
}};

/// The characteristic of an object property that a type states.
constexpr std::array<std::pair<Word, owl::AxiomKind>, 6> characteristics{{
    {Word::owl_inverse_functional_property, owl::AxiomKind::inverse_functional_object_property},
    {Word::owl_reflexive_property, owl::AxiomKind::reflexive_object_property},
    {Word::owl_irreflexive_property, owl::AxiomKind::irreflexive_object_property},
    {Word::owl_symmetric_property, owl::AxiomKind::symmetric_object_property},
    {Word::owl_asymmetric_property, owl::AxiomKind::asymmetric_object_property},
    {Word::owl_transitive_property, owl::AxiomKind::transitive_object_property},
}};

}  // namespace

void TypeMapper::map(std::uint32_t number) {
  triples_.use(number);
  const NodeId node = graph_.triple(number).subject;
  const NodeId object = graph_.triple(number).object;
  const Word type = word_of(object);
  if (is_class_of_object_properties(type) && !graph_.text(node).starts_with(syntax::owl_namespace) &&
      !graph_.has(node, node_of(Word::rdf_type), node_of(Word::owl_datatype_property)))
    axioms_.declare(number, owl::TermKind::object_property);
  for (const auto& [word, kind] : declarations) {
    // RDFS says of a datatype that it is a class, too.
    const bool is_rdfs_datatype = type == Word::rdfs_class && types_.is_datatype(node);
    if (word == type && !is_rdfs_datatype) return axioms_.declare(number, kind);
  }
  for (const auto& [word, kind] : characteristics) {
    if (word == type) return axioms_.add(number, kind, {expressions_.object_property(node)});
  }
  switch (type) {
    case Word::owl_functional_property:
      return map_functional(number);
    case Word::owl_all_disjoint_classes:
      return add_list(number, owl::AxiomKind::disjoint_classes,
                      expressions_.class_expressions(triples_.object_of(node, Word::owl_members)));
    case Word::owl_all_disjoint_properties:
      return map_all_disjoint_properties(number);
    case Word::owl_all_different:
      return map_all_different(number);
    case Word::owl_negative_property_assertion:
      return map_negative_assertion(number);
    case Word::owl_axiom:
      return map_reified(number);
    case Word::rdfs_class:  // of a datatype
    case Word::rdf_property:
    case Word::owl_deprecated_property:
    case Word::owl_annotation:
    case Word::owl_ontology:
    case Word::owl_self_restriction:
    case Word::owl_restriction:  // an expression, mapped where it is used or where its owl:onProperty stands
    case Word::rdf_list:
    case Word::rdfs_resource:
      return;
    case Word::rdfs_literal:
    case Word::rdf_plain_literal:
    case Word::rdf_xml_literal:
    case Word::rdf_lang_string:
      return axioms_.leave_out(number, "rdf:type " + syntax::short_word(graph_.text(object)));
    default:
      return map_assertion(number);
  }
}

void TypeMapper::map_assertion(std::uint32_t number) {
  const Triple& triple = graph_.triple(number);
  if (graph_.is_iri(triple.object) && word_of(triple.object) != Word::owl_thing &&
      word_of(triple.object) != Word::owl_nothing) {
    const std::string_view type = graph_.text(triple.object);
    if (type.starts_with(syntax::owl_namespace))
      return axioms_.leave_out(number, "rdf:type " + syntax::short_word(type));
    // Parts of rules, and rdf:Bag and the like, say nothing here.
    if (type.starts_with(syntax::swrl_namespace) || type.starts_with(syntax::rdf_namespace)) return;
  }
  axioms_.add(number, owl::AxiomKind::class_assertion,
              {expressions_.class_expression(triple.object), expressions_.individual(triple.subject)});
}

void TypeMapper::map_functional(std::uint32_t number) {
  const NodeId property = graph_.triple(number).subject;
  if (types_.is_object_property_expression(property))
    axioms_.add(number, owl::AxiomKind::functional_object_property, {expressions_.object_property(property)});
  if (types_.is_data_property(property))
    axioms_.add(number, owl::AxiomKind::functional_data_property, {expressions_.data_property(property)});
}

void TypeMapper::map_all_disjoint_properties(std::uint32_t number) {
  const NodeId head = triples_.object_of(graph_.triple(number).subject, Word::owl_members);
  const auto members = triples_.list(head);
  if (!members) return axioms_.leave_out(number, "a broken rdf:List");
  const bool is_of_data = !members->empty() && types_.is_data_property_only(members->front());
  if (is_of_data) return add_list(number, owl::AxiomKind::disjoint_data_properties, expressions_.data_properties(head));
  add_list(number, owl::AxiomKind::disjoint_object_properties, expressions_.object_properties(head));
}

void TypeMapper::map_all_different(std::uint32_t number) {
  const NodeId node = graph_.triple(number).subject;
  const NodeId members = triples_.object_of(node, Word::owl_members);
  const NodeId distinct = triples_.object_of(node, Word::owl_distinct_members);
  add_list(number, owl::AxiomKind::different_individuals,
           expressions_.individuals(members != NodeId{} ? members : distinct));
}

void TypeMapper::map_negative_assertion(std::uint32_t number) {
  const NodeId node = graph_.triple(number).subject;
  const NodeId source = triples_.object_of(node, Word::owl_source_individual, Word::rdf_subject);
  const NodeId property = triples_.object_of(node, Word::owl_assertion_property, Word::rdf_predicate);
  NodeId target = triples_.object_of(node, Word::owl_target_individual);
  NodeId value = triples_.object_of(node, Word::owl_target_value);
  if (const NodeId object = triples_.object_of(node, Word::rdf_object); object != NodeId{})
    (graph_.is_literal(object) ? value : target) = object;
  if (source == NodeId{} || property == NodeId{} || (target == NodeId{}) == (value == NodeId{}))
    return axioms_.leave_out(number, "a broken owl:NegativePropertyAssertion");
  if (value != NodeId{})
    return axioms_.add(number, owl::AxiomKind::negative_data_property_assertion,
                       {expressions_.data_property(property), expressions_.individual(source), ranges_.literal(value)});
  axioms_.add(
      number, owl::AxiomKind::negative_object_property_assertion,
      {expressions_.object_property(property), expressions_.individual(source), expressions_.individual(target)});
}

void TypeMapper::map_reified(std::uint32_t number) {
  // The annotated axiom's own triple must be there, too (mapping, section 3.2.5); then it has been mapped as such. An
  // annotation's triple may be missing: some are not kept (redland.cpp).
  const NodeId node = graph_.triple(number).subject;
  const NodeId source = triples_.object_of(node, Word::owl_annotated_source, Word::rdf_subject);
  const NodeId property = triples_.object_of(node, Word::owl_annotated_property, Word::rdf_predicate);
  const NodeId target = triples_.object_of(node, Word::owl_annotated_target, Word::rdf_object);
  if (source == NodeId{} || property == NodeId{} || target == NodeId{})
    return axioms_.leave_out(number, "a broken owl:Axiom");
  if (types_.is_annotation_property(property) || (word_of(property) == Word::none && !types_.is_property(property)))
    return;
  // Writers repeat a blank node's description instead of its name. Lists and the like are taken on trust.
  if (graph_.is_blank(source) || (graph_.is_blank(target) && !is_class_valued(word_of(property)))) return;
  if (graph_.has(source, property, target)) return;
  if (graph_.is_blank(target)) {
    if (types_.is_data_range(target)) return;
    if (const Mapped described = expressions_.class_expression(target);
        described && has_described(source, property, *described))
      return;
  }
  axioms_.leave_out(number, "an owl:Axiom whose own triple is missing");
}

void TypeMapper::add_list(std::uint32_t number, owl::AxiomKind kind, const MappedList& members) {
  if (!members) return axioms_.leave_out(number, members.error());
  axioms_.add_of_list(number, kind, *members);
}

bool TypeMapper::has_described(NodeId subject, NodeId property, owl::TermId described) {
  const auto key_of = [](NodeId predicate, owl::TermId term) {
    return std::uint64_t{static_cast<std::uint32_t>(predicate)} << 32U | static_cast<std::uint32_t>(term);
  };
  const auto [place, is_new] = described_by_.try_emplace(static_cast<std::uint32_t>(subject));
  if (is_new) {
    for (const std::uint32_t number : graph_.about(subject)) {
      const Triple& triple = graph_.triple(number);
      if (!graph_.is_blank(triple.object) || !is_class_valued(word_of(triple.predicate)) ||
          types_.is_data_range(triple.object))
        continue;
      if (const Mapped same = expressions_.class_expression(triple.object))
        place->second.insert(key_of(triple.predicate, *same));
    }
  }
  return place->second.contains(key_of(property, described));
}

}  // namespace geminga::rdf
