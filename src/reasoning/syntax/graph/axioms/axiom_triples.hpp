// Axioms and their annotations as triples: sections 2.1 to 2.3 of the OWL 2 mapping to RDF graphs (W3C Recommendation,
// second edition, 2012).
#ifndef GEMINGA_REASONING_SYNTAX_GRAPH_AXIOMS_AXIOM_TRIPLES_HPP
#define GEMINGA_REASONING_SYNTAX_GRAPH_AXIOMS_AXIOM_TRIPLES_HPP

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "reasoning/owl/annotation.hpp"
#include "reasoning/owl/source.hpp"
#include "reasoning/syntax/graph/axioms/node.hpp"
#include "reasoning/syntax/vocabulary.hpp"

namespace geminga::graph {

/// Writes the axioms of one source; the source must outlive it and may grow. Blank nodes of expressions are numbered.
class AxiomTriples {
 public:
  AxiomTriples(const owl::Ontology& source, TripleSink sink) : source_(source), sink_(std::move(sink)) {}

  void add(const owl::Axiom& axiom);
  /// Writes annotations of the axiom that was added last, with their own annotations. `own` are numbers in the list.
  void annotate(const owl::Annotations& annotations, std::span<const std::uint32_t> own);
  /// Writes an annotation of a name or of an ontology, with its own annotations.
  void add(const owl::Annotations& annotations, std::uint32_t number);
  /// The node of a file's ontology: its name, or a blank node.
  [[nodiscard]] Node ontology(owl::FileId file) const;

 private:
  using Terms = std::span<const owl::TermId>;

  /// The form of an axiom that is one triple, or one of several triples that mean it together.
  struct Triple {
    Node subject;
    Node predicate;
    Node object;
  };

  // axiom_triples.cpp: axioms.
  void say(const Node& subject, std::string_view predicate, const Node& object);
  void link(const Node& subject, std::string_view predicate, const Node& object);
  void chained(Terms terms, std::string_view predicate);
  void several(Terms terms, std::string_view of_two, std::string_view of_more);
  void negative(const owl::Axiom& axiom);
  void sub_property(Terms terms);
  void inverse(Terms terms);
  Node list(Terms terms);
  Node fresh() { return blank("g" + std::to_string(++blanks_)); }

  // annotation_triples.cpp
  void annotate(const Node& holder, const owl::Annotations& annotations, std::span<const std::uint32_t> own,
                std::string_view type = "Annotation");
  Node reify(const Triple& triple, std::string_view type);

  // rule_triples.cpp
  void rule(Terms parts);
  Node atom(const owl::Term& term);
  Node variable(const owl::Term& term);

  // axiom_terms.cpp: the node of a term, after the triples that describe it.
  Node node(owl::TermId id);
  /// The blank node of an anonymous individual.
  static Node individual(std::string_view name);
  Node described(std::string_view type, std::string_view predicate, const Node& object);
  Node restriction(const owl::Term& term, std::string_view predicate, const Node& object);
  Node cardinality(const owl::Term& term);
  Node facets(const owl::Term& term);
  Node expression(const owl::Term& term);
  [[nodiscard]] Node literal(const owl::Term& term) const;

  const owl::Ontology& source_;
  TripleSink sink_;
  std::uint64_t blanks_ = 0;
  std::vector<Triple> said_;    ///< of the axiom that was added last
  std::optional<Node> holder_;  ///< the node that this axiom is, where it is one
};

inline constexpr std::string_view rdf_type = "http://www.w3.org/1999/02/22-rdf-syntax-ns#type";
inline constexpr std::string_view rdfs_label = "http://www.w3.org/2000/01/rdf-schema#label";
inline constexpr std::string_view rdfs_sub_class_of = "http://www.w3.org/2000/01/rdf-schema#subClassOf";
inline constexpr std::string_view rdfs_sub_property_of = "http://www.w3.org/2000/01/rdf-schema#subPropertyOf";
/// A word of OWL as an IRI.
[[nodiscard]] inline std::string owl(std::string_view word) { return std::string(syntax::owl_namespace).append(word); }

/// `owl:Class` and its like, which declare an entity of this kind.
[[nodiscard]] Node type_of_entity(owl::TermKind kind);
[[nodiscard]] Node owl_word(std::string_view word);

}  // namespace geminga::graph

#endif
