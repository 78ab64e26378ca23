// Looks up triples for the mapping, and remembers which were used.
#ifndef GEMINGA_REASONING_SYNTAX_RDF_MAPPING_TRIPLE_READER_HPP
#define GEMINGA_REASONING_SYNTAX_RDF_MAPPING_TRIPLE_READER_HPP

#include <cstdint>
#include <expected>
#include <optional>
#include <vector>

#include "reasoning/owl/axiom.hpp"
#include "reasoning/syntax/rdf/triples/graph.hpp"

namespace geminga::rdf {

/// The term that a node was mapped to, or the construct that prevents it.
using Mapped = std::expected<owl::TermId, const char*>;
/// The same of the members of a list.
using MappedList = std::expected<std::vector<owl::TermId>, const char*>;

/// Reads an indexed graph and marks the triples that became part of an axiom or expression. OWL 2 cannot express the
/// rest. A repeated triple counts as used.
class TripleReader {
 public:
  explicit TripleReader(const Graph& graph);

  [[nodiscard]] const Graph& graph() const { return graph_; }
  [[nodiscard]] bool is_used(std::uint32_t triple) const { return used_[triple]; }
  void use(std::uint32_t triple) { used_[triple] = true; }
  /// Uses a triple.
  const Triple& take(std::uint32_t triple) {
    use(triple);
    return graph_.triple(triple);
  }

  /// The triple that is so many behind another one in the file, so that what is known of its nodes, which lies anywhere
  /// in memory, can be fetched into the cache in time; null behind the last triple.
  [[nodiscard]] const Triple* ahead(std::uint32_t triple, std::uint32_t distance) const {
    return graph_.triple_count() - triple > distance ? &graph_.triple(triple + distance) : nullptr;
  }

  /// The one object of a subject and predicate; none where there is none or several. Uses the triples.
  NodeId object_of(NodeId subject, syntax::Word predicate);
  /// The same of the first of two predicates that the subject has: the second is what a draft of OWL wrote.
  NodeId object_of(NodeId subject, syntax::Word predicate, syntax::Word former) {
    return object_of(subject, graph_.about(subject, predicate).empty() ? former : predicate);
  }
  /// The members of an RDF list; nothing where it is not well-formed. Uses its triples.
  std::optional<std::vector<NodeId>> list(NodeId head);
  /// Maps every member of a list by `map`, up to the first that cannot be mapped.
  template <typename Map>
  MappedList terms(NodeId head, Map&& map) {
    const auto members = list(head);
    if (!members) return std::unexpected("a broken rdf:List");
    std::vector<owl::TermId> terms;
    terms.reserve(members->size());
    for (const NodeId member : *members) {
      const Mapped term = map(member);
      if (!term) return std::unexpected(term.error());
      terms.push_back(*term);
    }
    return terms;
  }

 private:
  const Graph& graph_;
  std::vector<bool> used_;
  std::vector<std::uint32_t> list_marks_;  ///< the walk that last came by a node
  std::uint32_t list_walk_ = 0;
  std::uint64_t list_steps_left_;  ///< a limit: lists that share their tails could cost the square of the file
};

}  // namespace geminga::rdf

#endif
