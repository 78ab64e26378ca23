// The types of the nodes of a graph: class, datatype, kinds of property, or subject of annotations.
#ifndef GEMINGA_REASONING_SYNTAX_RDF_MAPPING_NODE_TYPES_HPP
#define GEMINGA_REASONING_SYNTAX_RDF_MAPPING_NODE_TYPES_HPP

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "reasoning/syntax/rdf/mapping/triple_reader.hpp"
#include "reasoning/syntax/rdf/triples/graph.hpp"

namespace geminga::rdf {

/// The types of all nodes of a graph: as declared, else as they are used (mapping, section 3.1.3). A name can be of
/// several types (OWL 2, section 5.9).
class NodeTypes {
 public:
  /// Looks at all triples, so that their order decides nothing. Marks the triples of lists as used.
  explicit NodeTypes(TripleReader& triples);

  [[nodiscard]] bool is_class(NodeId node) const { return has(node, type_class); }
  [[nodiscard]] bool is_datatype(NodeId node) const { return has(node, type_datatype); }
  [[nodiscard]] bool is_object_property(NodeId node) const { return has(node, type_object_property); }
  [[nodiscard]] bool is_data_property(NodeId node) const { return has(node, type_data_property); }
  [[nodiscard]] bool is_annotation_property(NodeId node) const { return has(node, type_annotation_property); }
  /// A property of any kind.
  [[nodiscard]] bool is_property(NodeId node) const { return has(node, property_types); }
  [[nodiscard]] bool is_data_property_only(NodeId node) const {
    return is_data_property(node) && !is_object_property(node);
  }
  /// An object property, or the inverse of one.
  [[nodiscard]] bool is_object_property_expression(NodeId node) const {
    return graph_.is_blank(node) || is_object_property(node);
  }
  /// An ontology, or a reified axiom or annotation: all triples about it are annotations.
  [[nodiscard]] bool has_annotations_only(NodeId node) const { return has(node, type_ontology | type_reified); }
  /// A datatype that is no class, or a blank node that describes a data range.
  [[nodiscard]] bool is_data_range(NodeId node) const { return is_data_range(node, 0); }
  /// The list of a blank node that drafts of OWL 2 put below a property by rdfs:subPropertyOf, as a chain: that of its
  /// owl:propertyChain, or itself. None where it is no chain.
  [[nodiscard]] NodeId chain_of(NodeId node) const;

 private:
  using Types = std::uint16_t;  ///< bits
  static constexpr Types type_class = 1;
  static constexpr Types type_datatype = 2;
  static constexpr Types type_object_property = 4;
  static constexpr Types type_data_property = 8;
  static constexpr Types type_annotation_property = 16;
  static constexpr Types type_some_property = 32;  ///< rdf:Property, or used as one in an axiom
  static constexpr Types type_ontology = 64;
  static constexpr Types type_reified = 128;
  static constexpr Types has_literals = 256;  ///< a property with a literal value somewhere
  static constexpr Types is_named = 512;      ///< an IRI
  static constexpr Types property_types = type_object_property | type_data_property | type_annotation_property;

  [[nodiscard]] bool has(NodeId node, Types types) const {
    return (types_[static_cast<std::size_t>(node)] & types) != 0;
  }
  void add(NodeId node, Types types) { types_[static_cast<std::size_t>(node)] |= types; }

  void add_vocabulary();
  void add_declared(const Triple& triple, TripleReader& triples);
  void collect_uses(const Triple& triple, TripleReader& triples, std::vector<Types>& uses);
  Types use_of_restricted(NodeId restriction);
  [[nodiscard]] Types use_of_asserted(NodeId assertion) const;
  void spread_property_types();
  void choose_property_types();
  [[nodiscard]] bool is_data_range(NodeId node, int depth) const;
  [[nodiscard]] bool describes_data_range(NodeId node, int depth) const;

  const Graph& graph_;
  std::vector<Types> types_;
  mutable std::vector<std::uint8_t> range_marks_;  ///< of blank nodes: 0 not asked yet, 1 no data range, 2 a data range
  std::unordered_map<std::uint32_t, Types> restricted_uses_;  ///< by subject of owl:onProperty
};

}  // namespace geminga::rdf

#endif
