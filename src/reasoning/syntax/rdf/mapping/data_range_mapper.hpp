// Data ranges and literals (mapping, table 12).
#ifndef GEMINGA_REASONING_SYNTAX_RDF_MAPPING_DATA_RANGE_MAPPER_HPP
#define GEMINGA_REASONING_SYNTAX_RDF_MAPPING_DATA_RANGE_MAPPER_HPP

#include <cstdint>
#include <span>
#include <unordered_map>

#include "reasoning/owl/source.hpp"
#include "reasoning/syntax/rdf/mapping/axiom_writer.hpp"
#include "reasoning/syntax/rdf/mapping/mapped_once.hpp"

namespace geminga::rdf {

/// Maps nodes to the data ranges and literals of an ontology.
class DataRangeMapper {
 public:
  DataRangeMapper(TripleReader& triples, AxiomWriter& axioms, owl::Ontology& ontology)
      : graph_(triples.graph()), triples_(triples), axioms_(axioms), ontology_(ontology) {}

  /// `depth` is how deep the data range is nested in other expressions.
  Mapped data_range(NodeId node, std::uint32_t depth = 0);
  /// The data range that a node's own triples describe, also where the node has a name. `depth` is that of its parts.
  Mapped described_range(NodeId node, std::uint32_t depth = 0);
  Mapped literal(NodeId node);
  [[nodiscard]] bool was_tried(NodeId node) const { return ranges_.contains(static_cast<std::uint32_t>(node)); }

 private:
  Mapped restricted_datatype(NodeId datatype, NodeId facets);
  /// A datatype with the facets that some nodes have. Where the data range itself has them, as OWL 1.1 wrote it, words
  /// of XML Schema alone are facets.
  Mapped with_facets(NodeId datatype, std::span<const NodeId> nodes);
  /// A union, intersection or enumeration.
  Mapped range_of_list(std::uint32_t triple, owl::TermKind kind, const MappedList& members);

  const Graph& graph_;
  TripleReader& triples_;
  AxiomWriter& axioms_;
  owl::Ontology& ontology_;
  std::unordered_map<std::uint32_t, MappedOnce> ranges_;  ///< by blank node
  Obstacles obstacles_;
};

}  // namespace geminga::rdf

#endif
