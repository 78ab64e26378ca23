// A SPARQL query over a graph, by rasqal through librdf. Nothing is fetched, and nothing is changed.
#ifndef GEMINGA_REASONING_SYNTAX_GRAPH_QUERY_HPP
#define GEMINGA_REASONING_SYNTAX_GRAPH_QUERY_HPP

#include <expected>
#include <optional>
#include <string>
#include <vector>

#include "reasoning/syntax/graph/graph.hpp"

namespace geminga::graph {

/// The result of a query. The query decides which part of it is set.
struct Answer {
  enum class Kind : std::uint8_t { rows, truth, triples } kind = Kind::rows;
  std::vector<std::string> variables;
  std::vector<std::vector<std::optional<Node>>> rows;  ///< in the order that the query asks for
  bool is_true = false;
  bool is_cut = false;  ///< there are more rows, or triples, than the limit
  std::string text;     ///< the triples of CONSTRUCT
};

/// Asks a sorted graph. SELECT, ASK and CONSTRUCT are answered. What would fetch or change something (SERVICE, FROM,
/// LOAD, INSERT and others) is refused first. The given prefixes are used unless the query declares them. Only the
/// process limits the time that it takes.
[[nodiscard]] std::expected<Answer, std::string> ask(const Graph& graph, const std::string& query,
                                                     const Prefixes& prefixes, Format format = Format::turtle,
                                                     const GraphLimits& limits = {});

}  // namespace geminga::graph

#endif
