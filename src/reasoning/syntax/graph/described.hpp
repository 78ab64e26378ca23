// DESCRIBE (SPARQL 1.1 Query Language, section 16.4): the statements about resources.
#ifndef GEMINGA_REASONING_SYNTAX_GRAPH_DESCRIBED_HPP
#define GEMINGA_REASONING_SYNTAX_GRAPH_DESCRIBED_HPP

#include <expected>
#include <string>

#include "reasoning/syntax/graph/limits.hpp"
#include "reasoning/syntax/graph/reading.hpp"
#include "reasoning/syntax/graph/statements.hpp"
#include "reasoning/syntax/graph/triple_index.hpp"

namespace geminga::graph {

/// Adds the triples whose subject is a resource that the query names or that its rows hold, with those of the blank
/// nodes that they lead to. False where that is more than `limits.rows` triples or `limits.query_octets`, and some are
/// left out; the reason in one line where memory is short. Beyond a limit of the index it finds no more.
[[nodiscard]] std::expected<bool, std::string> describe(const ReadQuery& read, const Rows& rows, Terms& terms,
                                                        Variables& variables, TripleIndex& index,
                                                        const GraphLimits& limits, Statements& made);

}  // namespace geminga::graph

#endif
