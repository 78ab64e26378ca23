// The words of the functional-style syntax, and what stands between their brackets, as a table.
#ifndef GEMINGA_REASONING_SYNTAX_FUNCTIONAL_GRAMMAR_HPP
#define GEMINGA_REASONING_SYNTAX_FUNCTIONAL_GRAMMAR_HPP

#include <array>
#include <cstdint>
#include <string_view>

#include "reasoning/owl/axiom.hpp"

namespace geminga::functional {

/// The roles that a term can have as an operand.
enum class Operand : std::uint8_t {
  none,
  named_class,
  class_expression,
  named_object_property,
  object_property,  ///< a name or an inverse
  property_chain,   ///< a chain, or an object property
  data_property,
  datatype,
  data_range,
  individual,
  literal,
  facet,  ///< an IRI and a literal
  // Of rules.
  rule_argument,  ///< an individual, a literal or a variable
  atom,
  body,  ///< atoms in brackets
  head,  ///< the same
};

/// The kind of production that a word begins. The parser reads it by a function of its own or by its operands.
enum class Form : std::uint8_t {
  document,    ///< Prefix, Ontology: outside of the ontology's brackets
  import,      ///< Import
  annotation,  ///< Annotation
  entity,      ///< Class and its like, in declarations
  expression,  ///< a term: its operands
  variable,    ///< an expression that is an IRI
  built_in,    ///< an IRI, and arguments
  atoms,       ///< none or more
  n_ary_data,  ///< DataSomeValuesFrom and DataAllValuesFrom: data properties, and a data range of as many values
  axiom,       ///< its operands
  declaration,
  has_key,
  annotation_assertion,  ///< AnnotationAssertion
  annotation_axiom,      ///< the other three about annotation properties
  extension,             ///< not of OWL 2, but written by tools: skipped, and left out by name
};

/// One word. Behind its opening bracket stand a number where `is_counted`, then `first`, then at most one `optional`,
/// then one or more `repeated`.
struct Production {
  std::string_view word;
  Form form = Form::axiom;
  std::uint8_t kind = 0;           ///< of owl::TermKind or owl::AxiomKind
  Operand result = Operand::none;  ///< of expressions: what they may stand for
  bool is_counted = false;
  std::array<Operand, 3> first{};
  Operand optional = Operand::none;
  Operand repeated = Operand::none;

  [[nodiscard]] owl::TermKind term() const { return static_cast<owl::TermKind>(kind); }
  [[nodiscard]] owl::AxiomKind axiom() const { return static_cast<owl::AxiomKind>(kind); }
  /// Whether `repeated` may stand no time, as in OWL 1. A chain of no property would be the identity, which OWL has
  /// not.
  [[nodiscard]] bool may_be_empty() const {
    return form == Form::axiom || (form == Form::expression && term() != owl::TermKind::object_property_chain);
  }
};

/// The production of a word, or nullptr where the grammar has no such word.
[[nodiscard]] const Production* find_production(std::string_view word);

/// "a class expression".
[[nodiscard]] std::string_view to_string(Operand operand);

}  // namespace geminga::functional

#endif
