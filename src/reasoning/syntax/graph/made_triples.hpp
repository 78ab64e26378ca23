// The triples that a query makes: CONSTRUCT and DESCRIBE (SPARQL 1.1 Query Language, sections 16.2 and 16.4).
#ifndef GEMINGA_REASONING_SYNTAX_GRAPH_MADE_TRIPLES_HPP
#define GEMINGA_REASONING_SYNTAX_GRAPH_MADE_TRIPLES_HPP

#include <cstddef>
#include <expected>
#include <string>
#include <vector>

#include "reasoning/syntax/graph/graph.hpp"
#include "reasoning/syntax/graph/limits.hpp"
#include "reasoning/syntax/graph/reading.hpp"
#include "reasoning/syntax/graph/terms/statements.hpp"
#include "reasoning/syntax/graph/triple_index.hpp"

namespace geminga::graph {

/// The triples of an answer, up to `rows` triples and `query_octets` of the limits. The world must outlive it.
class MadeTriples {
 public:
  MadeTriples(World& world, const GraphLimits& limits) : statements_(world), limits_(limits) {}

  /// False: it is one more than the limits allow, and is left out. The error is that memory is short.
  [[nodiscard]] std::expected<bool, std::string> add(const Node& subject, const Node& predicate, const Node& object);
  /// The same for a statement that the caller keeps.
  [[nodiscard]] std::expected<bool, std::string> add_copy(const raptor_statement& statement);

  /// Sorts the triples and writes them. The error is that memory is short.
  [[nodiscard]] std::expected<std::string, std::string> sorted_text(Format format, const Prefixes& prefixes);

 private:
  /// Takes room for a triple with texts of so many octets. False where there is none.
  [[nodiscard]] bool take_room(std::size_t text_octets);

  Statements statements_;
  const GraphLimits& limits_;
  std::size_t octets_ = 0;
};

/// Makes the triples of the query's template, or of its pattern where it has none, for each row. False where `made` has
/// no room for all.
[[nodiscard]] std::expected<bool, std::string> construct(const ReadQuery& read, const Rows& rows, Terms& terms,
                                                         Variables& variables, MadeTriples& made);

/// The resources that DESCRIBE names or that its rows hold, each once, in the order in which they are met.
[[nodiscard]] std::vector<TermNumber> resources_of(const ReadQuery& read, const Rows& rows, Terms& terms,
                                                   Variables& variables);
/// Adds the triples whose subject is one of the resources, with those of the blank nodes that they lead to. False where
/// `made` has no room for all. Beyond a limit of the index it finds no more.
[[nodiscard]] std::expected<bool, std::string> describe(std::vector<TermNumber> resources, Terms& terms,
                                                        TripleIndex& index, MadeTriples& made);

}  // namespace geminga::graph

#endif
