#include "readers.hpp"

#include <utility>

#include "frames/read.hpp"
#include "functional/read.hpp"
#include "owlxml/read.hpp"

namespace geminga::ontology {
namespace {

/// What one of these readers gives, in the words of the reader of triples.
template <typename Result>
std::expected<rdf::OtherDocument, rdf::LoadError> converted(Result document, std::vector<el::Annotation> annotations) {
  if (!document)
    return std::unexpected(
        rdf::LoadError{std::move(document.error().file), document.error().line, std::move(document.error().text)});
  rdf::OtherDocument other{
      std::move(document->ontology_iri), std::move(document->version_iri), {}, {}, std::move(annotations)};
  for (auto& import : document->imports) other.imports.push_back({std::move(import.iri), import.line});
  for (auto& prefix : document->prefixes) other.prefixes.emplace_back(std::move(prefix.prefix), std::move(prefix.iri));
  return other;
}

}  // namespace

void Readers::look_ahead(rdf::Syntax syntax, std::string_view bytes) {
  if (syntax == rdf::Syntax::manchester) frames::look_ahead(bytes, declared_);
}

std::expected<rdf::OtherDocument, rdf::LoadError> Readers::read(rdf::Syntax syntax, std::string_view bytes,
                                                                el::FileId file, el::OntologySource& source) {
  std::vector<el::Annotation> annotations;
  std::vector<el::Annotation>* wanted = keeps_annotations_ ? &annotations : nullptr;
  switch (syntax) {
    case rdf::Syntax::functional: {
      auto document = functional::read(bytes, file, source, {}, wanted);
      return converted(std::move(document), std::move(annotations));
    }
    case rdf::Syntax::manchester: {
      if (!has_source_) declared_.add(source);
      has_source_ = true;
      auto document = frames::read(bytes, file, source, declared_, {}, wanted);
      return converted(std::move(document), std::move(annotations));
    }
    case rdf::Syntax::owl_xml: {
      auto document = owlxml::read(bytes, file, source, {}, wanted);
      return converted(std::move(document), std::move(annotations));
    }
    default:
      return std::unexpected(rdf::LoadError{source.files()[static_cast<std::size_t>(file)].path, 0,
                                            "is in " + std::string(rdf::to_string(syntax)) + ", which has triples"});
  }
}

}  // namespace geminga::ontology
