// What a triple is made of, as plain texts.
#ifndef GEMINGA_GRAPH_NODE_HPP
#define GEMINGA_GRAPH_NODE_HPP

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <utility>

namespace geminga::graph {

struct Node {
  enum class Kind : std::uint8_t { iri, blank, literal } kind = Kind::iri;
  std::string text;      ///< IRI, the label of a blank node without _:, or lexical form
  std::string datatype;  ///< of literals: an IRI; empty: a plain one, or one with a language
  std::string language;

  friend bool operator==(const Node&, const Node&) = default;
};

[[nodiscard]] inline Node iri(std::string_view text) { return {Node::Kind::iri, std::string(text), {}, {}}; }
[[nodiscard]] inline Node blank(std::string label) { return {Node::Kind::blank, std::move(label), {}, {}}; }

/// Takes the triples that something makes.
using TripleSink = std::function<void(const Node& subject, const Node& predicate, const Node& object)>;

}  // namespace geminga::graph

#endif
