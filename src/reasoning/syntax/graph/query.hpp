// A SPARQL query over a graph, by rasqal through librdf. Nothing is fetched, and nothing is changed.
#ifndef GEMINGA_REASONING_SYNTAX_GRAPH_QUERY_HPP
#define GEMINGA_REASONING_SYNTAX_GRAPH_QUERY_HPP

#include <expected>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reasoning/syntax/graph/graph.hpp"

namespace geminga::graph {

/// What a query gave; which of them depends on the query.
struct Answer {
  enum class Kind : std::uint8_t { rows, truth, triples } kind = Kind::rows;
  std::vector<std::string> variables;
  std::vector<std::vector<std::optional<Node>>> rows;  ///< in the order that the query asks for
  bool is_true = false;
  bool is_cut = false;  ///< there are more rows, or triples, than the limit
  std::string text;     ///< the triples of CONSTRUCT
};

/// Asks a settled graph. SELECT, ASK and CONSTRUCT are answered; what would fetch or change something (SERVICE, FROM,
/// LOAD, INSERT and its like) is refused before anything is done. Prefixes that the query does not declare itself are
/// those given. The time that it takes is limited by nobody but the process.
[[nodiscard]] std::expected<Answer, std::string> ask(const Graph& graph, const std::string& query,
                                                     const Prefixes& prefixes, Format format = Format::turtle,
                                                     const Limits& limits = {});

}  // namespace geminga::graph

#endif
