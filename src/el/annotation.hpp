// What is said about a name beside its axioms: it means nothing to the reasoner, and is kept for those who write it
// again.
#ifndef GEMINGA_EL_ANNOTATION_HPP
#define GEMINGA_EL_ANNOTATION_HPP

#include <string>

namespace geminga::el {

/// An annotation of an entity or an ontology by an IRI or a literal.
struct Annotation {
  std::string subject;   ///< an IRI
  std::string property;  ///< an IRI
  bool is_literal = false;
  std::string value;     ///< an IRI, or a lexical form
  std::string datatype;  ///< of literals; empty: xsd:string, or one with a language
  std::string language;  ///< of literals, in lower case
};

}  // namespace geminga::el

#endif
