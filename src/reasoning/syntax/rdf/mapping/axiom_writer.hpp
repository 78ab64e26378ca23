// Adds the axioms of triples to an ontology, with the place of their triple.
#ifndef GEMINGA_REASONING_SYNTAX_RDF_MAPPING_AXIOM_WRITER_HPP
#define GEMINGA_REASONING_SYNTAX_RDF_MAPPING_AXIOM_WRITER_HPP

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "reasoning/owl/source.hpp"
#include "reasoning/syntax/rdf/mapping/triple_reader.hpp"

namespace geminga::rdf {

/// Adds axioms to an ontology with the file and line of the triple that they come from, and names what cannot be
/// mapped.
class AxiomWriter {
 public:
  /// `files` are the ontology's numbers of the graph's files.
  AxiomWriter(const Graph& graph, owl::Ontology& ontology, std::vector<owl::FileId> files);

  /// Adds an axiom of these arguments. If one could not be mapped, its obstacle is left out by name instead.
  void add(std::uint32_t triple, owl::AxiomKind kind, std::initializer_list<Mapped> arguments);
  void add(std::uint32_t triple, owl::AxiomKind kind, const std::vector<owl::TermId>& arguments);
  /// Declares the triple's subject, once for each kind of entity; nothing where it is blank.
  void declare(std::uint32_t triple, owl::TermKind kind);
  void leave_out(std::uint32_t triple, std::string_view construct);

 private:
  [[nodiscard]] owl::FileId file_of(std::uint32_t triple) const { return files_[graph_.file_of(triple)]; }

  const Graph& graph_;
  owl::Ontology& ontology_;
  std::vector<owl::FileId> files_;
  std::vector<bool> declared_;                     ///< by node and kind of entity
  std::set<std::string, std::less<>> constructs_;  ///< the names of what was left out
};

}  // namespace geminga::rdf

#endif
