// The rows that a query makes of those of its pattern: groups, aggregates, order, and the parts that are asked for
// (SPARQL 1.1 Query Language, sections 11 and 15).
#ifndef GEMINGA_REASONING_SYNTAX_GRAPH_SELECTION_HPP
#define GEMINGA_REASONING_SYNTAX_GRAPH_SELECTION_HPP

#include <optional>
#include <string>
#include <vector>

#include "reasoning/syntax/graph/formulas/formulas.hpp"
#include "reasoning/syntax/graph/reading.hpp"

namespace geminga::graph {

/// Why what a query selects is refused, in one line; nothing if it is not.
[[nodiscard]] std::optional<std::string> refusal_of_selected(const ReadQuery& read);

/// The most rows of the pattern that the result needs; 0: all.
[[nodiscard]] std::size_t rows_needed(const ReadQuery& read, std::size_t most);

/// Groups, orders and cuts the rows of a pattern, and computes what is selected with AS.
[[nodiscard]] Rows selected_rows(const ReadQuery& read, Rows rows, Terms& terms, Variables& variables,
                                 Formulas& formulas);

}  // namespace geminga::graph

#endif
