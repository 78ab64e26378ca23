// The order of the passes: what each node is, the axioms, the labels, and what nobody used.
#include "reasoning/syntax/rdf/mapping.hpp"

#include <cstdint>
#include <string_view>
#include <utility>

#include "reasoning/syntax/rdf/axiom_mapper.hpp"

namespace geminga::rdf {
namespace {

using syntax::Word;

void add_labels(const NodeTypes& types, const ExpressionMapper& expressions, const Graph& graph,
                owl::Ontology& ontology) {
  for (std::uint32_t number = 0; number < graph.node_count(); ++number) {
    const NodeId node{number};
    if (!graph.is_iri(node) || graph.about(node).empty()) continue;
    if (!types.is_class(node) && !expressions.is_mapped_class(node)) continue;
    for (const std::uint32_t about : graph.about(node)) {
      const Triple& triple = graph.triple(about);
      const Word predicate = word_of(triple.predicate);
      if (predicate != Word::rdfs_label && predicate != Word::skos_pref_label) continue;
      const Node label = graph.node(triple.object);
      if (label.kind != NodeKind::literal) continue;
      ontology.add_label(graph.text(node), label.text,
                         label.language == NodeId{} ? std::string_view() : graph.text(label.language));
    }
  }
}

/// Names the triples of OWL's vocabulary that nothing used.
void leave_out_unused(TripleReader& triples, const NodeTypes& types, DataRangeMapper& ranges,
                      ExpressionMapper& expressions, AxiomWriter& axioms) {
  const Graph& graph = triples.graph();
  for (std::uint32_t number = 0; number < graph.triple_count(); ++number) {
    if (triples.is_used(number)) continue;
    const auto& [subject, predicate, object, line] = graph.triple(number);
    const std::string_view iri = graph.text(predicate);
    // A class expression in no axiom says nothing, but it must be one.
    if (graph.is_blank(subject) && iri.starts_with(syntax::owl_namespace)) {
      if (expressions.was_tried_as_class(subject) || ranges.was_tried(subject)) continue;  // counted where it was used
      const Mapped mapped = types.is_data_range(subject)                 ? ranges.data_range(subject)
                            : predicate == node_of(Word::owl_inverse_of) ? expressions.object_property(subject)
                                                                         : expressions.class_expression(subject);
      if (!mapped) axioms.leave_out(number, mapped.error());
      for (const std::uint32_t other : graph.about(subject)) triples.use(other);
      continue;
    }
    if (iri.starts_with(syntax::owl_namespace) || predicate == node_of(Word::rdfs_domain) ||
        predicate == node_of(Word::rdfs_range))
      axioms.leave_out(number, syntax::short_word(iri));
  }
}

}  // namespace

void map_to_axioms(const Graph& graph, owl::Ontology& ontology, std::vector<owl::FileId> files) {
  TripleReader triples(graph);
  const NodeTypes types(triples);
  DataRangeMapper ranges(triples, ontology);
  ExpressionMapper expressions(triples, types, ranges, ontology);
  AxiomWriter axioms(graph, ontology, std::move(files));
  AxiomMapper mapper(triples, types, ranges, expressions, axioms);
  for (std::uint32_t number = 0; number < graph.triple_count(); ++number) {
    if (!triples.is_used(number)) mapper.map(number);
  }
  add_labels(types, expressions, graph, ontology);
  leave_out_unused(triples, types, ranges, expressions, axioms);
}

}  // namespace geminga::rdf
