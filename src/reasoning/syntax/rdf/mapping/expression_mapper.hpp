// Class and property expressions and individuals (mapping, tables 11 and 13 to 15).
#ifndef GEMINGA_REASONING_SYNTAX_RDF_MAPPING_EXPRESSION_MAPPER_HPP
#define GEMINGA_REASONING_SYNTAX_RDF_MAPPING_EXPRESSION_MAPPER_HPP

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "reasoning/owl/source.hpp"
#include "reasoning/syntax/rdf/mapping/axiom_writer.hpp"
#include "reasoning/syntax/rdf/mapping/data_range_mapper.hpp"
#include "reasoning/syntax/rdf/mapping/mapped_once.hpp"
#include "reasoning/syntax/rdf/mapping/node_types.hpp"

namespace geminga::rdf {

/// Maps nodes to the class expressions, properties and individuals of an ontology.
class ExpressionMapper {
 public:
  ExpressionMapper(TripleReader& triples, const NodeTypes& types, DataRangeMapper& ranges, AxiomWriter& axioms,
                   owl::Ontology& ontology)
      : graph_(triples.graph()),
        triples_(triples),
        types_(types),
        ranges_(ranges),
        axioms_(axioms),
        ontology_(ontology),
        classes_(graph_.node_count()) {}

  Mapped class_expression(NodeId node);
  /// Fetches into the cache what class_expression() reads first.
  void prefetch(NodeId node) const { __builtin_prefetch(&classes_[static_cast<std::size_t>(node)]); }
  /// Fetches the class that a node became, if it became one.
  void prefetch_term(NodeId node) const {
    const MappedOnce& mapped = classes_[static_cast<std::size_t>(node)];
    if (mapped.is_mapped()) ontology_.prefetch(mapped.term());
  }
  /// The class that a triple with a constructor describes: a Boolean one, or an enumeration.
  Mapped boolean_class(std::uint32_t triple);
  /// The class that a node with owl:onProperty describes.
  Mapped restriction(NodeId node);
  Mapped object_property(NodeId node);
  /// The named property that a blank node is the inverse of: the first where there are several; none without one.
  NodeId inverse_of(NodeId node);
  owl::TermId property_chain(const std::vector<owl::TermId>& links) {
    return ontology_.term(owl::TermKind::object_property_chain, links);
  }
  Mapped data_property(NodeId node);
  Mapped individual(NodeId node);

  // The members of a list.
  MappedList class_expressions(NodeId head) {
    return triples_.terms(head, [this](NodeId node) { return class_expression(node); });
  }
  MappedList object_properties(NodeId head) {
    return triples_.terms(head, [this](NodeId node) { return object_property(node); });
  }
  MappedList data_properties(NodeId head) {
    return triples_.terms(head, [this](NodeId node) { return data_property(node); });
  }
  MappedList individuals(NodeId head) {
    return triples_.terms(head, [this](NodeId node) { return individual(node); });
  }

  [[nodiscard]] bool was_tried_as_class(NodeId node) const {
    return classes_[static_cast<std::size_t>(node)].was_tried();
  }
  [[nodiscard]] bool is_mapped_class(NodeId node) const { return classes_[static_cast<std::size_t>(node)].is_mapped(); }

 private:
  Mapped described_class(NodeId node);
  Mapped quantifier(NodeId property, syntax::Word constraint, NodeId filler);
  Mapped cardinality(NodeId property, syntax::Word constraint, NodeId number, NodeId on_class, NodeId on_range);

  const Graph& graph_;
  TripleReader& triples_;
  const NodeTypes& types_;
  DataRangeMapper& ranges_;
  AxiomWriter& axioms_;
  owl::Ontology& ontology_;
  std::vector<MappedOnce> classes_;  ///< by node
  Obstacles obstacles_;
  std::unordered_map<std::uint32_t, NodeId> inverses_;  ///< by blank node
  std::uint32_t depth_ = 0;                             ///< class expressions around the node in hand
};

}  // namespace geminga::rdf

#endif
