// What is said about a name or an axiom beside the axioms: it means nothing to the reasoner, and is kept for those who
// write it again.
#ifndef GEMINGA_REASONING_OWL_ANNOTATION_HPP
#define GEMINGA_REASONING_OWL_ANNOTATION_HPP

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "reasoning/owl/source.hpp"

namespace geminga::owl {

/// An annotation by an IRI, a literal or an anonymous individual.
struct Annotation {
  /// What it is about.
  enum class Of : std::uint8_t {
    name,        ///< an entity or an anonymous individual: what says it is an axiom
    ontology,    ///< the one in the file `number`
    axiom,       ///< axiom `number` of the source
    damaged,     ///< damaged axiom `number` of the source
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

/// One of a name, whose value is still to be told.
[[nodiscard]] inline Annotation annotation_of(std::string subject, std::string property) {
  Annotation annotation;
  annotation.subject = std::move(subject);
  annotation.property = std::move(property);
  return annotation;
}

/// SubAnnotationPropertyOf and its like say with a property what others say with an annotation (mapping to RDF, table
/// 1): rdfs:subPropertyOf, rdfs:domain or rdfs:range for a word of the functional-style syntax.
[[nodiscard]] std::string property_of_annotation_axiom(std::string_view word);

/// Puts annotations into a list as a reader comes upon them: those of something before it, which may be annotated
/// itself.
class AnnotationStack {
 public:
  /// nullptr: nobody wants them, and nothing is kept.
  explicit AnnotationStack(std::vector<Annotation>* kept) : kept_(kept) {}
  [[nodiscard]] bool is_wanted() const { return kept_ != nullptr; }

  /// From here on until settle() or drop() all belong to one axiom, or to nothing.
  void begin();
  /// `level` is how many annotations this one stands in, and itself; those of the level below that were added before
  /// it are its own. With level 0 those of level 1 are, as of an axiom that is an annotation.
  void add(Annotation annotation, std::size_t level);
  /// Those of level 1 are about an axiom, which has been added to the source unless that has as many axioms as before.
  void settle(const Ontology& source, std::size_t axioms_before, std::size_t damaged_before);
  /// They are about nothing that is kept.
  void drop();

 private:
  std::vector<Annotation>* kept_;
  std::size_t begin_ = 0;                            ///< of kept_
  std::vector<std::vector<std::uint32_t>> waiting_;  ///< by level
};

}  // namespace geminga::owl

#endif
