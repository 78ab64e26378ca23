// From the elements of one file to axioms. Each open element keeps its place on a stack of operands, and takes the
// operands above it when it ends. The grammar of the functional syntax, which has the same words, says what may stand
// in an element.
#ifndef GEMINGA_REASONING_SYNTAX_OWLXML_BUILDER_HPP
#define GEMINGA_REASONING_SYNTAX_OWLXML_BUILDER_HPP

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "reasoning/owl/source.hpp"
#include "reasoning/syntax/document/head.hpp"
#include "reasoning/syntax/document/name_annotations.hpp"
#include "reasoning/syntax/functional/grammar.hpp"
#include "reasoning/syntax/owlxml/elements.hpp"
#include "reasoning/syntax/owlxml/read.hpp"

namespace geminga::owlxml {

/// Builds the axioms of one file, once.
class Builder final : public Listener {
 public:
  /// All arguments must outlive it.
  Builder(std::string_view bytes, owl::FileId file, owl::Ontology& source, const XmlLimits& limits,
          std::vector<owl::Annotation>* annotations);

  Refusal begin(std::string_view space, std::string_view name, std::span<const Attribute> attributes,
                std::uint32_t line) override;
  Refusal text(std::string_view part, std::uint32_t line) override;
  Refusal end(std::uint32_t line) override;

  /// Requires that the file has ended.
  [[nodiscard]] Document take_document() { return std::move(document_); }

 private:
  /// The role of an element. `production`: its word means the same in the functional syntax.
  enum class Role : std::uint8_t { production, ontology, prefix, literal, facet, iri, short_iri, blank, left_out };

  /// An open element.
  struct Open {
    const functional::Production* production = nullptr;
    Role role = Role::production;
    bool is_annotation = false;  ///< it is in an annotation, and nothing in it becomes a term
    std::size_t first = 0;       ///< its operands begin here
    std::uint32_t line = 0;
    std::uint32_t number = 0;     ///< cardinality
    std::size_t bases = 0;        ///< the number of xml:base around it
    std::size_t annotations = 0;  ///< the place of the first annotation in it
    std::string name{};           ///< of a variable or built-in: its IRI
  };

  /// An operand in an element that is still open.
  struct Operand {
    enum class Kind : std::uint8_t { term, iri, text, annotation } kind = Kind::term;
    owl::TermId term{};
    std::string iri;       ///< of an entity or an IRI in annotations
    std::string text;      ///< of a literal in annotations
    std::string language;  ///< of a literal in annotations
    std::string datatype;  ///< of a literal in annotations
  };

  /// A fault that is no fault of the XML. What stands at `depth` is passed over until its end.
  struct Fault {
    std::size_t depth = 0;
    std::string text;
    std::uint32_t line = 0;
  };

  // builder.cpp: the document.
  Refusal begin_ontology(std::span<const Attribute> attributes, std::uint32_t line);
  Refusal begin_prefix(std::span<const Attribute> attributes, std::uint32_t line);
  /// The form of an element's production. An element without one has the form of no element.
  static functional::Form form_of(const Open& open) {
    return open.production == nullptr ? functional::Form::document : open.production->form;
  }
  Refusal end_import(const Open& open);
  Refusal begin_element(std::string_view space, std::string_view name, std::span<const Attribute> attributes,
                        Open& open);
  Refusal open_element(std::string_view name, std::span<const Attribute> attributes, Open& open);
  /// Whether an element of this name is a literal, an IRI or part of one, which has no production.
  static bool is_leaf(std::string_view name);
  Refusal open_leaf(std::string_view name, std::span<const Attribute> attributes, Open& open);
  /// Opens an element by its production, which says what it is.
  Refusal open_production(std::string_view name, std::span<const Attribute> attributes, Open& open);
  Refusal cardinality(std::string_view name, std::span<const Attribute> attributes, Open& open);
  Refusal close_element(const Open& open);

  // builder_faults.cpp: what is not as the grammar has it.
  /// Refuses the file: a limit was exceeded.
  Refusal beyond_limit(std::string text);
  /// Gives the refusal where it is about a limit. Anything else costs the annotation or the axiom around the innermost
  /// element: what remains of it is passed over.
  Refusal settle(Refusal refusal, std::uint32_t line);
  /// Names what was passed over, at the end of its element.
  void end_fault(const Open& open);
  /// Something that costs nothing.
  void remark(std::string_view text, std::uint32_t line);

  // builder_elements.cpp: the ends of elements.
  Refusal end_expression(const Open& open);
  /// The end of a variable, a built-in, or the body or head of a rule.
  Refusal end_part_of_rule(const Open& open);
  Refusal end_axiom(const Open& open);
  Refusal end_annotation(const Open& open);
  Refusal end_annotation_assertion(const Open& open);
  Refusal check_operands(const Open& open);
  Refusal check_n_ary_data(const Open& open);
  Refusal expected(std::string_view what, const Open& open, std::size_t place) const;
  [[nodiscard]] bool fits(functional::Operand wanted, const Operand& operand) const;
  void add(owl::AxiomKind kind, const Open& open);
  /// Adds an axiom that the grammar's table describes. One over too short a list may say something else, or nothing.
  void add_list_or_other(const Open& open);
  void drop_annotations(const Open& open);
  /// Adds an annotation with this value.
  void keep(owl::Annotation annotation, const Operand& value, std::size_t level);

  // builder_names.cpp: names and literals.
  Refusal entity(const Open& open, std::span<const Attribute> attributes);
  /// Reads the IRI of a variable or built-in of a rule.
  Refusal named_part(Open& open, std::span<const Attribute> attributes);
  Refusal end_literal(const Open& open);
  Refusal end_facet(const Open& open);
  Refusal end_iri(const Open& open);
  Refusal blank(const Open& open, std::span<const Attribute> attributes);
  Refusal full_iri(std::string_view written, std::string& iri);
  Refusal short_iri(std::string_view written, std::string& iri);
  Refusal check_iri(std::string_view iri);

  const std::string_view bytes_;
  const owl::FileId file_;
  owl::Ontology& source_;
  const XmlLimits& limits_;
  owl::AnnotationStack annotations_;
  Document document_;
  std::string space_;  ///< the namespace of <Ontology>, which OWL/XML's elements may have
  std::vector<Open> open_;
  std::vector<Operand> operands_;
  std::vector<std::string> bases_;
  document::Head head_;
  document::NameAnnotations names_;
  std::unordered_set<owl::TermId> declared_;
  std::string blank_prefix_;        ///< the same for the same file on every host: made of its content
  std::string text_;                ///< of the element that is open and may hold one
  std::string literal_datatype_;    ///< of the literal that is open
  std::string literal_language_;    ///< of the literal that is open
  std::string facet_iri_;           ///< of the facet restriction that is open
  const char* obstacle_ = nullptr;  ///< the part of the current axiom that has no term
  std::optional<Fault> fault_;
  bool is_beyond_limit_ = false;
  std::set<std::string, std::less<>> named_faults_;
};

}  // namespace geminga::owlxml

#endif
