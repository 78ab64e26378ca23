// The triples of all files as numbers. The reader adds them, and the mapping to axioms looks them up.
#ifndef GEMINGA_REASONING_SYNTAX_RDF_TRIPLES_GRAPH_HPP
#define GEMINGA_REASONING_SYNTAX_RDF_TRIPLES_GRAPH_HPP

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "reasoning/syntax/rdf/triples/node_table.hpp"
#include "reasoning/syntax/vocabulary.hpp"

namespace geminga::rdf {

/// An interned RDF term of one Graph; 0 is none, and the words of the vocabulary have their own numbers.
enum class NodeId : std::uint32_t {};

[[nodiscard]] constexpr NodeId node_of(syntax::Word word) { return static_cast<NodeId>(word); }
/// None for a node that is no word of the vocabulary.
[[nodiscard]] constexpr syntax::Word word_of(NodeId node) {
  return static_cast<std::uint32_t>(node) < static_cast<std::uint32_t>(syntax::Word::count)
             ? static_cast<syntax::Word>(node)
             : syntax::Word::none;
}

enum class NodeKind : std::uint8_t { iri, blank, literal };

/// A node as its graph holds it. The views live as long as the graph.
struct Node {
  std::string_view text;  ///< the IRI; the blank node's label, unique among all files; the lexical form
  NodeKind kind = NodeKind::iri;
  NodeId datatype{};  ///< of literals; none: a plain one
  NodeId language{};  ///< of literals: a node whose text is the tag; none: without
};

struct Triple {
  NodeId subject{};
  NodeId predicate{};
  NodeId object{};
  std::uint32_t line = 0;
};

/// A set of triples, in the order of reading, that is filled first, then indexed by subject, then looked up.
class Graph {
 public:
  Graph();

  NodeId iri(std::string_view text) { return intern(NodeKind::iri, text, NodeId{}, NodeId{}); }
  NodeId blank(std::string_view label) { return intern(NodeKind::blank, label, NodeId{}, NodeId{}); }
  /// A blank node that no file names, under a label that is used once: no search finds it, and none has to.
  NodeId new_blank(std::string_view label) { return push(NodeKind::blank, true, label, NodeId{}, NodeId{}); }
  NodeId literal(std::string_view lexical, NodeId datatype, NodeId language) {
    return intern(NodeKind::literal, lexical, datatype, language);
  }
  void add(const Triple& triple) { triples_.push_back(triple); }
  /// Adds all triples of another graph, as if they had been read here.
  void append(const Graph& other);
  /// Says that the triples added from now on are of the next file. The first call begins file 0.
  void begin_file() { file_begins_.push_back(triples_.size()); }

  /// Sorts by subject, predicate and object, and drops repeated triples except the first. Nothing may be added
  /// afterwards.
  void index();

  [[nodiscard]] Node node(NodeId id) const;
  [[nodiscard]] NodeKind kind(NodeId id) const { return nodes_[static_cast<std::size_t>(id)].kind; }
  [[nodiscard]] std::string_view text(NodeId id) const {
    const Record& record = nodes_[static_cast<std::size_t>(id)];
    return {record.text, record.size};
  }
  [[nodiscard]] bool is_literal(NodeId id) const { return kind(id) == NodeKind::literal; }
  [[nodiscard]] bool is_blank(NodeId id) const { return kind(id) == NodeKind::blank; }
  [[nodiscard]] bool is_iri(NodeId id) const { return kind(id) == NodeKind::iri; }
  [[nodiscard]] std::size_t node_count() const { return nodes_.size(); }
  [[nodiscard]] std::size_t triple_count() const { return triples_.size(); }
  [[nodiscard]] const Triple& triple(std::uint32_t number) const { return triples_[number]; }
  [[nodiscard]] std::uint32_t file_of(std::uint32_t triple) const;
  [[nodiscard]] std::size_t file_count() const { return file_begins_.size(); }

  /// The numbers of a subject's triples, by predicate and object; nodes are ordered by their numbers, so that the
  /// vocabulary comes first. Requires index().
  [[nodiscard]] std::span<const std::uint32_t> about(NodeId subject) const;
  /// Those of them with this predicate. O(log n): a subject may have as many triples as its file.
  [[nodiscard]] std::span<const std::uint32_t> about(NodeId subject, syntax::Word predicate) const;
  [[nodiscard]] bool has(NodeId subject, NodeId predicate, NodeId object) const;

 private:
  struct Record {
    const char* text;
    std::uint32_t size;
    NodeKind kind;
    bool is_nameless;  ///< a blank node that no search finds
    NodeId datatype;
    NodeId language;
  };

  NodeId push(NodeKind kind, bool is_nameless, std::string_view text, NodeId datatype, NodeId language);
  NodeId intern(NodeKind kind, std::string_view text, NodeId datatype, NodeId language);
  NodeId intern_hashed(std::uint64_t hash, NodeKind kind, std::string_view text, NodeId datatype, NodeId language);
  /// The nodes of another graph here, by their numbers there.
  std::vector<NodeId> append_nodes(const Graph& other);
  /// Computes the hashes of the IRIs and named blank nodes of another graph, and fetches into the cache what a search
  /// for each reads: a slot of the table, a node and its text, which lie anywhere in memory.
  void prefetch(std::span<const Record> some, std::span<std::uint64_t> hashes) const;
  const char* store(std::string_view text);

  std::vector<Record> nodes_;
  NodeTable table_;
  std::vector<std::unique_ptr<char[]>> chunks_;
  std::size_t chunk_left_ = 0;
  char* chunk_end_ = nullptr;
  std::vector<Triple> triples_;
  std::vector<std::size_t> file_begins_;
  std::vector<std::uint32_t> order_;   ///< triples by subject
  std::vector<std::uint32_t> begins_;  ///< of each node in order_
};

}  // namespace geminga::rdf

#endif
