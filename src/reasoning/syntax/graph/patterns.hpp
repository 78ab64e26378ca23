// The solutions of a query's patterns (SPARQL 1.1 Query Language, section 18).
#ifndef GEMINGA_REASONING_SYNTAX_GRAPH_PATTERNS_HPP
#define GEMINGA_REASONING_SYNTAX_GRAPH_PATTERNS_HPP

#include <functional>
#include <set>
#include <span>
#include <vector>

#include "reasoning/syntax/graph/expressions.hpp"
#include "reasoning/syntax/graph/formulas/formulas.hpp"
#include "reasoning/syntax/graph/reading.hpp"
#include "reasoning/syntax/graph/triple_index.hpp"
#include "reasoning/syntax/graph/triple_matcher.hpp"

namespace geminga::graph {

/// Finds the rows of an inner query, with its variables and their numbers in the outer one.
using FindInner = std::function<Rows(const ReadQuery& inner)>;

/// Evaluates the patterns of one query. Borrows everything. Where the index ends the search, what is found is not all.
class Patterns {
 public:
  Patterns(const ReadQuery& read, Terms& terms, Variables& variables, Formulas& formulas, TripleIndex& index,
           const Expressions& expressions, FindInner find_inner);

  /// The rows of the whole pattern; `most` is as many as are wanted, where no more are needed.
  [[nodiscard]] Rows rows(std::size_t most);
  /// Both together, where they agree.
  [[nodiscard]] Rows joined(const Rows& first, const Rows& second);
  /// Values as rows.
  [[nodiscard]] Rows rows_of(const GivenValues& values);

 private:
  using Parts = std::vector<rasqal_graph_pattern*>;
  using VariableSet = std::set<std::size_t>;

  /// The parts of a group, or the pattern itself.
  [[nodiscard]] static Parts group_of(rasqal_graph_pattern* pattern);
  /// The parts of the group of OPTIONAL or MINUS.
  [[nodiscard]] static Parts group_below(rasqal_graph_pattern* pattern);

  /// The rows of a group that agree with `seed`, whose variables are certain in the group.
  [[nodiscard]] Rows evaluate(const Parts& group, const Row& seed);
  [[nodiscard]] Rows evaluate_one(rasqal_graph_pattern* pattern, const Row& seed);
  [[nodiscard]] Rows unfiltered(const Parts& group, const Row& seed);
  /// Takes a part of a group to the rows so far.
  void take(rasqal_graph_pattern* part, Rows& rows);
  void keep_those_that_hold(const Parts& group, Rows& rows);
  [[nodiscard]] bool exists(const Parts& group, const Row& row);
  [[nodiscard]] Rows with_optional(const Rows& rows, rasqal_graph_pattern* optional);
  [[nodiscard]] Rows without(const Rows& rows, rasqal_graph_pattern* minus);
  [[nodiscard]] Rows with_group(const Rows& rows, rasqal_graph_pattern* pattern);
  [[nodiscard]] Rows with_value(Rows rows, rasqal_graph_pattern* let);

  /// The variables that each row of a group binds before anything is optional. What a group is asked for with them is
  /// what it says of them (section 18.2: joins do not care for order).
  [[nodiscard]] VariableSet certain(const Parts& group);
  [[nodiscard]] static Row restricted(const Row& row, const VariableSet& to);

  const ReadQuery& read_;
  Terms& terms_;
  Variables& variables_;
  Formulas& formulas_;
  TripleIndex& index_;
  TripleMatcher matcher_;
  FindInner find_inner_;
  std::size_t most_ = 0;  ///< rows of the triples that are matched; 0: all
};

}  // namespace geminga::graph

#endif
