// Annotations: what is said about a name or an axiom beside the axioms. They mean nothing to the reasoner. They are
// kept for programs that write an ontology again.
#ifndef GEMINGA_REASONING_OWL_ANNOTATION_HPP
#define GEMINGA_REASONING_OWL_ANNOTATION_HPP

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "reasoning/owl/source.hpp"

namespace geminga::owl {

/// One annotation. Its value is an IRI, a literal or an anonymous individual.
struct Annotation {
  /// The kind of its subject.
  enum class Of : std::uint8_t {
    name,        ///< an entity or an anonymous individual
    ontology,    ///< the one in the file `number`
    axiom,       ///< axiom `number` of the source
    ill_typed,   ///< ill-typed axiom `number` of the source
    annotation,  ///< annotation `number` of the list in which this one is
  };
  Of of = Of::name;
  std::uint32_t number = 0;
  std::string subject;   ///< of a name: an IRI, or `_:` and a label as Ontology::anonymous_individual() has it
  std::string property;  ///< an IRI
  bool is_literal = false;
  std::string value;     ///< an IRI, `_:` and a label, or a lexical form
  std::string datatype;  ///< of literals; empty: xsd:string, or one with a language
  std::string language;  ///< of literals, in lower case
};

/// An annotation of a name. The caller fills in the value.
[[nodiscard]] inline Annotation annotation_of(std::string subject, std::string property) {
  Annotation annotation;
  annotation.subject = std::move(subject);
  annotation.property = std::move(property);
  return annotation;
}

/// The property that an axiom about annotation properties stands for in RDF (mapping to RDF, table 1):
/// rdfs:subPropertyOf, rdfs:domain or rdfs:range. `word` is its word in the functional-style syntax, such as
/// SubAnnotationPropertyOf.
[[nodiscard]] std::string property_of_annotation_axiom(std::string_view word);

inline constexpr std::string_view annotation_assertion = "AnnotationAssertion";
inline constexpr std::string_view sub_annotation_property_of = "SubAnnotationPropertyOf";
inline constexpr std::string_view annotation_property_domain = "AnnotationPropertyDomain";
inline constexpr std::string_view annotation_property_range = "AnnotationPropertyRange";
/// The axiom that an annotation of a name is, by its word in the functional-style syntax: one about an annotation
/// property where its value is a name and its property one of property_of_annotation_axiom().
[[nodiscard]] std::string_view annotation_axiom_of(const Annotation& annotation);

/// The annotations of all files, and which of them are about which axiom or annotation.
class Annotations {
 public:
  /// The list must outlive it.
  explicit Annotations(std::span<const Annotation> all);

  [[nodiscard]] const Annotation& at(std::uint32_t number) const { return all_[number]; }
  [[nodiscard]] std::size_t size() const { return all_.size(); }
  /// The numbers of the annotations of ontologies, axioms and annotations, ascending.
  [[nodiscard]] std::span<const std::uint32_t> about(Annotation::Of of, std::uint32_t number) const;

 private:
  std::span<const Annotation> all_;
  std::map<std::pair<Annotation::Of, std::uint32_t>, std::vector<std::uint32_t>> about_;
};

/// Collects annotations in the order in which a reader meets them. They stand before their subjects, and may be
/// annotated themselves.
class AnnotationStack {
 public:
  /// With nullptr nothing is kept.
  explicit AnnotationStack(std::vector<Annotation>* kept) : kept_(kept) {}
  [[nodiscard]] bool is_wanted() const { return kept_ != nullptr; }

  /// Begins the annotations of one axiom, which end with attach() or drop().
  void begin();
  /// Adds an annotation that stands `level` deep: 1 is that of an axiom, 2 an annotation of such an annotation.
  /// Annotations of the level below that were added just before it are its own. An axiom that is itself an annotation
  /// has level 0.
  void add(Annotation annotation, std::size_t level);
  /// Attaches the annotations of level 1 to the axiom that has just been added to the source. They are dropped if none
  /// has been added: the source then has as many axioms as before.
  void attach(const Ontology& source, std::size_t axioms_before, std::size_t ill_typed_before);
  /// Drops them: they are about nothing that is kept.
  void drop();

 private:
  std::vector<Annotation>* kept_;
  std::size_t begin_ = 0;                            ///< of kept_
  std::vector<std::vector<std::uint32_t>> waiting_;  ///< by level
};

}  // namespace geminga::owl

#endif
