// Rules of SWRL: swrl:Imp, its atoms and variables (SWRL, W3C member submission of 21 May 2004, section 5).
#ifndef GEMINGA_REASONING_SYNTAX_RDF_MAPPING_RULE_MAPPER_HPP
#define GEMINGA_REASONING_SYNTAX_RDF_MAPPING_RULE_MAPPER_HPP

#include <cstdint>

#include "reasoning/owl/source.hpp"
#include "reasoning/syntax/rdf/mapping/axiom_writer.hpp"
#include "reasoning/syntax/rdf/mapping/expression_mapper.hpp"

namespace geminga::rdf {

/// Maps the rules of a graph, before other triples are mapped: the properties of SWRL may be declared as properties.
class RuleMapper {
 public:
  RuleMapper(TripleReader& triples, const NodeTypes& types, DataRangeMapper& ranges, ExpressionMapper& expressions,
             AxiomWriter& axioms, owl::Ontology& ontology)
      : graph_(triples.graph()),
        triples_(triples),
        types_(types),
        ranges_(ranges),
        expressions_(expressions),
        axioms_(axioms),
        ontology_(ontology) {}

  /// A rule that cannot be mapped is left out by the name of its obstacle, with the place of its type.
  void map_all();

 private:
  Mapped atoms(NodeId rule, syntax::Word part);
  Mapped atom(NodeId node);
  Mapped property_atom(NodeId node, bool is_of_data);
  Mapped built_in(NodeId node);
  Mapped term(owl::TermKind kind, std::initializer_list<Mapped> arguments);
  /// The variable, individual or literal that an atom is about.
  Mapped argument(NodeId node);
  void use_all(NodeId node);

  const Graph& graph_;
  TripleReader& triples_;
  const NodeTypes& types_;
  DataRangeMapper& ranges_;
  ExpressionMapper& expressions_;
  AxiomWriter& axioms_;
  owl::Ontology& ontology_;
};

}  // namespace geminga::rdf

#endif
