// The functional-style syntax: one axiom a line.
#ifndef GEMINGA_REASONING_SYNTAX_WRITING_FUNCTIONAL_FORM_HPP
#define GEMINGA_REASONING_SYNTAX_WRITING_FUNCTIONAL_FORM_HPP

#include <cstddef>

#include "reasoning/syntax/writing/form.hpp"
#include "reasoning/syntax/writing/names.hpp"
#include "reasoning/syntax/writing/output.hpp"

namespace geminga::writing {

class FunctionalForm final : public Form {
 public:
  FunctionalForm(const Names& names, Output& output) : names_(names), output_(output) {}

  void begin(const Document& document) override;
  void end() override;
  void open(std::string_view word, std::optional<std::uint32_t> number) override;
  void close(std::string_view word) override;
  void open_group() override { open({}, std::nullopt); }
  void close_group() override { close({}); }
  void open_facet(std::string_view iri) override { name(iri); }
  void close_facet() override {}
  void entity(owl::TermKind, std::string_view iri) override { name(iri); }
  void declared(owl::TermKind kind, std::string_view iri) override;
  void name(std::string_view iri) override;
  void blank(std::string_view name) override;
  void variable(std::string_view iri) override;
  void open_built_in(std::string_view iri) override;
  void literal(std::string_view lexical, std::string_view datatype, std::string_view language) override;

 private:
  void separate();
  void write(std::string_view iri);

  const Names& names_;
  Output& output_;
  std::size_t depth_ = 0;
  bool needs_space_ = false;
};

}  // namespace geminga::writing

#endif
