// Annotations (mapping to RDF, section 2.3). They are triples of the axiom's own node, if it has one. For an axiom that
// is one triple they are those of an owl:Axiom, and for an annotation those of an owl:Annotation, with the triple's
// subject, predicate and object.
#include "reasoning/owl/loaded_file.hpp"
#include "reasoning/syntax/graph/axioms/axiom_triples.hpp"

namespace geminga::graph {

using owl::Annotation;

Node AxiomTriples::reify(const Triple& triple, std::string_view type) {
  const Node made = fresh();
  const std::string owl(syntax::owl_namespace);
  link(made, rdf_type, owl_word(type));
  link(made, owl + "annotatedSource", triple.subject);
  link(made, owl + "annotatedProperty", triple.predicate);
  link(made, owl + "annotatedTarget", triple.object);
  return made;
}

/// The readers bound how deep annotations nest.
void AxiomTriples::annotate(const Node& holder, const owl::Annotations& annotations, std::span<const std::uint32_t> own,
                            std::string_view type) {
  for (const std::uint32_t number : own) {
    const Annotation& annotation = annotations.at(number);
    Node value{Node::Kind::literal, annotation.value, annotation.language.empty() ? annotation.datatype : "",
               annotation.language};
    if (!annotation.is_literal)
      value = annotation.value.starts_with("_:") ? individual(annotation.value) : iri(annotation.value);
    const Triple triple{holder, iri(annotation.property), std::move(value)};
    link(triple.subject, annotation.property, triple.object);
    const auto nested = annotations.about(Annotation::Of::annotation, number);
    if (!nested.empty()) annotate(reify(triple, type), annotations, nested);
  }
}

void AxiomTriples::annotate(const owl::Annotations& annotations, std::span<const std::uint32_t> own) {
  if (own.empty()) return;
  if (holder_) annotate(*holder_, annotations, own);
  for (const Triple& triple : std::exchange(said_, {})) annotate(reify(triple, "Axiom"), annotations, own);
}

void AxiomTriples::add(const owl::Annotations& annotations, std::uint32_t number) {
  const Annotation& annotation = annotations.at(number);
  const std::uint32_t own[]{number};
  if (annotation.of == Annotation::Of::ontology)
    return annotate(ontology(static_cast<owl::FileId>(annotation.number)), annotations, own);
  // The annotation is an axiom itself.
  const std::string& subject = annotation.subject;
  annotate(subject.starts_with("_:") ? individual(subject) : iri(subject), annotations, own, "Axiom");
}

Node AxiomTriples::ontology(owl::FileId file) const {
  const std::string& name = source_.files()[static_cast<std::size_t>(file)].ontology_iri;
  return name.empty() ? blank("o" + std::to_string(static_cast<std::uint32_t>(file))) : iri(name);
}

}  // namespace geminga::graph
