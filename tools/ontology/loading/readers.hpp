// The readers of functional syntax, Manchester syntax and OWL/XML, behind the interface that rdf::load() calls.
#ifndef GEMINGA_ONTOLOGY_LOADING_READERS_HPP
#define GEMINGA_ONTOLOGY_LOADING_READERS_HPP

#include <expected>
#include <string_view>
#include <vector>

#include "reasoning/owl/annotation.hpp"
#include "reasoning/owl/document.hpp"
#include "reasoning/owl/source.hpp"
#include "reasoning/syntax/frames/declared.hpp"
#include "reasoning/syntax/rdf/load.hpp"

namespace geminga::ontology {

/// Serves one load at a time.
class Readers final : public rdf::OtherReader {
 public:
  explicit Readers(bool keeps_annotations = false, unsigned threads = 1)
      : keeps_annotations_(keeps_annotations), threads_(threads) {}

  void begin() override;
  void look_ahead(syntax::Syntax syntax, std::string_view bytes) override;
  std::expected<owl::Document, owl::ReadError> read(syntax::Syntax syntax, std::string_view bytes, owl::FileId file,
                                                    owl::Ontology& source,
                                                    std::vector<owl::Annotation>& annotations) override;

 private:
  std::expected<owl::Document, owl::ReadError> read_axioms(syntax::Syntax syntax, std::string_view bytes,
                                                           owl::FileId file, owl::Ontology& source,
                                                           std::vector<owl::Annotation>* wanted);

  bool keeps_annotations_;
  unsigned threads_;
  frames::Declared declared_;
  bool has_source_ = false;  ///< declared_ has the declarations of all other files
};

}  // namespace geminga::ontology

#endif
