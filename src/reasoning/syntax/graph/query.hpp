// A SPARQL query over a graph. Nothing is fetched, and nothing is changed.
#ifndef GEMINGA_REASONING_SYNTAX_GRAPH_QUERY_HPP
#define GEMINGA_REASONING_SYNTAX_GRAPH_QUERY_HPP

#include <cstdint>
#include <expected>
#include <optional>
#include <string>
#include <vector>

#include "base/budget.hpp"
#include "reasoning/syntax/graph/expressions.hpp"
#include "reasoning/syntax/graph/graph.hpp"

namespace geminga::graph {

/// The result of a query. The query decides which part of it is set.
struct Answer {
  enum class Kind : std::uint8_t { rows, truth, triples } kind = Kind::rows;
  std::vector<std::string> variables;
  std::vector<std::vector<std::optional<Node>>> rows;  ///< in the order that the query asks for
  bool is_true = false;
  bool is_cut = false;  ///< there are more rows, or triples, than the limit
  /// A class expression asked for triples of the graph, although names are found for others (expressions.hpp).
  bool has_asserted_expressions = false;
  std::string text;  ///< the triples of CONSTRUCT and DESCRIBE
};

/// Why there is no answer, in one line, and whether that is a limit.
struct AskError {
  std::string text;
  bool is_limit = false;
};

/// How a query is asked.
struct AskOptions {
  Prefixes prefixes{};             ///< unless the query declares them
  Format format = Format::turtle;  ///< of the triples of CONSTRUCT and DESCRIBE
  GraphLimits limits{};
  base::Budget* budget = nullptr;  ///< of triples that are looked at and rows that are joined; null: no limit
  /// Lets a class expression beside rdf:type, rdfs:subClassOf or owl:equivalentClass (expressions.hpp) ask for the
  /// names that it finds, before anything is looked at. Without it such an expression asks for its triples.
  FindNames find_names{};
};

/// Asks a sorted graph. SELECT, ASK, CONSTRUCT and DESCRIBE are answered. What would fetch or change something
/// (SERVICE, FROM, LOAD, INSERT and others) is refused first. Beyond a limit there is no answer, because what was not
/// looked at may refute rows that were found (OPTIONAL, MINUS).
[[nodiscard]] std::expected<Answer, AskError> ask(const Graph& graph, const std::string& query,
                                                  const AskOptions& options);

}  // namespace geminga::graph

#endif
