// The most that a graph may hold, and that a query may return.
#ifndef GEMINGA_REASONING_SYNTAX_GRAPH_LIMITS_HPP
#define GEMINGA_REASONING_SYNTAX_GRAPH_LIMITS_HPP

#include <cstddef>

namespace geminga::graph {

struct GraphLimits {
  /// A triple takes about 200 octets, and 500 more while a query is asked.
  std::size_t triples = 10'000'000;
  std::size_t query_bytes = std::size_t{1} << 16;
  /// Rows of one answer. Further rows are not returned.
  std::size_t rows = 1'000'000;
};

}  // namespace geminga::graph

#endif
