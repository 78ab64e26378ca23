// The places of blank nodes in a document: in the place of their one reference, in a list, or behind a label.
#ifndef GEMINGA_REASONING_SYNTAX_GRAPH_PLACED_NODES_HPP
#define GEMINGA_REASONING_SYNTAX_GRAPH_PLACED_NODES_HPP

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "reasoning/syntax/graph/terms/statements.hpp"

namespace geminga::graph {

using Triples = std::span<raptor_statement* const>;

/// Decides while a document is written, so that every triple is written once: those of a blank node stand in the place
/// of its only reference. A node of several references, of a cycle, or below max_nesting others has a label and stands
/// alone. Linear in the triples.
class PlacedNodes {
 public:
  enum class Place : std::uint8_t { labelled, nested, list };

  /// Our own reader takes 512 elements of RDF/XML in each other; a node takes two.
  static constexpr std::size_t max_nesting = 32;

  /// Sorted triples, which must outlive it. Without `lists_literals` a list that has a literal is nested nodes.
  PlacedNodes(Triples sorted, bool lists_literals);

  /// The triples of the next subject that stands alone: names and labelled nodes in their order, then what is left.
  /// Empty at the end.
  [[nodiscard]] Triples next_root();

  /// The place of a blank node that is an object, at a depth. Its triples, or those of its list, must be written there.
  [[nodiscard]] Place place(const raptor_term& blank, std::size_t depth, bool may_be_list = true);
  /// The triples of a blank node.
  [[nodiscard]] Triples triples(const raptor_term& blank) const;
  /// The members of a node whose place is a list.
  [[nodiscard]] std::vector<const raptor_term*> members(const raptor_term& list) const;
  /// Whether a blank node that stands alone is an object anywhere.
  [[nodiscard]] bool is_referred_to(const raptor_term& blank) const;

 private:
  struct Node {
    std::size_t begin = 0, end = 0;  ///< of its triples
    std::size_t references = 0;
    bool is_labelled = false, is_written = false;
    bool is_no_list = false;  ///< known not to lead to the end of a list
  };

  [[nodiscard]] Node& node(const raptor_term& blank);
  [[nodiscard]] const Node& node(const raptor_term& blank) const;
  /// The triple of the rest, if a node is a cell of a list that nothing else refers to.
  [[nodiscard]] const raptor_statement* rest_of(const Node& node) const;
  [[nodiscard]] bool take_list(Node& head);
  [[nodiscard]] Triples take(Node& node);

  Triples all_;
  bool lists_literals_;
  std::unordered_map<std::string_view, Node> nodes_;  ///< by label
  std::deque<Node*> cut_off_;                         ///< got a label because of their depth
  std::size_t next_ = 0;
  bool is_rest_ = false;  ///< all roots are written; what is left are cycles
};

[[nodiscard]] std::string_view text_of(const raptor_term& term);
[[nodiscard]] inline bool is_blank(const raptor_term& term) { return term.type == RAPTOR_TERM_TYPE_BLANK; }
[[nodiscard]] inline bool is_iri(const raptor_term& term) { return term.type == RAPTOR_TERM_TYPE_URI; }
[[nodiscard]] inline bool is_literal(const raptor_term& term) { return term.type == RAPTOR_TERM_TYPE_LITERAL; }

}  // namespace geminga::graph

#endif
