// OWL/XML: one element a line, indented.
#ifndef GEMINGA_REASONING_SYNTAX_WRITING_XML_FORM_HPP
#define GEMINGA_REASONING_SYNTAX_WRITING_XML_FORM_HPP

#include <cstddef>

#include "reasoning/syntax/writing/form.hpp"
#include "reasoning/syntax/writing/names.hpp"
#include "reasoning/syntax/writing/output.hpp"

namespace geminga::writing {

class XmlForm final : public Form {
 public:
  XmlForm(const Names& names, Output& output) : names_(names), output_(output) {}

  void begin(const Document& document) override;
  void end() override;
  void open(std::string_view word, std::optional<std::uint32_t> number) override;
  void close(std::string_view word) override;
  void open_group() override {}
  void close_group() override {}
  void open_facet(std::string_view iri) override;
  void close_facet() override { close("FacetRestriction"); }
  void entity(owl::TermKind kind, std::string_view iri) override;
  void declared(owl::TermKind kind, std::string_view iri) override { entity(kind, iri); }
  void name(std::string_view iri) override;
  void blank(std::string_view name) override;
  void variable(std::string_view iri) override;
  void open_built_in(std::string_view iri) override;
  void literal(std::string_view lexical, std::string_view datatype, std::string_view language) override;

 private:
  void indent();
  void escaped(std::string_view text, bool is_attribute);
  void attribute(std::string_view name, std::string_view value);
  /// The attribute of an element that is named by an IRI.
  void named(std::string_view iri);

  const Names& names_;
  Output& output_;
  std::size_t depth_ = 1;
};

}  // namespace geminga::writing

#endif
