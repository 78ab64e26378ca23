#include "reasoning/syntax/writing/functional_form.hpp"

namespace geminga::writing {

void FunctionalForm::begin(const Document& document) {
  for (const auto& [prefix, iri] : names_.prefixes()) output_.add({"Prefix(", prefix, ":=<", iri, ">)\n"});
  output_.add("\nOntology(");
  if (!document.iri.empty()) output_.add({"<", document.iri, ">"});
  if (!document.iri.empty() && !document.version_iri.empty()) output_.add({" <", document.version_iri, ">"});
  output_.add("\n");
  for (const std::string& import : document.imports) output_.add({"Import(<", import, ">)\n"});
}

void FunctionalForm::end() { output_.add(")\n"); }

void FunctionalForm::separate() {
  if (needs_space_) output_.add(" ");
  needs_space_ = true;
}

void FunctionalForm::open(std::string_view word, std::optional<std::uint32_t> number) {
  separate();
  output_.add({word, "("});
  if (number) output_.add(std::to_string(*number));
  needs_space_ = number.has_value();
  ++depth_;
}

void FunctionalForm::close(std::string_view /*word*/) {
  output_.add(")");
  needs_space_ = --depth_ > 0;
  if (depth_ == 0) output_.add("\n");
}

void FunctionalForm::declared(owl::TermKind kind, std::string_view iri) {
  open(owl::to_string(kind), std::nullopt);
  name(iri);
  close({});
}

void FunctionalForm::name(std::string_view iri) {
  separate();
  write(iri);
}

void FunctionalForm::write(std::string_view iri) {
  if (!is_writable(iri)) return output_.fail(unwritable(iri));
  output_.add(names_.written(iri));
}

void FunctionalForm::blank(std::string_view name) {
  separate();
  output_.add(Names::blank(name));
}

void FunctionalForm::variable(std::string_view iri) {
  open("Variable", std::nullopt);
  name(iri);
  close({});
}

void FunctionalForm::open_built_in(std::string_view iri) {
  open("BuiltInAtom", std::nullopt);
  name(iri);
}

void FunctionalForm::literal(std::string_view lexical, std::string_view datatype, std::string_view language) {
  separate();
  output_.add("\"");
  for (std::size_t at = lexical.find_first_of("\"\\"); at != std::string_view::npos;
       at = lexical.find_first_of("\"\\")) {
    output_.add({lexical.substr(0, at), "\\", lexical.substr(at, 1)});
    lexical.remove_prefix(at + 1);
  }
  output_.add({lexical, "\""});
  if (!language.empty()) return output_.add({"@", language});
  if (datatype.empty() || datatype == "http://www.w3.org/2001/XMLSchema#string") return;
  output_.add("^^");
  write(datatype);
}

}  // namespace geminga::writing
