// Triples of rdf:type as axioms: declarations, characteristics, assertions, and axioms that have a node of their own
// (mapping, tables 7, 16 and 17).
#ifndef GEMINGA_REASONING_SYNTAX_RDF_MAPPING_TYPE_MAPPER_HPP
#define GEMINGA_REASONING_SYNTAX_RDF_MAPPING_TYPE_MAPPER_HPP

#include <cstdint>
#include <set>
#include <unordered_map>

#include "reasoning/syntax/rdf/mapping/axiom_writer.hpp"
#include "reasoning/syntax/rdf/mapping/expression_mapper.hpp"

namespace geminga::rdf {

/// Maps a triple of rdf:type, by its object, to a declaration or axiom.
class TypeMapper {
 public:
  TypeMapper(TripleReader& triples, const NodeTypes& types, DataRangeMapper& ranges, ExpressionMapper& expressions,
             AxiomWriter& axioms)
      : graph_(triples.graph()),
        triples_(triples),
        types_(types),
        ranges_(ranges),
        expressions_(expressions),
        axioms_(axioms) {}

  void map(std::uint32_t number);

 private:
  void map_functional(std::uint32_t number);
  void map_assertion(std::uint32_t number);
  void map_all_disjoint_properties(std::uint32_t number);
  void map_all_different(std::uint32_t number);
  void map_negative_assertion(std::uint32_t number);
  void map_reified(std::uint32_t number);
  /// Whether a subject has this property with a blank node that describes this class.
  bool has_described(NodeId subject, NodeId property, owl::TermId described);
  /// An axiom of two or more members; fewer say nothing.
  void add_list(std::uint32_t number, owl::AxiomKind kind, const MappedList& members);

  const Graph& graph_;
  TripleReader& triples_;
  const NodeTypes& types_;
  DataRangeMapper& ranges_;
  ExpressionMapper& expressions_;
  AxiomWriter& axioms_;
  std::unordered_map<std::uint32_t, std::set<std::uint64_t>> described_by_;  ///< by subject: see has_described()
};

}  // namespace geminga::rdf

#endif
