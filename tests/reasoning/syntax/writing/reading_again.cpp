#include "reasoning/syntax/writing/reading_again.hpp"

#include <algorithm>
#include <numeric>

#include "base/sorted.hpp"
#include "reasoning/owl/canonical.hpp"
#include "reasoning/owl/print.hpp"
#include "reasoning/syntax/frames/read.hpp"
#include "reasoning/syntax/functional/read.hpp"
#include "reasoning/syntax/owlxml/read.hpp"

namespace geminga::writing {
namespace {

std::string whole(std::string_view iri) { return iri.starts_with("_:") ? "_:x" : std::string(iri); }

std::string axiom_text(const owl::Ontology& source, const owl::Axiom& axiom) {
  std::vector<std::string> parts;
  for (const owl::TermId id : axiom.arguments)
    parts.push_back(owl::print(source, id, whole, owl::PrintStyle::document));
  std::sort(parts.begin() + static_cast<std::ptrdiff_t>(owl::set_begin(axiom.kind, parts.size())), parts.end());
  std::string text(owl::to_string(axiom.kind));
  for (const std::string& part : parts) text += " | " + part;
  return text;
}

std::string annotation_text(const Read& read, const owl::Annotation& annotation) {
  std::string about = whole(annotation.subject);
  if (annotation.of == owl::Annotation::Of::ontology) about = "ontology";
  if (annotation.of == owl::Annotation::Of::axiom)
    about = axiom_text(read.source, read.source.axiom(annotation.number));
  if (annotation.of == owl::Annotation::Of::ill_typed)
    about = axiom_text(read.source, read.source.ill_typed(annotation.number));
  if (annotation.of == owl::Annotation::Of::annotation)
    about = annotation_text(read, read.annotations[annotation.number]);
  std::string text = "[" + about + "] " + annotation.property + ' ';
  if (!annotation.is_literal) return text + whole(annotation.value);
  const std::string_view datatype =
      annotation.datatype == "http://www.w3.org/2001/XMLSchema#string" ? std::string_view() : annotation.datatype;
  return text + owl::quoted(annotation.value) + '@' + annotation.language + "^^" + std::string(datatype);
}

}  // namespace

Read read(std::string_view text, syntax::Syntax syntax) {
  Read read;
  const owl::FileId file = read.source.add_file("t");
  std::expected<owl::Document, owl::ReadError> document;
  if (syntax == syntax::Syntax::functional) {
    document = functional::read(text, file, read.source, {.wrong_axioms = 0}, &read.annotations);
  } else if (syntax == syntax::Syntax::owl_xml) {
    document = owlxml::read(text, file, read.source, {}, &read.annotations);
  } else {
    frames::Declared declared;
    frames::look_ahead(text, declared);
    document = frames::read(text, file, read.source, declared, {}, &read.annotations);
  }
  if (!document) {
    read.error = to_string(document.error());
    return read;
  }
  read.iri = document->ontology_iri;
  read.version_iri = document->version_iri;
  for (const owl::Import& import : document->imports) read.imports.push_back(import.iri);
  for (const owl::DeclaredPrefix& prefix : document->prefixes) read.source.add_prefix(prefix.prefix, prefix.iri);
  return read;
}

std::string written(const Read& ontology, syntax::Syntax syntax, const WritingLimits& limits) {
  const owl::Annotations annotations(ontology.annotations);
  Document document{ontology.source, annotations, ontology.iri, ontology.version_iri, ontology.imports, {}};
  document.axioms.resize(ontology.source.axiom_count());
  std::iota(document.axioms.begin(), document.axioms.end(), 0U);
  std::string text;
  const Sink sink = [&](std::string_view piece) {
    text += piece;
    return true;
  };
  const Written result = write(document, syntax, sink, limits);
  return result.problem ? "cannot: " + *result.problem : text;
}

std::vector<std::string> said(const Read& ontology) {
  std::vector<std::string> lines;
  const owl::Ontology& source = ontology.source;
  for (std::size_t number = 0; number < source.axiom_count(); ++number) {
    if (source.axiom(number).kind != owl::AxiomKind::declaration)
      lines.push_back(axiom_text(source, source.axiom(number)));
  }
  for (std::size_t number = 0; number < source.ill_typed_count(); ++number)
    lines.push_back("ill-typed " + axiom_text(source, source.ill_typed(number)));
  for (const owl::Annotation& annotation : ontology.annotations) lines.push_back(annotation_text(ontology, annotation));
  base::sort_unique(lines);
  return lines;
}

}  // namespace geminga::writing
