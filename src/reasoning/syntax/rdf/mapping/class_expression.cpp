#include "reasoning/syntax/rdf/mapping/class_expression.hpp"

#include <cstdint>

#include "reasoning/syntax/rdf/mapping/axiom_writer.hpp"
#include "reasoning/syntax/rdf/mapping/data_range_mapper.hpp"
#include "reasoning/syntax/rdf/mapping/expression_mapper.hpp"
#include "reasoning/syntax/rdf/mapping/node_types.hpp"
#include "reasoning/syntax/rdf/mapping/triple_reader.hpp"

namespace geminga::rdf {

std::expected<owl::TermId, std::string> map_class_expression(const Graph& graph, NodeId node, owl::Ontology& ontology) {
  const owl::FileId file = ontology.add_file("");
  TripleReader triples(graph);
  const NodeTypes types(triples);
  AxiomWriter axioms(graph, ontology, {file});
  DataRangeMapper ranges(triples, axioms, ontology);
  ExpressionMapper expressions(triples, types, ranges, axioms, ontology);
  const Mapped mapped = expressions.class_expression(node);
  if (!mapped) return std::unexpected(mapped.error());
  for (std::uint32_t number = 0; number < graph.triple_count(); ++number) {
    const NodeId predicate = graph.triple(number).predicate;
    if (!triples.is_used(number) && predicate != node_of(syntax::Word::rdf_type))
      return std::unexpected(syntax::short_word(graph.text(predicate)) + " is no part of it");
  }
  // An axiom must be able to hold it.
  ontology.add(owl::AxiomKind::sub_class_of, {*mapped, owl::thing_term}, file, 0);
  if (ontology.axiom_count() == 1) return *mapped;
  const auto omissions = ontology.omissions();
  return std::unexpected(omissions.empty() ? std::string("OWL 2 cannot express it")
                                           : std::string(ontology.name(omissions.front().construct)));
}

}  // namespace geminga::rdf
