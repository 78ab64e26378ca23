// Some axioms of loaded files as a document of their own, with the declarations and annotations that belong to them.
#ifndef GEMINGA_ONTOLOGY_GRAPH_EXCERPT_DOCUMENT_HPP
#define GEMINGA_ONTOLOGY_GRAPH_EXCERPT_DOCUMENT_HPP

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "reasoning/owl/annotation.hpp"
#include "reasoning/syntax/graph/graph.hpp"
#include "reasoning/syntax/rdf/load.hpp"
#include "reasoning/syntax/writing/document.hpp"

namespace geminga::ontology {

/// A document of some axioms, their declarations, and the annotations of these axioms and of the names that they use.
/// It has no name. Borrows the files, whose annotations must have been kept.
class ExcerptDocument {
 public:
  /// `axioms` are numbers of the source, ascending, without declarations; `entities` are more that it is about.
  /// Declarations that the files lack are added to the source.
  ExcerptDocument(rdf::Loaded& loaded, std::span<const std::uint32_t> axioms, std::span<const owl::TermId> entities);
  ExcerptDocument(const ExcerptDocument&) = delete;
  ExcerptDocument& operator=(const ExcerptDocument&) = delete;

  [[nodiscard]] const writing::Document& document() const { return document_; }
  /// Adds the same as triples. Returns why that failed, in one line.
  [[nodiscard]] std::optional<std::string> add_to(graph::Graph& graph) const;

 private:
  const rdf::Loaded& loaded_;
  std::vector<std::uint32_t> axioms_;
  std::vector<owl::Annotation> kept_;
  owl::Annotations annotations_;
  writing::Document document_;
};

}  // namespace geminga::ontology

#endif
