// What each node is: by its declaration, else by how it is used (mapping, section 3.1.3, and tables 5 and 6).
#include <algorithm>

#include "reasoning/syntax/rdf/mapping.hpp"

namespace geminga::rdf {

void Mapping::find_roles() {
  for (const syntax::Word word : {syntax::Word::owl_thing, syntax::Word::owl_nothing})
    add_role(node_of(word), is_class);
  for (const syntax::Word word :
       {syntax::Word::rdfs_literal, syntax::Word::rdf_plain_literal, syntax::Word::rdf_xml_literal,
        syntax::Word::rdf_lang_string, syntax::Word::owl_real, syntax::Word::owl_rational})
    add_role(node_of(word), is_datatype);
  for (const syntax::Word word : {syntax::Word::owl_top_object_property, syntax::Word::owl_bottom_object_property})
    add_role(node_of(word), is_object_property);
  for (const syntax::Word word : {syntax::Word::owl_top_data_property, syntax::Word::owl_bottom_data_property})
    add_role(node_of(word), is_data_property);
  for (const syntax::Word word :
       {syntax::Word::rdfs_label, syntax::Word::rdfs_comment, syntax::Word::rdfs_see_also,
        syntax::Word::rdfs_is_defined_by, syntax::Word::skos_pref_label, syntax::Word::owl_version_info,
        syntax::Word::owl_deprecated, syntax::Word::owl_prior_version, syntax::Word::owl_backward_compatible_with,
        syntax::Word::owl_incompatible_with})
    add_role(node_of(word), is_annotation_property);
  for (std::uint32_t node = 0; node < graph_.node_count(); ++node) {
    if (graph_.is_iri(NodeId{node}) && graph_.text(NodeId{node}).starts_with(syntax::xsd_namespace))
      add_role(NodeId{node}, is_datatype);
  }
  for (std::uint32_t number = 0; number < graph_.triple_count(); ++number) {
    const Triple& triple = graph_.triple(number);
    if (word(triple.predicate) == syntax::Word::rdf_type) role_of_type(triple);
  }
  // Collected beside the declared roles, so that the order of triples decides nothing.
  std::vector<std::uint16_t> uses(roles_.size(), 0);
  for (std::uint32_t number = 0; number < graph_.triple_count(); ++number) role_of_use(graph_.triple(number), uses);
  for (std::size_t node = 0; node < roles_.size(); ++node) {
    const bool has_kind = (roles_[node] & property_kinds) != 0;
    add_role(NodeId{static_cast<std::uint32_t>(node)}, has_kind ? uses[node] & ~property_kinds : uses[node]);
  }
  spread_property_kinds();
  settle_properties();
}

void Mapping::role_of_type(const Triple& triple) {
  const NodeId node = triple.subject;
  switch (word(triple.object)) {
    case syntax::Word::owl_class:
    case syntax::Word::rdfs_class:
    case syntax::Word::owl_deprecated_class:
      add_role(node, is_class);
      break;
    case syntax::Word::rdfs_datatype:
    case syntax::Word::owl_data_range:
      add_role(node, is_datatype);
      break;
    case syntax::Word::owl_object_property:
      add_role(node, is_object_property | is_declared_property);
      break;
    case syntax::Word::owl_inverse_functional_property:
    case syntax::Word::owl_reflexive_property:
    case syntax::Word::owl_irreflexive_property:
    case syntax::Word::owl_symmetric_property:
    case syntax::Word::owl_asymmetric_property:
    case syntax::Word::owl_transitive_property:
      // Of a data property OWL 2 DL has none of these: then the axiom is left out, and the property stays what it is.
      if (!has_type(node, syntax::Word::owl_datatype_property))
        add_role(node, is_object_property | is_declared_property);
      break;
    case syntax::Word::owl_all_disjoint_properties:
      if (const auto members = list(object_of(node, syntax::Word::owl_members))) {
        for (const NodeId property : *members) add_role(property, is_some_property);
      }
      break;
    case syntax::Word::owl_datatype_property:
      add_role(node, is_data_property | is_declared_property);
      break;
    case syntax::Word::owl_annotation_property:
    case syntax::Word::owl_ontology_property:
      add_role(node, is_annotation_property | is_declared_property);
      break;
    case syntax::Word::rdf_property:
    case syntax::Word::owl_functional_property:
    case syntax::Word::owl_deprecated_property:
      add_role(node, is_some_property | is_declared_property);
      break;
    case syntax::Word::owl_ontology:
      add_role(node, is_header);
      break;
    case syntax::Word::owl_axiom:
    case syntax::Word::owl_annotation:
      add_role(node, is_reified);
      break;
    default:
      break;
  }
}

bool Mapping::has_type(NodeId subject, syntax::Word type) const {
  return std::ranges::any_of(graph_.about(subject, syntax::Word::rdf_type),
                             [&](std::uint32_t number) { return word(graph_.triple(number).object) == type; });
}

void Mapping::role_of_use(const Triple& triple, std::vector<std::uint16_t>& uses) {
  const auto use = [&](NodeId node, std::uint16_t roles) { uses[static_cast<std::size_t>(node)] |= roles; };
  if (graph_.is_literal(triple.object)) use(triple.predicate, has_literals);
  switch (word(triple.predicate)) {
    case syntax::Word::owl_inverse_of:
      if (graph_.is_iri(triple.subject)) use(triple.subject, is_object_property);
      use(triple.object, is_object_property);
      break;
    case syntax::Word::owl_property_chain_axiom:
      use(triple.subject, is_object_property);
      if (const auto chain = list(triple.object)) {
        for (const NodeId property : *chain) use(property, is_object_property);
      }
      break;
    case syntax::Word::owl_has_key:
      if (const auto members = list(triple.object)) {
        for (const NodeId property : *members) use(property, is_some_property);
      }
      break;
    case syntax::Word::owl_on_property:
      use(triple.object, is_some_property | use_of_restricted(triple.subject));
      break;
    case syntax::Word::rdfs_domain:
      use(triple.subject, is_some_property);
      break;
    case syntax::Word::rdfs_range:
      use(triple.subject, is_some_property | (is_range(triple.object) ? is_data_property : is_object_property));
      break;
    case syntax::Word::rdfs_sub_property_of:
    case syntax::Word::owl_equivalent_property:
    case syntax::Word::owl_property_disjoint_with:
      use(triple.subject, is_some_property);
      use(triple.object, is_some_property);
      break;
    case syntax::Word::owl_assertion_property:
      use(triple.object, use_of_asserted(triple.subject));
      break;
    default:
      break;
  }
}

std::uint16_t Mapping::use_of_asserted(NodeId assertion) const {
  const bool has_target = !graph_.about(assertion, syntax::Word::owl_target_individual).empty();
  const bool has_value = !graph_.about(assertion, syntax::Word::owl_target_value).empty();
  return static_cast<std::uint16_t>((has_target ? is_object_property : 0) | (has_value ? is_data_property : 0));
}

std::uint16_t Mapping::use_of_restricted(NodeId restriction) {
  // A restriction on several properties is none, but costs the square of the file where each looks at all of it.
  const bool is_small = graph_.about(restriction).size() < 16;
  const auto key = static_cast<std::uint32_t>(restriction);
  if (const auto known = restricted_uses_.find(key); !is_small && known != restricted_uses_.end()) return known->second;
  std::uint16_t roles = 0;
  for (const std::uint32_t number : graph_.about(restriction)) {
    const Triple& part = graph_.triple(number);
    switch (word(part.predicate)) {
      case syntax::Word::owl_some_values_from:
      case syntax::Word::owl_all_values_from:
        roles |= is_range(part.object) ? is_data_property : is_object_property;
        break;
      case syntax::Word::owl_has_value:
        roles |= graph_.is_literal(part.object) ? is_data_property : is_object_property;
        break;
      case syntax::Word::owl_has_self:
      case syntax::Word::owl_on_class:
        roles |= is_object_property;
        break;
      case syntax::Word::owl_on_data_range:
        roles |= is_data_property;
        break;
      default:
        break;
    }
  }
  if (!is_small) restricted_uses_.emplace(key, roles);
  return roles;
}

void Mapping::spread_property_kinds() {
  // A property without a kind of its own has that of those it is related to. Each round gives at least one a kind or is
  // the last; the rounds are bounded, because nobody writes a chain of a hundred undeclared properties.
  constexpr int max_rounds = 100;
  std::vector<std::uint32_t> links;
  for (std::uint32_t number = 0; number < graph_.triple_count(); ++number) {
    const syntax::Word predicate = word(graph_.triple(number).predicate);
    if (predicate == syntax::Word::rdfs_sub_property_of || predicate == syntax::Word::owl_equivalent_property ||
        predicate == syntax::Word::owl_property_disjoint_with)
      links.push_back(number);
  }
  std::vector<std::pair<NodeId, std::uint16_t>> news{{}};
  for (int round = 0; !news.empty() && round < max_rounds; ++round) {
    news.clear();
    const auto copy = [&](NodeId from, NodeId to) {
      const std::uint16_t kinds = roles_[static_cast<std::size_t>(from)] & property_kinds;
      if (kinds != 0 && !has_role(to, property_kinds) && graph_.is_iri(to)) news.emplace_back(to, kinds);
    };
    for (const std::uint32_t number : links) {
      copy(graph_.triple(number).object, graph_.triple(number).subject);
      copy(graph_.triple(number).subject, graph_.triple(number).object);
    }
    for (const auto& [node, kinds] : news) add_role(node, kinds);
  }
}

void Mapping::settle_properties() {
  for (std::uint32_t number = 0; number < graph_.node_count(); ++number) {
    const NodeId node{number};
    if (!has_role(node, is_some_property) || has_role(node, property_kinds)) continue;
    add_role(node, has_role(node, has_literals) ? is_data_property : is_object_property);
  }
}

}  // namespace geminga::rdf
