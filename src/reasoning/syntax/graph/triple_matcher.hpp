// The rows of a pattern that is triples alone (SPARQL 1.1 Query Language, section 18.3.1).
#ifndef GEMINGA_REASONING_SYNTAX_GRAPH_TRIPLE_MATCHER_HPP
#define GEMINGA_REASONING_SYNTAX_GRAPH_TRIPLE_MATCHER_HPP

#include <cstddef>
#include <set>
#include <unordered_map>
#include <vector>

#include "reasoning/syntax/graph/expressions.hpp"
#include "reasoning/syntax/graph/terms/terms.hpp"
#include "reasoning/syntax/graph/triple_index.hpp"

namespace geminga::graph {

/// Finds triples of the graph, and of class expressions, for those of a pattern. Borrows everything. Where the index
/// ends the search, what is found is not all.
class TripleMatcher {
 public:
  using Triples = std::vector<const rasqal_triple*>;

  TripleMatcher(Terms& terms, Variables& variables, TripleIndex& index, const Expressions& expressions)
      : terms_(terms), variables_(variables), index_(index), expressions_(expressions) {}

  /// The triples of a pattern that is triples alone.
  [[nodiscard]] static Triples triples_of(rasqal_graph_pattern* basic);
  /// Appends the rows that agree with a row and bind all variables of the triples, until there are `most`; 0: all.
  void match(Triples triples, Row row, std::size_t most, Rows& found);
  /// Adds the variables that each of these rows binds.
  void add_variables(const Triples& triples, std::set<std::size_t>& variables) const;

 private:
  /// The place of the triple of which the most is known; the first of them.
  [[nodiscard]] std::size_t place_of_next(const Triples& triples, const Row& row);
  /// The number of what stands in a triple; `unbound` for a variable without a value.
  [[nodiscard]] TermNumber known(rasqal_literal* literal, const Row& row, bool is_of_expression);

  Terms& terms_;
  Variables& variables_;
  TripleIndex& index_;
  const Expressions& expressions_;
  std::unordered_map<const rasqal_literal*, TermNumber> constants_;
};

}  // namespace geminga::graph

#endif
