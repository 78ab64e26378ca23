// First what is declared, then how the rest is used (mapping, section 3.1.3, and tables 5 and 6).
#include "reasoning/syntax/rdf/mapping/node_types.hpp"

#include <utility>

namespace geminga::rdf {

using syntax::Word;

namespace {

/// Levels of data ranges that are looked into.
constexpr int max_range_depth = 100;

}  // namespace

NodeTypes::NodeTypes(TripleReader& triples)
    : graph_(triples.graph()), types_(graph_.node_count(), 0), range_marks_(graph_.node_count(), 0) {
  add_vocabulary();
  for (std::uint32_t number = 0; number < graph_.triple_count(); ++number) {
    const Triple& triple = graph_.triple(number);
    if (triple.predicate == node_of(Word::rdf_type)) add_declared(triple, triples);
  }
  // Collected beside the declared types, so that the order of triples decides nothing.
  std::vector<Types> uses(types_.size(), 0);
  for (std::uint32_t number = 0; number < graph_.triple_count(); ++number) {
    if (const Triple* later = triples.ahead(number, 32))
      __builtin_prefetch(&types_[static_cast<std::size_t>(later->object)]);
    collect_uses(graph_.triple(number), triples, uses);
  }
  for (std::size_t node = 0; node < types_.size(); ++node) {
    const bool has_type = (types_[node] & property_types) != 0;
    add(NodeId{static_cast<std::uint32_t>(node)}, has_type ? uses[node] & ~property_types : uses[node]);
  }
  spread_property_types();
  choose_property_types();
}

void NodeTypes::add_vocabulary() {
  for (const Word word : {Word::owl_thing, Word::owl_nothing}) add(node_of(word), type_class);
  for (const Word word : {Word::rdfs_literal, Word::rdf_plain_literal, Word::rdf_xml_literal, Word::rdf_lang_string,
                          Word::owl_real, Word::owl_rational})
    add(node_of(word), type_datatype);
  for (const Word word : {Word::owl_top_object_property, Word::owl_bottom_object_property})
    add(node_of(word), type_object_property);
  for (const Word word : {Word::owl_top_data_property, Word::owl_bottom_data_property})
    add(node_of(word), type_data_property);
  for (const Word word : {Word::rdfs_label, Word::rdfs_comment, Word::rdfs_see_also, Word::rdfs_is_defined_by,
                          Word::skos_pref_label, Word::owl_version_info, Word::owl_deprecated, Word::owl_prior_version,
                          Word::owl_backward_compatible_with, Word::owl_incompatible_with})
    add(node_of(word), type_annotation_property);
  for (std::uint32_t node = 0; node < graph_.node_count(); ++node) {
    if (!graph_.is_iri(NodeId{node})) continue;
    const bool is_of_xsd = graph_.text(NodeId{node}).starts_with(syntax::xsd_namespace);
    add(NodeId{node}, is_of_xsd ? is_named | type_datatype : is_named);
  }
}

void NodeTypes::add_declared(const Triple& triple, TripleReader& triples) {
  const NodeId node = triple.subject;
  switch (word_of(triple.object)) {
    case Word::owl_class:
    case Word::rdfs_class:
    case Word::owl_deprecated_class:
      add(node, type_class);
      break;
    case Word::rdfs_datatype:
    case Word::owl_data_range:
      add(node, type_datatype);
      break;
    case Word::owl_object_property:
      add(node, type_object_property);
      break;
    case Word::owl_inverse_functional_property:
    case Word::owl_reflexive_property:
    case Word::owl_irreflexive_property:
    case Word::owl_symmetric_property:
    case Word::owl_asymmetric_property:
    case Word::owl_transitive_property:
      // OWL 2 DL has none of these for data properties. Such an axiom is left out, and the property stays a data
      // property.
      if (!graph_.has(node, node_of(Word::rdf_type), node_of(Word::owl_datatype_property)))
        add(node, type_object_property);
      break;
    case Word::owl_all_disjoint_properties:
      if (const auto members = triples.list(triples.object_of(node, Word::owl_members))) {
        for (const NodeId property : *members) add(property, type_some_property);
      }
      break;
    case Word::owl_datatype_property:
      add(node, type_data_property);
      break;
    case Word::owl_annotation_property:
    case Word::owl_ontology_property:
      add(node, type_annotation_property);
      break;
    case Word::rdf_property:
    case Word::owl_functional_property:
    case Word::owl_deprecated_property:
      add(node, type_some_property);
      break;
    case Word::owl_ontology:
      add(node, type_ontology);
      break;
    case Word::owl_axiom:
    case Word::owl_annotation:
      add(node, type_reified);
      break;
    default:
      break;
  }
}

void NodeTypes::collect_uses(const Triple& triple, TripleReader& triples, std::vector<Types>& uses) {
  const auto use = [&](NodeId node, Types types) { uses[static_cast<std::size_t>(node)] |= types; };
  if (graph_.is_literal(triple.object)) use(triple.predicate, has_literals);
  switch (word_of(triple.predicate)) {
    case Word::owl_inverse_of:
      if (graph_.is_iri(triple.subject)) use(triple.subject, type_object_property);
      use(triple.object, type_object_property);
      break;
    case Word::owl_property_chain_axiom:
      use(triple.subject, type_object_property);
      if (const auto chain = triples.list(triple.object)) {
        for (const NodeId property : *chain) use(property, type_object_property);
      }
      break;
    case Word::owl_has_key:
      if (const auto members = triples.list(triple.object)) {
        for (const NodeId property : *members) use(property, type_some_property);
      }
      break;
    case Word::owl_on_property:
      use(triple.object, type_some_property | use_of_restricted(triple.subject));
      break;
    case Word::rdfs_domain:
      use(triple.subject, type_some_property);
      break;
    case Word::rdfs_range:
      use(triple.subject,
          type_some_property | (is_data_range(triple.object) ? type_data_property : type_object_property));
      break;
    case Word::rdfs_sub_property_of:
      if (const NodeId links = chain_of(triple.subject); links != NodeId{}) {
        use(triple.object, type_object_property);
        if (const auto chain = triples.list(links)) {
          for (const NodeId property : *chain) use(property, type_object_property);
        }
        break;
      }
      [[fallthrough]];
    case Word::owl_equivalent_property:
    case Word::owl_property_disjoint_with:
      use(triple.subject, type_some_property);
      use(triple.object, type_some_property);
      break;
    case Word::owl_assertion_property:
      use(triple.object, use_of_asserted(triple.subject));
      break;
    case Word::rdf_predicate:
      if (graph_.has(triple.subject, node_of(Word::rdf_type), node_of(Word::owl_negative_property_assertion)))
        use(triple.object, use_of_asserted(triple.subject));
      break;
    default:
      break;
  }
}

NodeTypes::Types NodeTypes::use_of_asserted(NodeId assertion) const {
  bool has_target = !graph_.about(assertion, Word::owl_target_individual).empty();
  bool has_value = !graph_.about(assertion, Word::owl_target_value).empty();
  for (const std::uint32_t number : graph_.about(assertion, Word::rdf_object))
    (graph_.is_literal(graph_.triple(number).object) ? has_value : has_target) = true;
  return static_cast<Types>((has_target ? type_object_property : 0) | (has_value ? type_data_property : 0));
}

NodeId NodeTypes::chain_of(NodeId node) const {
  if (!graph_.is_blank(node)) return NodeId{};
  if (!graph_.about(node, Word::rdf_first).empty()) return node;
  const auto chains = graph_.about(node, Word::owl_property_chain);
  return chains.size() == 1 ? graph_.triple(chains.front()).object : NodeId{};
}

NodeTypes::Types NodeTypes::use_of_restricted(NodeId restriction) {
  // A restriction on several properties is no restriction. Looking at all of it for each property would cost the square
  // of the file.
  const bool is_small = graph_.about(restriction).size() < 16;
  const auto key = static_cast<std::uint32_t>(restriction);
  if (const auto known = restricted_uses_.find(key); !is_small && known != restricted_uses_.end()) return known->second;
  Types types = 0;
  for (const std::uint32_t number : graph_.about(restriction)) {
    const Triple& part = graph_.triple(number);
    switch (word_of(part.predicate)) {
      case Word::owl_some_values_from:
      case Word::owl_all_values_from:
        types |= is_data_range(part.object) ? type_data_property : type_object_property;
        break;
      case Word::owl_has_value:
        types |= graph_.is_literal(part.object) ? type_data_property : type_object_property;
        break;
      case Word::owl_has_self:
      case Word::owl_on_class:
        types |= type_object_property;
        break;
      case Word::owl_on_data_range:
        types |= type_data_property;
        break;
      default:
        break;
    }
  }
  if (!is_small) restricted_uses_.emplace(key, types);
  return types;
}

void NodeTypes::spread_property_types() {
  // A property without a type has those of the properties that it is related to. Each round gives one a type or is the
  // last; the rounds are bounded, because nobody writes a chain of a hundred undeclared properties.
  constexpr int max_rounds = 100;
  std::vector<std::uint32_t> links;
  for (std::uint32_t number = 0; number < graph_.triple_count(); ++number) {
    const Word predicate = word_of(graph_.triple(number).predicate);
    if (predicate == Word::rdfs_sub_property_of || predicate == Word::owl_equivalent_property ||
        predicate == Word::owl_property_disjoint_with)
      links.push_back(number);
  }
  std::vector<std::pair<NodeId, Types>> news{{}};
  for (int round = 0; !news.empty() && round < max_rounds; ++round) {
    news.clear();
    const auto copy = [&](NodeId from, NodeId to) {
      const Types types = types_[static_cast<std::size_t>(from)] & property_types;
      if (types != 0 && !has(to, property_types) && graph_.is_iri(to)) news.emplace_back(to, types);
    };
    for (const std::uint32_t number : links) {
      copy(graph_.triple(number).object, graph_.triple(number).subject);
      copy(graph_.triple(number).subject, graph_.triple(number).object);
    }
    for (const auto& [node, types] : news) add(node, types);
  }
}

void NodeTypes::choose_property_types() {
  for (std::uint32_t number = 0; number < graph_.node_count(); ++number) {
    const NodeId node{number};
    if (!has(node, type_some_property) || has(node, property_types)) continue;
    add(node, has(node, has_literals) ? type_data_property : type_object_property);
  }
}

bool NodeTypes::is_data_range(NodeId node, int depth) const {
  if (depth > max_range_depth) return false;
  // The bits of a node are in the cache more often than the node itself, which is many times their size.
  if (has(node, is_named)) return is_datatype(node) && !is_class(node);
  std::uint8_t& mark = range_marks_[static_cast<std::size_t>(node)];
  if (mark == 0 && graph_.is_literal(node)) return false;
  if (mark == 0) mark = is_datatype(node) || describes_data_range(node, depth) ? 2 : 1;
  return mark == 2;
}

bool NodeTypes::describes_data_range(NodeId node, int depth) const {
  const auto has = [&](Word predicate) { return !graph_.about(node, predicate).empty(); };
  if (has(Word::owl_on_datatype) || has(Word::owl_datatype_complement_of)) return true;
  if (has(Word::owl_on_property) || has(Word::owl_complement_of)) return false;
  const auto first_of = [&](Word constructor) {
    for (const std::uint32_t number : graph_.about(node, constructor)) {
      for (const std::uint32_t part : graph_.about(graph_.triple(number).object, Word::rdf_first))
        return graph_.triple(part).object;
    }
    return NodeId{};
  };
  if (const NodeId first = first_of(Word::owl_one_of); first != NodeId{}) return graph_.is_literal(first);
  if (is_class(node)) return false;
  for (const Word constructor : {Word::owl_intersection_of, Word::owl_union_of}) {
    if (const NodeId first = first_of(constructor); first != NodeId{}) return is_data_range(first, depth + 1);
  }
  return false;
}

}  // namespace geminga::rdf
