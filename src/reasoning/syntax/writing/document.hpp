// An ontology as one document: axioms, annotations, and its head.
#ifndef GEMINGA_REASONING_SYNTAX_WRITING_DOCUMENT_HPP
#define GEMINGA_REASONING_SYNTAX_WRITING_DOCUMENT_HPP

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "reasoning/owl/annotation.hpp"
#include "reasoning/owl/source.hpp"

namespace geminga::writing {

/// The parts must outlive it.
struct Document {
  const owl::Ontology& source;
  const owl::Annotations& annotations;
  std::string iri;          ///< empty: the ontology has no name
  std::string version_iri;  ///< empty: none
  std::vector<std::string> imports;
  /// The axioms to write, by number, in this order. Those with an ill-typed literal are written behind them as they
  /// were read.
  std::vector<std::uint32_t> axioms;
  bool has_ill_typed = true;
  bool has_annotations = true;
};

/// The readers give the version of an ontology as its annotation with this property.
inline constexpr std::string_view version_property = "http://www.w3.org/2002/07/owl#versionIRI";

/// Whether an annotation belongs to the document's ontology, and not to that of another file. The version does not.
[[nodiscard]] bool is_of_ontology(const Document& document, const owl::Annotation& annotation);
/// Whether an annotation is about a name, other than that of another file's ontology.
[[nodiscard]] bool is_of_name(const Document& document, const owl::Annotation& annotation);

}  // namespace geminga::writing

#endif
