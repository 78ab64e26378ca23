// Annotations in triples: of names, ontologies, axioms and annotations (mapping, tables 15 and 17).
#ifndef GEMINGA_REASONING_SYNTAX_RDF_MAPPING_ANNOTATION_MAPPER_HPP
#define GEMINGA_REASONING_SYNTAX_RDF_MAPPING_ANNOTATION_MAPPER_HPP

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "reasoning/owl/annotation.hpp"
#include "reasoning/owl/source.hpp"
#include "reasoning/syntax/rdf/mapping/axiom_writer.hpp"
#include "reasoning/syntax/rdf/mapping/expression_mapper.hpp"
#include "reasoning/syntax/rdf/mapping/node_types.hpp"
#include "reasoning/syntax/rdf/triples/graph.hpp"

namespace geminga::rdf {

/// Finds the annotations of a graph whose axioms have been mapped. A triple is an annotation if its predicate is an
/// annotation property, or a property of no kind, and it became no axiom.
class AnnotationMapper {
 public:
  AnnotationMapper(const Graph& graph, const NodeTypes& types, ExpressionMapper& expressions, const AxiomWriter& axioms,
                   const owl::Ontology& ontology)
      : graph_(graph),
        types_(types),
        expressions_(expressions),
        axioms_(axioms),
        ontology_(ontology),
        annotation_of_(graph.triple_count(), none) {}

  /// Appends the annotations, each behind what it is about.
  void run(std::vector<owl::Annotation>& into);

 private:
  static constexpr std::uint32_t none = 0xffffffff;

  [[nodiscard]] bool is_annotation(std::uint32_t number) const;
  [[nodiscard]] std::optional<owl::Annotation> about_subject(std::uint32_t number);
  [[nodiscard]] std::optional<owl::Annotation> about_reified(NodeId node);
  [[nodiscard]] std::optional<owl::Annotation> about_triple(std::uint32_t number) const;
  [[nodiscard]] std::optional<std::uint32_t> annotated_triple(NodeId node);
  [[nodiscard]] std::optional<std::string> name_of(NodeId node);
  void add(std::uint32_t number, owl::Annotation annotation, std::vector<owl::Annotation>& into);

  const Graph& graph_;
  const NodeTypes& types_;
  ExpressionMapper& expressions_;
  const AxiomWriter& axioms_;
  const owl::Ontology& ontology_;
  std::vector<std::uint32_t> annotation_of_;  ///< by triple
};

}  // namespace geminga::rdf

#endif
