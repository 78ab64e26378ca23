// The most that a graph may hold, and that a query may return.
#ifndef GEMINGA_REASONING_SYNTAX_GRAPH_LIMITS_HPP
#define GEMINGA_REASONING_SYNTAX_GRAPH_LIMITS_HPP

#include <cstddef>
#include <string>
#include <string_view>

namespace geminga::graph {

/// The octets of a triple in memory, without its texts.
inline constexpr std::size_t triple_octets = 200;

/// The words for triples that take more than a limit of octets. `less` is what to leave away, such as "--closure".
[[nodiscard]] inline std::string too_many_octets(std::size_t octets, std::string_view less = "--closure") {
  return "the triples take more than " + std::to_string(octets >> 20U) +
         " MiB in all: give fewer files, ask for less (without " + std::string(less) + "), or raise --graph-limit";
}

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
  /// Levels of round and square brackets. rasqal says "memory exhausted" above some 4000, without more.
  std::size_t query_brackets = 1000;
  /// Rows of one answer. Further rows are not returned.
  std::size_t rows = 1'000'000;
};

}  // namespace geminga::graph

#endif
