#include "reasoning/syntax/rdf/mapping/annotation_mapper.hpp"

#include <utility>

namespace geminga::rdf {

using owl::Annotation;
using syntax::Word;

namespace {

constexpr std::size_t max_levels = 512;  ///< of annotations of annotations, as in the other syntaxes

NodeId only_object(const Graph& graph, NodeId subject, Word predicate) {
  const auto found = graph.about(subject, predicate);
  return found.size() == 1 ? graph.triple(found.front()).object : NodeId{};
}

}  // namespace

void AnnotationMapper::run(std::vector<Annotation>& into) {
  std::vector<std::uint32_t> waiting;  // about a reified axiom or annotation
  for (std::uint32_t number = 0; number < graph_.triple_count(); ++number) {
    if (!is_annotation(number)) continue;
    const NodeId subject = graph_.triple(number).subject;
    if (only_object(graph_, subject, Word::owl_annotated_source) != NodeId{}) {
      waiting.push_back(number);
    } else if (auto annotation = about_subject(number)) {
      add(number, std::move(*annotation), into);
    }
  }
  // An annotation of an annotation follows it, in whatever order their triples stand.
  for (std::size_t level = 0; level < max_levels && !waiting.empty(); ++level) {
    std::vector<std::uint32_t> left;
    for (const std::uint32_t number : waiting) {
      if (auto annotation = about_reified(graph_.triple(number).subject)) {
        add(number, std::move(*annotation), into);
      } else {
        left.push_back(number);
      }
    }
    if (left.size() == waiting.size()) return;
    waiting = std::move(left);
  }
}

bool AnnotationMapper::is_annotation(std::uint32_t number) const {
  const Triple& triple = graph_.triple(number);
  if (axioms_.axiom_of(number)) return false;
  const bool is_of_rule =
      graph_.is_blank(triple.subject) && graph_.has(triple.subject, node_of(Word::rdf_type), node_of(Word::swrl_imp));
  if (is_of_rule && word_of(triple.predicate) == Word::none) return true;
  switch (word_of(triple.predicate)) {
    case Word::none:
      return types_.is_annotation_property(triple.predicate) ||
             (!types_.is_property(triple.predicate) &&
              !graph_.text(triple.predicate).starts_with(syntax::owl_namespace) &&
              !graph_.text(triple.predicate).starts_with(syntax::rdf_namespace) &&
              !graph_.text(triple.predicate).starts_with(syntax::xsd_namespace));  // facets
    case Word::owl_version_iri:
      return true;
    case Word::rdfs_sub_property_of:
    case Word::rdfs_domain:
    case Word::rdfs_range:
      return types_.is_annotation_property(triple.subject) && graph_.is_iri(triple.object);
    default:
      return types_.is_annotation_property(triple.predicate);
  }
}

/// An annotation of a name, of an ontology, or of an axiom that has a node of its own.
std::optional<Annotation> AnnotationMapper::about_subject(std::uint32_t number) {
  const Triple& triple = graph_.triple(number);
  Annotation annotation;
  if (graph_.has(triple.subject, node_of(Word::rdf_type), node_of(Word::owl_ontology))) {
    annotation.of = Annotation::Of::ontology;
    annotation.number = static_cast<std::uint32_t>(axioms_.file_of(number));
    return annotation;
  }
  if (graph_.is_blank(triple.subject)) {
    for (const std::uint32_t about : graph_.about(triple.subject, Word::rdf_type)) {
      if (auto found = about_triple(about); found && found->of != Annotation::Of::name &&
                                            ontology_.axiom(found->number).kind != owl::AxiomKind::class_assertion)
        return found;
    }
    if (expressions_.was_tried_as_class(triple.subject)) return std::nullopt;  // an expression has no annotations
  }
  const auto name = name_of(triple.subject);
  if (!name) return std::nullopt;
  annotation.subject = *name;
  return annotation;
}

std::optional<Annotation> AnnotationMapper::about_reified(NodeId node) {
  const auto annotated = annotated_triple(node);
  return annotated ? about_triple(*annotated) : std::nullopt;
}

std::optional<Annotation> AnnotationMapper::about_triple(std::uint32_t number) const {
  Annotation annotation;
  if (annotation_of_[number] != none) {
    annotation.of = Annotation::Of::annotation;
    annotation.number = annotation_of_[number];
    return annotation;
  }
  const auto axiom = axioms_.axiom_of(number);
  if (!axiom) return std::nullopt;
  annotation.of = axiom->is_ill_typed ? Annotation::Of::ill_typed : Annotation::Of::axiom;
  annotation.number = axiom->number;
  return annotation;
}

/// The triple that an owl:Axiom or owl:Annotation is about. Writers repeat a blank node's description instead of its
/// name.
std::optional<std::uint32_t> AnnotationMapper::annotated_triple(NodeId node) {
  const NodeId source = only_object(graph_, node, Word::owl_annotated_source);
  const NodeId property = only_object(graph_, node, Word::owl_annotated_property);
  const NodeId target = only_object(graph_, node, Word::owl_annotated_target);
  if (source == NodeId{} || property == NodeId{} || target == NodeId{}) return std::nullopt;
  std::optional<std::uint32_t> alike;
  const bool is_described = graph_.is_blank(target) && !graph_.has(source, property, target);
  const Mapped described = is_described ? expressions_.class_expression(target) : Mapped(std::unexpected(""));
  for (const std::uint32_t number : graph_.about(source)) {
    const Triple& triple = graph_.triple(number);
    if (triple.predicate != property) continue;
    if (triple.object == target) return number;
    const auto axiom = axioms_.axiom_of(number);
    if (!described || !axiom || axiom->is_ill_typed || alike) continue;
    const auto arguments = ontology_.axiom(axiom->number).arguments;
    if (arguments.size() == 2 && arguments[1] == *described) alike = number;
  }
  return alike;
}

std::optional<std::string> AnnotationMapper::name_of(NodeId node) {
  if (graph_.is_iri(node)) return std::string(graph_.text(node));
  const Mapped individual = expressions_.individual(node);
  if (!individual) return std::nullopt;
  return std::string(ontology_.name_of(*individual));
}

void AnnotationMapper::add(std::uint32_t number, Annotation annotation, std::vector<Annotation>& into) {
  const Triple& triple = graph_.triple(number);
  annotation.property = graph_.text(triple.predicate);
  annotation.is_literal = graph_.is_literal(triple.object);
  if (annotation.is_literal) {
    const Node value = graph_.node(triple.object);
    annotation.value = value.text;
    if (value.datatype != NodeId{}) annotation.datatype = graph_.text(value.datatype);
    if (value.language != NodeId{}) annotation.language = graph_.text(value.language);
  } else {
    const auto name = name_of(triple.object);
    if (!name) return;
    annotation.value = *name;
  }
  annotation_of_[number] = static_cast<std::uint32_t>(into.size());
  into.push_back(std::move(annotation));
}

}  // namespace geminga::rdf
