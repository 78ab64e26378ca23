#include "ontology/loading/readers.hpp"

#include "reasoning/owl/loaded_file.hpp"
#include "reasoning/syntax/frames/read.hpp"
#include "reasoning/syntax/functional/read.hpp"
#include "reasoning/syntax/owlxml/read.hpp"

namespace geminga::ontology {

void Readers::begin() {
  declared_ = {};
  has_source_ = false;
}

void Readers::look_ahead(syntax::Syntax syntax, std::string_view bytes) {
  if (syntax == syntax::Syntax::manchester) frames::look_ahead(bytes, declared_);
}

std::expected<owl::Document, owl::ReadError> Readers::read(syntax::Syntax syntax, std::string_view bytes,
                                                           owl::FileId file, owl::Ontology& source,
                                                           std::vector<owl::Annotation>& annotations) {
  std::vector<owl::Annotation>* wanted = keeps_annotations_ ? &annotations : nullptr;
  auto document = read_axioms(syntax, bytes, file, source, wanted);
  if (wanted != nullptr && document && !document->version_iri.empty()) {
    owl::Annotation& version = wanted->emplace_back(owl::annotation_of({}, "http://www.w3.org/2002/07/owl#versionIRI"));
    version.of = owl::Annotation::Of::ontology;
    version.number = static_cast<std::uint32_t>(file);
    version.value = document->version_iri;
  }
  return document;
}

std::expected<owl::Document, owl::ReadError> Readers::read_axioms(syntax::Syntax syntax, std::string_view bytes,
                                                                  owl::FileId file, owl::Ontology& source,
                                                                  std::vector<owl::Annotation>* wanted) {
  switch (syntax) {
    case syntax::Syntax::functional:
      return functional::read(bytes, file, source, {}, wanted);
    case syntax::Syntax::manchester:
      if (!has_source_) declared_.add(source);
      has_source_ = true;
      return frames::read(bytes, file, source, declared_, {}, wanted);
    case syntax::Syntax::owl_xml:
      return owlxml::read(bytes, file, source, {}, wanted, threads_);
    default:
      return std::unexpected(owl::ReadError{source.files()[static_cast<std::size_t>(file)].path, 0,
                                            "is in " + std::string(syntax::to_string(syntax)) + ", which has triples"});
  }
}

}  // namespace geminga::ontology
