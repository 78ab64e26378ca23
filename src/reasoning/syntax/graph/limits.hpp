// The most that a graph may hold, and that a query may return.
#ifndef GEMINGA_REASONING_SYNTAX_GRAPH_LIMITS_HPP
#define GEMINGA_REASONING_SYNTAX_GRAPH_LIMITS_HPP

#include <cstddef>

namespace geminga::graph {

/// The octets of a triple in memory, without its texts.
inline constexpr std::size_t triple_octets = 200;

struct GraphLimits {
  std::size_t triples = 10'000'000;
  /// Octets of all triples: `triple_octets` and its texts for each, which is about what it takes here and when it is
  /// written. A cycle of 20 000 classes has 4 * 10^8 triples.
  std::size_t octets = std::size_t{1} << 30;
  /// Octets that a query takes beside the graph, with its answer.
  std::size_t query_octets = std::size_t{1} << 30;
  std::size_t query_bytes = std::size_t{1} << 16;
  /// Levels of braces. rasqal takes three times as long for each level of OPTIONAL, before it looks at a triple: 0.3 s
  /// for ten levels, 7 minutes for 16.
  std::size_t query_levels = 10;
  /// Rows of one answer. Further rows are not returned.
  std::size_t rows = 1'000'000;
};

}  // namespace geminga::graph

#endif
