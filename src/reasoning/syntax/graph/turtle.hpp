// Triples as text in Turtle (https://www.w3.org/TR/turtle/) and N-Triples (https://www.w3.org/TR/n-triples/).
#ifndef GEMINGA_REASONING_SYNTAX_GRAPH_TURTLE_HPP
#define GEMINGA_REASONING_SYNTAX_GRAPH_TURTLE_HPP

#include <expected>
#include <string>

#include "reasoning/syntax/graph/graph.hpp"
#include "reasoning/syntax/graph/placed_nodes.hpp"

namespace geminga::graph {

/// The text, or why there is none: a name has a character that no IRI may have. Triples must be sorted.
[[nodiscard]] std::expected<std::string, std::string> write_turtle(Triples sorted, const Prefixes& prefixes);
[[nodiscard]] std::expected<std::string, std::string> write_n_triples(Triples sorted);

}  // namespace geminga::graph

#endif
