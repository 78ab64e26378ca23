// The parts of a triple as plain texts.
#ifndef GEMINGA_REASONING_SYNTAX_GRAPH_AXIOMS_NODE_HPP
#define GEMINGA_REASONING_SYNTAX_GRAPH_AXIOMS_NODE_HPP

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <utility>

#include "base/text.hpp"

namespace geminga::graph {

/// The datatype of plain texts. A literal of it is written without it (RDF 1.1 Concepts, section 3.3).
inline constexpr std::string_view xsd_string = "http://www.w3.org/2001/XMLSchema#string";

struct Node {
  enum class Kind : std::uint8_t { iri, blank, literal } kind = Kind::iri;
  std::string text;      ///< IRI, the label of a blank node without _:, or lexical form
  std::string datatype;  ///< of literals: an IRI; empty: a plain one, or one with a language
  std::string language;

  friend bool operator==(const Node&, const Node&) = default;
};

[[nodiscard]] inline Node iri(std::string_view text) { return {Node::Kind::iri, std::string(text), {}, {}}; }
[[nodiscard]] inline Node blank(std::string label) { return {Node::Kind::blank, std::move(label), {}, {}}; }

/// A part of a blank node's label that consists of letters and digits, as every syntax of triples can write it, and
/// differs where the text differs.
[[nodiscard]] inline std::string label_of(std::string_view text) {
  std::string label;
  for (const char c : text) {
    const bool is_plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c < 'Z') || (c >= '0' && c <= '9');
    label += is_plain ? std::string(1, c) : 'Z' + base::to_hex(static_cast<unsigned char>(c), 2);
  }
  return label;
}

/// Receives triples.
using TripleSink = std::function<void(const Node& subject, const Node& predicate, const Node& object)>;

}  // namespace geminga::graph

#endif
