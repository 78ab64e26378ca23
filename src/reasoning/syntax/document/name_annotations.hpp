// The annotations of names that mean something here: labels and names from outside, conversions with their costs, and
// statements of units.
#ifndef GEMINGA_REASONING_SYNTAX_DOCUMENT_NAME_ANNOTATIONS_HPP
#define GEMINGA_REASONING_SYNTAX_DOCUMENT_NAME_ANNOTATIONS_HPP

#include <cstdint>
#include <string>
#include <string_view>

#include "reasoning/owl/source.hpp"

namespace geminga::document {

/// The value of an annotation.
struct AnnotationValue {
  enum class Form : std::uint8_t {
    iri,
    blank,
    text,    ///< a literal in quotation marks
    number,  ///< a literal without them
  };
  Form form = Form::iri;
  std::string_view text{};      ///< of a blank node: anything
  std::string_view language{};  ///< of a text
};

/// Adds what annotations say of names to a source, and leaves out by name what they say wrongly.
class NameAnnotations {
 public:
  NameAnnotations(owl::Ontology& source, owl::FileId file) : source_(source), file_(file) {}

  /// Whether add() looks at annotations with this property.
  [[nodiscard]] static bool is_of_interest(std::string_view property);
  /// `subject` is an IRI; empty or `_:...`: what is annotated has no name.
  void add(std::string_view property, std::string_view subject, const AnnotationValue& value, std::uint32_t line);

  /// The cost of the conversion that the next annotation states, if it states one.
  void set_cost(std::string_view cost, std::uint32_t line);
  /// Another annotation or axiom begins.
  void forget_cost() { cost_.clear(); }

 private:
  void add_conversion(std::string_view subject, bool has_name, const AnnotationValue& value, std::uint32_t line);

  owl::Ontology& source_;
  owl::FileId file_;
  std::string cost_;
  std::uint32_t cost_line_ = 0;
};

}  // namespace geminga::document

#endif
