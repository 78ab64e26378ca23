// The content of a graph, for the files of this folder.
#ifndef GEMINGA_REASONING_SYNTAX_GRAPH_STORE_HPP
#define GEMINGA_REASONING_SYNTAX_GRAPH_STORE_HPP

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "reasoning/syntax/graph/graph.hpp"
#include "reasoning/syntax/graph/terms/statements.hpp"
#include "reasoning/syntax/graph/terms/world.hpp"

namespace geminga::graph {

struct Graph::Store {
  explicit Store(const GraphLimits& with) : limits(with), statements(world) {}

  GraphLimits limits;
  World world;
  Statements statements;
  std::function<bool(const Node&, std::string_view, const Node&)> keeps;
  std::optional<std::string> problem;

  std::size_t octets = 0;      ///< of all triples that were added
  bool is_over_limit = false;  ///< that is the problem

  /// Whether there is room for one more triple with so many octets of texts. If not, that is the problem of the graph.
  bool make_room(std::size_t text_octets) {
    if (problem) return false;
    octets += triple_octets + text_octets;
    is_over_limit = statements.size() >= limits.triples || octets > limits.octets;
    if (!is_over_limit) return true;
    problem = octets > limits.octets
                  ? too_many_octets(limits.octets)
                  : "more than " + std::to_string(limits.triples) + " triples in all: give fewer files";
    return false;
  }
  void fail(std::string_view words) {
    if (!problem) problem = words;
  }
};

/// Writes sorted statements as text, or says why not.
[[nodiscard]] std::expected<std::string, std::string> write(const Statements& sorted, Format format,
                                                            const Prefixes& prefixes);

}  // namespace geminga::graph

#endif
