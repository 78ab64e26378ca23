// The triples of a graph, found by binary search in a query, with each step counted.
#ifndef GEMINGA_REASONING_SYNTAX_GRAPH_TRIPLE_INDEX_HPP
#define GEMINGA_REASONING_SYNTAX_GRAPH_TRIPLE_INDEX_HPP

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/budget.hpp"
#include "reasoning/syntax/graph/limits.hpp"
#include "reasoning/syntax/graph/terms/world.hpp"

namespace geminga::graph {

/// Sorted views of the triples of one graph, which must outlive it and stay as it is. Beyond a limit every search finds
/// nothing more, and problem() says why.
class TripleIndex {
 public:
  /// `sorted` as raptor_statement_compare() orders them. `budget` (null: no limit) counts the triples that are looked
  /// at, and each search as one.
  TripleIndex(std::span<raptor_statement* const> sorted, const GraphLimits& limits, base::Budget* budget);

  /// The limit that ended the query; nothing while none has.
  [[nodiscard]] const std::optional<std::string>& problem() const { return problem_; }

  /// Counts a step. False beyond a limit.
  bool step();

  /// The triples that match a pattern, in which null stands for anything; some more may be among them.
  [[nodiscard]] std::span<raptor_statement* const> candidates(const raptor_statement& pattern) const;
  /// The same among a few triples, which are sorted as those of the index.
  [[nodiscard]] static std::span<raptor_statement* const> candidates(std::span<raptor_statement* const> sorted,
                                                                     const raptor_statement& pattern);

 private:
  std::span<raptor_statement* const> by_subject_;
  std::vector<raptor_statement*> by_predicate_;
  std::vector<raptor_statement*> by_object_;
  std::size_t most_octets_;
  std::size_t octets_at_begin_;
  base::Budget* budget_;
  std::uint64_t steps_ = 0;
  std::optional<std::string> problem_;
};

/// Whether a triple matches a pattern.
[[nodiscard]] bool fits(const raptor_statement& statement, const raptor_statement& pattern);

}  // namespace geminga::graph

#endif
