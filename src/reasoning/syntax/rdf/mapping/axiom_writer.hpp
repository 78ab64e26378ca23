// Adds the axioms of triples to an ontology, with the place of their triple.
#ifndef GEMINGA_REASONING_SYNTAX_RDF_MAPPING_AXIOM_WRITER_HPP
#define GEMINGA_REASONING_SYNTAX_RDF_MAPPING_AXIOM_WRITER_HPP

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <optional>
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
  /// Notes that the triple is read otherwise than its author may mean.
  void remark(std::uint32_t triple, std::string_view text);
  /// A union, intersection or enumeration over the list that is the triple's object. One that is too short for OWL 2
  /// means what it means (document::term_of_list()).
  owl::TermId term_of_list(std::uint32_t triple, owl::TermKind kind, const std::vector<owl::TermId>& members);
  /// Adds an axiom about all members of a list. One of fewer than two says nothing.
  void add_of_list(std::uint32_t triple, owl::AxiomKind kind, const std::vector<owl::TermId>& members);

  /// An axiom of the ontology, or one that it left out because of an ill-typed literal.
  struct Place {
    std::uint32_t number = 0;
    bool is_ill_typed = false;
  };
  /// From here on axiom_of() answers.
  void remember_places() { place_of_.assign(graph_.triple_count(), no_place); }
  /// The last axiom that a triple became; nothing if it became none.
  [[nodiscard]] std::optional<Place> axiom_of(std::uint32_t triple) const;
  [[nodiscard]] owl::FileId file_of(std::uint32_t triple) const { return files_[graph_.file_of(triple)]; }

 private:
  static constexpr std::uint32_t no_place = 0xffffffff;
  static constexpr std::uint32_t ill_typed_place = 0x80000000;  ///< added to the number

  const Graph& graph_;
  owl::Ontology& ontology_;
  std::vector<owl::FileId> files_;
  std::vector<bool> declared_;                     ///< by node and kind of entity
  std::set<std::string, std::less<>> constructs_;  ///< the names of what was left out
  std::vector<std::uint32_t> place_of_;            ///< by triple; empty: not remembered
};

}  // namespace geminga::rdf

#endif
