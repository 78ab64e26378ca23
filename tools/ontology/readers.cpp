#include "readers.hpp"

#include "reasoning/syntax/frames/read.hpp"
#include "reasoning/syntax/functional/read.hpp"
#include "reasoning/syntax/owlxml/read.hpp"

namespace geminga::ontology {

void Readers::look_ahead(rdf::Syntax syntax, std::string_view bytes) {
  if (syntax == rdf::Syntax::manchester) frames::look_ahead(bytes, declared_);
}

std::expected<el::Document, el::ReadError> Readers::read(rdf::Syntax syntax, std::string_view bytes, el::FileId file,
                                                         el::OntologySource& source,
                                                         std::vector<el::Annotation>& annotations) {
  std::vector<el::Annotation>* wanted = keeps_annotations_ ? &annotations : nullptr;
  auto document = read_axioms(syntax, bytes, file, source, wanted);
  if (wanted != nullptr && document && !document->version_iri.empty()) {
    el::Annotation& version = wanted->emplace_back(el::annotation_of({}, "http://www.w3.org/2002/07/owl#versionIRI"));
    version.of = el::Annotation::Of::ontology;
    version.number = static_cast<std::uint32_t>(file);
    version.value = document->version_iri;
  }
  return document;
}

std::expected<el::Document, el::ReadError> Readers::read_axioms(rdf::Syntax syntax, std::string_view bytes,
                                                                el::FileId file, el::OntologySource& source,
                                                                std::vector<el::Annotation>* wanted) {
  switch (syntax) {
    case rdf::Syntax::functional:
      return functional::read(bytes, file, source, {}, wanted);
    case rdf::Syntax::manchester:
      if (!has_source_) declared_.add(source);
      has_source_ = true;
      return frames::read(bytes, file, source, declared_, {}, wanted);
    case rdf::Syntax::owl_xml:
      return owlxml::read(bytes, file, source, {}, wanted);
    default:
      return std::unexpected(el::ReadError{source.files()[static_cast<std::size_t>(file)].path, 0,
                                           "is in " + std::string(rdf::to_string(syntax)) + ", which has triples"});
  }
}

}  // namespace geminga::ontology
