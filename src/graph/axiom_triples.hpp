// Axioms as triples: table 1 of the OWL 2 mapping to RDF graphs (W3C Recommendation, second edition, 2012).
#ifndef GEMINGA_GRAPH_AXIOM_TRIPLES_HPP
#define GEMINGA_GRAPH_AXIOM_TRIPLES_HPP

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "el/source.hpp"
#include "graph/node.hpp"

namespace geminga::graph {

/// Writes the axioms of one source; the source must outlive it and may grow. Blank nodes of expressions are numbered.
class AxiomTriples {
 public:
  AxiomTriples(const el::OntologySource& source, TripleSink sink) : source_(source), sink_(std::move(sink)) {}

  void add(const el::Axiom& axiom);

 private:
  using Terms = std::span<const el::TermId>;

  // axiom_triples.cpp: axioms.
  void link(const Node& subject, std::string_view predicate, const Node& object);
  void chained(Terms terms, std::string_view predicate);
  void several(Terms terms, std::string_view of_two, std::string_view of_more);
  void negative(const el::Axiom& axiom);
  void sub_property(Terms terms);
  Node list(Terms terms);
  Node fresh() { return blank("g" + std::to_string(++blanks_)); }

  // axiom_terms.cpp: the node of a term, after the triples that describe it.
  Node node(el::TermId id);
  Node described(std::string_view type, std::string_view predicate, const Node& object);
  Node restriction(const el::Term& term, std::string_view predicate, const Node& object);
  Node cardinality(const el::Term& term);
  Node facets(const el::Term& term);
  Node expression(const el::Term& term);
  [[nodiscard]] Node literal(const el::Term& term) const;

  const el::OntologySource& source_;
  TripleSink sink_;
  std::uint64_t blanks_ = 0;
};

inline constexpr std::string_view rdf_type = "http://www.w3.org/1999/02/22-rdf-syntax-ns#type";
inline constexpr std::string_view rdfs_label = "http://www.w3.org/2000/01/rdf-schema#label";
inline constexpr std::string_view rdfs_sub_class_of = "http://www.w3.org/2000/01/rdf-schema#subClassOf";
inline constexpr std::string_view rdfs_sub_property_of = "http://www.w3.org/2000/01/rdf-schema#subPropertyOf";
inline constexpr std::string_view owl_namespace = "http://www.w3.org/2002/07/owl#";

/// `owl:Class` and its like, which declare an entity of this kind.
[[nodiscard]] Node type_of_entity(el::TermKind kind);
[[nodiscard]] Node owl_word(std::string_view word);

}  // namespace geminga::graph

#endif
