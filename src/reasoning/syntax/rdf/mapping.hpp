// From the triples of all files to axioms: the mapping of OWL 2 to RDF (W3C Recommendation, 11 December 2012),
// backwards.
//
// Everything has been read before anything is mapped, so the order of triples means nothing. Three passes: what each
// node is (section 3.1.3), the axioms with their expressions (section 3.2), and what nobody used.
#ifndef GEMINGA_REASONING_SYNTAX_RDF_MAPPING_HPP
#define GEMINGA_REASONING_SYNTAX_RDF_MAPPING_HPP

#include <cstdint>
#include <expected>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "reasoning/owl/source.hpp"
#include "reasoning/syntax/rdf/graph.hpp"

namespace geminga::rdf {

/// One run over one indexed graph. What cannot be mapped is left out by name in the source; nothing is refused.
class Mapping {
 public:
  /// `files` are the source's numbers of the graph's files.
  Mapping(const Graph& graph, owl::Ontology& source, std::vector<owl::FileId> files);

  void run();

 private:
  // What a node is declared to be, or used as (bits).
  static constexpr std::uint16_t is_class = 1;
  static constexpr std::uint16_t is_datatype = 2;
  static constexpr std::uint16_t is_object_property = 4;
  static constexpr std::uint16_t is_data_property = 8;
  static constexpr std::uint16_t is_annotation_property = 16;
  static constexpr std::uint16_t is_some_property = 32;  ///< rdf:Property, or used as one in an axiom
  static constexpr std::uint16_t is_header = 64;         ///< an ontology: what is said about it are annotations
  static constexpr std::uint16_t is_reified = 128;       ///< an annotated axiom, or an annotation of one
  static constexpr std::uint16_t is_declared_property = 256;
  static constexpr std::uint16_t has_literals = 512;  ///< a property with a literal value somewhere
  static constexpr std::uint16_t property_kinds = is_object_property | is_data_property | is_annotation_property;

  /// The term that a node was mapped to, or the construct that stood in the way.
  using Mapped = std::expected<owl::TermId, const char*>;
  struct Memo {
    enum class State : std::uint8_t { unknown, open, mapped, failed } state = State::unknown;
    owl::TermId term{};
    const char* obstacle = nullptr;
  };

  // mapping_roles.cpp: what each node is.
  void find_roles();
  void role_of_type(const Triple& triple);
  void role_of_use(const Triple& triple, std::vector<std::uint16_t>& uses);
  std::uint16_t use_of_restricted(NodeId restriction);
  std::uint16_t use_of_asserted(NodeId assertion) const;
  void spread_property_kinds();
  void settle_properties();

  // mapping_expressions.cpp, mapping_restrictions.cpp, mapping_ranges.cpp
  Mapped class_expression(NodeId node);
  Mapped described_class(NodeId node);
  Mapped boolean_class(NodeId node, syntax::Word constructor, NodeId object);
  Mapped restriction(NodeId node);
  Mapped quantifier(NodeId property, syntax::Word constraint, NodeId filler);
  Mapped cardinality(NodeId property, syntax::Word constraint, NodeId number, NodeId on_class, NodeId on_range);
  Mapped data_range(NodeId node);
  Mapped described_range(NodeId node);
  Mapped facets(NodeId datatype, NodeId restrictions);
  Mapped object_property(NodeId node);
  Mapped data_property(NodeId node);
  Mapped individual(NodeId node);
  Mapped literal(NodeId node);
  /// Whether a node is a data range. What is declared must have been looked at.
  [[nodiscard]] bool is_range(NodeId node, int depth = 0) const;
  [[nodiscard]] bool is_described_range(NodeId node, int depth) const;
  [[nodiscard]] bool is_data(NodeId property) const;
  [[nodiscard]] bool is_object(NodeId property) const;

  // mapping_axioms.cpp, mapping_nary.cpp
  void map_triple(std::uint32_t number);
  void map_type(std::uint32_t number);
  /// Declares the subject, once for each kind; nothing where it is blank.
  void declare(std::uint32_t number, owl::TermKind kind);
  void map_class_axiom(std::uint32_t number, owl::AxiomKind kind);
  void map_definition(std::uint32_t number);
  void map_property_axiom(std::uint32_t number, owl::AxiomKind of_objects, owl::AxiomKind of_data);
  void map_domain(std::uint32_t number);
  void map_range(std::uint32_t number);
  void map_characteristic(std::uint32_t number, owl::AxiomKind kind);
  void map_functional(std::uint32_t number);
  void map_chain(std::uint32_t number);
  void map_key(std::uint32_t number);
  void map_disjoint_union(std::uint32_t number);
  void map_all_disjoint_classes(std::uint32_t number);
  void map_all_disjoint_properties(std::uint32_t number);
  void map_all_different(std::uint32_t number);
  void map_negative_assertion(std::uint32_t number);
  void map_reified(std::uint32_t number);
  /// Whether a subject has this property with a blank node that describes this class.
  bool has_described(NodeId subject, NodeId property, owl::TermId described);
  void map_identity(std::uint32_t number, owl::AxiomKind kind);
  void map_assertion(std::uint32_t number);
  void map_labels();
  void report_leftovers();

  // Looking things up.
  [[nodiscard]] static syntax::Word word(NodeId node);
  [[nodiscard]] bool has_role(NodeId node, std::uint16_t roles) const {
    return (roles_[static_cast<std::size_t>(node)] & roles) != 0;
  }
  void add_role(NodeId node, std::uint16_t roles) { roles_[static_cast<std::size_t>(node)] |= roles; }
  /// The one object of a subject and predicate, marked as used; none where there is none or several.
  NodeId object_of(NodeId subject, syntax::Word predicate);
  [[nodiscard]] bool has_type(NodeId subject, syntax::Word type) const;
  /// The members of an RDF list, its triples marked as used; nothing where it is not well-formed.
  std::optional<std::vector<NodeId>> list(NodeId head);
  /// Maps every member of a list by one of the functions above.
  std::expected<std::vector<owl::TermId>, const char*> terms(NodeId head, Mapped (Mapping::*map)(NodeId));
  /// Two or more members are an axiom; the list is that of the one object of subject and predicate.
  void add_list_axiom(std::uint32_t number, owl::AxiomKind kind, NodeId head, Mapped (Mapping::*map)(NodeId));
  [[nodiscard]] bool use(std::uint32_t triple);

  void add(std::uint32_t triple, owl::AxiomKind kind, std::initializer_list<Mapped> arguments);
  void add(std::uint32_t triple, owl::AxiomKind kind, const std::vector<owl::TermId>& arguments);
  void leave_out(std::uint32_t triple, std::string_view construct);
  [[nodiscard]] owl::FileId file_of(std::uint32_t triple) const;

  const Graph& graph_;
  owl::Ontology& source_;
  std::vector<owl::FileId> files_;
  std::vector<std::uint16_t> roles_;
  std::vector<bool> used_;                         ///< triples
  std::vector<bool> declared_;                     ///< by node and kind of entity
  std::set<std::string, std::less<>> constructs_;  ///< that were left out
  std::vector<Memo> classes_;
  mutable std::vector<std::uint8_t> range_marks_;  ///< of blank nodes: 0 not asked yet, 1 no data range, 2 a data range
  std::unordered_map<std::uint32_t, std::uint16_t> restricted_uses_;        ///< by subject of owl:onProperty
  std::unordered_set<std::uint32_t> named_restrictions_;                    ///< IRIs with owl:onProperty
  std::unordered_map<std::uint32_t, std::set<std::uint64_t>> repeated_by_;  ///< by source of owl:Axiom: has_described()
  std::unordered_map<std::uint32_t, Memo> ranges_;
  std::vector<std::uint32_t> list_marks_;  ///< the walk that last came by a node
  std::uint32_t list_walk_ = 0;
  std::uint64_t list_steps_left_ = 0;  ///< lists that share their tails could cost the square of the file
  std::uint32_t depth_ = 0;
};

}  // namespace geminga::rdf

#endif
