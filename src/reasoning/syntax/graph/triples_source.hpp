// The triples of a graph, and the instances of a query's class expressions, as rasqal asks for them.
#ifndef GEMINGA_REASONING_SYNTAX_GRAPH_TRIPLES_SOURCE_HPP
#define GEMINGA_REASONING_SYNTAX_GRAPH_TRIPLES_SOURCE_HPP

#include <memory>
#include <span>

#include "reasoning/syntax/graph/expressions.hpp"
#include "reasoning/syntax/graph/triple_index.hpp"
#include "reasoning/syntax/graph/world.hpp"

namespace geminga::graph {

struct FreeStatement {
  void operator()(raptor_statement* statement) const { raptor_free_statement(statement); }
};
using OwnedStatement = std::unique_ptr<raptor_statement, FreeStatement>;

/// Answers the patterns of one query: those of class expressions by their own triples, all others by the index. Borrows
/// everything, which must outlive the results of the query.
class TriplesSource {
 public:
  TriplesSource(World& world, TripleIndex& index, const Expressions& expressions)
      : world_(world), index_(index), expressions_(expressions) {}
  TriplesSource(const TriplesSource&) = delete;
  TriplesSource& operator=(const TriplesSource&) = delete;

  /// Makes the query ask this source. False if memory is short.
  [[nodiscard]] bool serve(rasqal_query* query);

  /// A pattern with what is known of it when it is asked.
  struct Asked {
    OwnedStatement pattern;  ///< null parts stand for anything
    std::span<raptor_statement* const> candidates;
  };
  /// The triples among which those are that match a pattern of the query.
  [[nodiscard]] Asked asked(const rasqal_triple& pattern) const;
  [[nodiscard]] World& world() const { return world_; }
  [[nodiscard]] TripleIndex& index() const { return index_; }

 private:
  World& world_;
  TripleIndex& index_;
  const Expressions& expressions_;
};

}  // namespace geminga::graph

#endif
