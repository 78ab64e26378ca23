// The readers of OWL's own syntaxes, as the reader of triples calls them.
#ifndef GEMINGA_ONTOLOGY_READERS_HPP
#define GEMINGA_ONTOLOGY_READERS_HPP

#include <expected>
#include <string_view>
#include <vector>

#include "reasoning/owl/annotation.hpp"
#include "reasoning/owl/document.hpp"
#include "reasoning/owl/source.hpp"
#include "reasoning/syntax/frames/declared.hpp"
#include "reasoning/syntax/rdf/load.hpp"

namespace geminga::ontology {

/// Functional syntax, Manchester syntax, OWL/XML. For one load.
class Readers final : public rdf::OtherReader {
 public:
  explicit Readers(bool keeps_annotations = false) : keeps_annotations_(keeps_annotations) {}

  void look_ahead(syntax::Syntax syntax, std::string_view bytes) override;
  std::expected<owl::Document, owl::ReadError> read(syntax::Syntax syntax, std::string_view bytes, owl::FileId file,
                                                    owl::Ontology& source,
                                                    std::vector<owl::Annotation>& annotations) override;

 private:
  std::expected<owl::Document, owl::ReadError> read_axioms(syntax::Syntax syntax, std::string_view bytes,
                                                           owl::FileId file, owl::Ontology& source,
                                                           std::vector<owl::Annotation>* wanted);

  bool keeps_annotations_;
  frames::Declared declared_;
  bool has_source_ = false;  ///< what all other files declare has been noted
};

}  // namespace geminga::ontology

#endif
