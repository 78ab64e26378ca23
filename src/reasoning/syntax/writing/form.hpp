// The parts of a document in the functional-style syntax and in OWL/XML, which have the same structure: what differs is
// how a part looks.
#ifndef GEMINGA_REASONING_SYNTAX_WRITING_FORM_HPP
#define GEMINGA_REASONING_SYNTAX_WRITING_FORM_HPP

#include <cstdint>
#include <optional>
#include <string_view>

#include "reasoning/owl/axiom.hpp"
#include "reasoning/syntax/writing/document.hpp"

namespace geminga::writing {

/// Looks of the parts. Parts stand between begin() and end(), and in each other between open() and close().
class Form {
 public:
  virtual ~Form() = default;

  virtual void begin(const Document& document) = 0;
  virtual void end() = 0;
  /// An expression, axiom or annotation with its word, and the number of a cardinality.
  virtual void open(std::string_view word, std::optional<std::uint32_t> number = std::nullopt) = 0;
  virtual void close(std::string_view word) = 0;
  /// The object or data properties of a key.
  virtual void open_group() = 0;
  virtual void close_group() = 0;
  virtual void open_facet(std::string_view iri) = 0;
  virtual void close_facet() = 0;
  virtual void entity(owl::TermKind kind, std::string_view iri) = 0;
  /// An entity that is declared.
  virtual void declared(owl::TermKind kind, std::string_view iri) = 0;
  /// An IRI of no kind: the subject or the value of an annotation.
  virtual void name(std::string_view iri) = 0;
  virtual void blank(std::string_view name) = 0;
  /// A variable of a rule, and an atom whose built-in has this IRI; close() ends the second.
  virtual void variable(std::string_view iri) = 0;
  virtual void open_built_in(std::string_view iri) = 0;
  /// An empty datatype means xsd:string, or rdf:langString if there is a language.
  virtual void literal(std::string_view lexical, std::string_view datatype, std::string_view language) = 0;
};

}  // namespace geminga::writing

#endif
