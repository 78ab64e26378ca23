// The order of the passes: the types of nodes, the axioms, the labels, and the triples that no axiom used.
#include "reasoning/syntax/rdf/mapping/mapping.hpp"

#include <cstdint>
#include <map>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "reasoning/owl/outside_names.hpp"
#include "reasoning/owl/unit.hpp"
#include "reasoning/syntax/rdf/mapping/annotation_mapper.hpp"
#include "reasoning/syntax/rdf/mapping/axiom_mapper.hpp"
#include "reasoning/syntax/rdf/mapping/rule_mapper.hpp"

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
      const bool is_label = predicate == Word::rdfs_label || predicate == Word::skos_pref_label;
      if (!is_label && !owl::is_outside_name(graph.text(triple.predicate))) continue;
      const Node label = graph.node(triple.object);
      if (label.kind != NodeKind::literal) continue;
      ontology.add_label(graph.text(node), label.text,
                         label.language == NodeId{} ? std::string_view() : graph.text(label.language));
    }
  }
}

/// The node of an IRI; none where no triple has it.
NodeId node_named(const Graph& graph, std::string_view iri) {
  for (std::uint32_t number = 0; number < graph.node_count(); ++number) {
    if (graph.is_iri(NodeId{number}) && graph.text(NodeId{number}) == iri) return NodeId{number};
  }
  return NodeId{};
}

/// The object of a subject's only triple with this predicate; none otherwise.
NodeId only(const Graph& graph, NodeId subject, Word predicate) {
  const auto found = graph.about(subject, predicate);
  return found.size() == 1 ? graph.triple(found.front()).object : NodeId{};
}

/// Conversions are annotations of classes, and their costs annotations of those.
void add_conversions(const Graph& graph, const std::vector<owl::FileId>& files, owl::Ontology& ontology) {
  const NodeId converts = node_named(graph, owl::converts_to);
  const NodeId costs = node_named(graph, owl::conversion_cost);
  if (converts == NodeId{} && costs == NodeId{}) return;
  const auto leave_out = [&](std::string_view construct, std::uint32_t number) {
    ontology.leave_out(construct, files[graph.file_of(number)], graph.triple(number).line);
  };
  std::vector<std::uint32_t> conversions;
  std::multimap<std::pair<NodeId, NodeId>, std::uint32_t> cost_of;  // by triple
  for (std::uint32_t number = 0; number < graph.triple_count(); ++number) {
    const Triple& triple = graph.triple(number);
    if (converts != NodeId{} && triple.predicate == converts) {
      if (graph.is_iri(triple.subject) && graph.is_iri(triple.object)) {
        conversions.push_back(number);
      } else {
        const bool has_literal = graph.node(triple.object).kind == NodeKind::literal;
        leave_out(has_literal ? owl::conversion_to_literal : owl::conversion_without_name, number);
      }
    } else if (costs != NodeId{} && triple.predicate == costs) {
      const bool is_of_conversion =
          converts != NodeId{} && only(graph, triple.subject, Word::owl_annotated_property) == converts;
      const std::pair of(only(graph, triple.subject, Word::owl_annotated_source),
                         only(graph, triple.subject, Word::owl_annotated_target));
      cost_of.emplace(is_of_conversion ? of : std::pair(NodeId{}, NodeId{}), number);
    }
  }
  std::set<std::pair<NodeId, NodeId>> stated;
  for (const std::uint32_t number : conversions) {
    const Triple& triple = graph.triple(number);
    const owl::FileId file = files[graph.file_of(number)];
    const auto [first, last] = cost_of.equal_range({triple.subject, triple.object});
    if (first == last)
      ontology.add_conversion(graph.text(triple.subject), graph.text(triple.object), {}, file, triple.line);
    for (auto cost = first; cost != last; ++cost) {
      const Triple& of_cost = graph.triple(cost->second);
      ontology.add_conversion(graph.text(triple.subject), graph.text(triple.object), graph.text(of_cost.object), file,
                              triple.line, of_cost.line);
    }
    stated.emplace(triple.subject, triple.object);
  }
  for (const auto& [of, number] : cost_of) {
    if (!stated.contains(of)) leave_out(owl::cost_of_nothing, number);
  }
}

/// Statements of units are read from triples, because QUDT and OM declare their properties as annotation properties, as
/// others, or not at all.
void add_unit_statements(const Graph& graph, const std::vector<owl::FileId>& files, owl::Ontology& ontology) {
  std::vector<owl::UnitWord> words(graph.node_count(), owl::UnitWord::none);
  bool has_any = false;
  for (std::uint32_t number = 0; number < graph.node_count(); ++number) {
    if (!graph.is_iri(NodeId{number})) continue;
    const std::string_view iri = graph.text(NodeId{number});
    words[number] = owl::is_unit_class(iri) ? owl::UnitWord::type : owl::unit_word(iri);
    has_any = has_any || words[number] != owl::UnitWord::none;
  }
  if (!has_any) return;
  for (std::uint32_t number = 0; number < graph.triple_count(); ++number) {
    const Triple& triple = graph.triple(number);
    const bool is_type = triple.predicate == node_of(Word::rdf_type);
    const owl::UnitWord word = words[static_cast<std::size_t>(is_type ? triple.object : triple.predicate)];
    if (word == owl::UnitWord::none || is_type != (word == owl::UnitWord::type)) continue;
    if (!graph.is_iri(triple.subject) || graph.is_blank(triple.object)) continue;
    ontology.add_unit_statement(graph.text(triple.subject), word, graph.text(triple.object),
                                files[graph.file_of(number)], triple.line);
  }
}

/// Fetches into the cache what the mapping of triples to come reads: what each node became, and when that is there, the
/// term.
void prefetch(const TripleReader& triples, std::uint32_t number, const ExpressionMapper& expressions) {
  if (const Triple* later = triples.ahead(number, 32)) {
    expressions.prefetch(later->object);
    expressions.prefetch(later->subject);
  }
  if (const Triple* later = triples.ahead(number, 12)) {
    expressions.prefetch_term(later->object);
    expressions.prefetch_term(later->subject);
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

void map_to_axioms(const Graph& graph, owl::Ontology& ontology, std::vector<owl::FileId> files,
                   std::vector<owl::Annotation>* annotations) {
  add_conversions(graph, files, ontology);
  add_unit_statements(graph, files, ontology);
  TripleReader triples(graph);
  const NodeTypes types(triples);
  AxiomWriter axioms(graph, ontology, std::move(files));
  if (annotations != nullptr) axioms.remember_places();
  DataRangeMapper ranges(triples, axioms, ontology);
  ExpressionMapper expressions(triples, types, ranges, axioms, ontology);
  RuleMapper(triples, types, ranges, expressions, axioms, ontology).map_all();
  AxiomMapper mapper(triples, types, ranges, expressions, axioms);
  for (std::uint32_t number = 0; number < graph.triple_count(); ++number) {
    prefetch(triples, number, expressions);
    if (!triples.is_used(number)) mapper.map(number);
  }
  add_labels(types, expressions, graph, ontology);
  if (annotations != nullptr) AnnotationMapper(graph, types, expressions, axioms, ontology).run(*annotations);
  leave_out_unused(triples, types, ranges, expressions, axioms);
}

}  // namespace geminga::rdf
