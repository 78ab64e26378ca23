// Axioms that are one triple, or begin with one (mapping, tables 7 and 16).
#ifndef GEMINGA_REASONING_SYNTAX_RDF_MAPPING_AXIOM_MAPPER_HPP
#define GEMINGA_REASONING_SYNTAX_RDF_MAPPING_AXIOM_MAPPER_HPP

#include <cstdint>
#include <string>
#include <unordered_set>

#include "reasoning/syntax/rdf/mapping/axiom_writer.hpp"
#include "reasoning/syntax/rdf/mapping/expression_mapper.hpp"
#include "reasoning/syntax/rdf/mapping/type_mapper.hpp"

namespace geminga::rdf {

/// Maps a triple, by its predicate, to the axiom that it stands for.
class AxiomMapper {
 public:
  AxiomMapper(TripleReader& triples, const NodeTypes& types, DataRangeMapper& ranges, ExpressionMapper& expressions,
              AxiomWriter& axioms)
      : graph_(triples.graph()),
        triples_(triples),
        types_(types),
        ranges_(ranges),
        expressions_(expressions),
        axioms_(axioms),
        type_mapper_(triples, types, ranges, expressions, axioms) {}

  /// Leaves a triple unused if it is part of an expression; the mapping of the expression uses it.
  void map(std::uint32_t number);

 private:
  void map_class_axiom(std::uint32_t number, owl::AxiomKind kind);
  void map_definition(std::uint32_t number);
  void map_property_axiom(std::uint32_t number, owl::AxiomKind of_objects, owl::AxiomKind of_data);
  void map_inverse(std::uint32_t number);
  void map_domain(std::uint32_t number);
  void map_range(std::uint32_t number);
  /// `list` holds the properties of the chain, and `whole` is the property above it.
  void map_chain(std::uint32_t number, NodeId list, NodeId whole);
  void map_key(std::uint32_t number);
  void map_disjoint_union(std::uint32_t number);
  void map_identity(std::uint32_t number, owl::AxiomKind kind);
  void map_assertion(std::uint32_t number);
  /// Whether the node has a class among its types.
  [[nodiscard]] bool is_individual(NodeId node) const;
  /// A property that nothing declares makes annotations of its facts (OWL 2 mapping from RDF, section 3.2.4), which its
  /// author need not want.
  void remark_undeclared(std::uint32_t number);

  const Graph& graph_;
  TripleReader& triples_;
  const NodeTypes& types_;
  DataRangeMapper& ranges_;
  ExpressionMapper& expressions_;
  AxiomWriter& axioms_;
  TypeMapper type_mapper_;
  std::string undeclared_;                                ///< the remark about such facts, with the first property
  std::unordered_set<std::uint32_t> named_restrictions_;  ///< IRIs with owl:onProperty
};

}  // namespace geminga::rdf

#endif
