// Triples as Redland holds them: kept, put in order, and given out as a stream.
#ifndef GEMINGA_REASONING_SYNTAX_GRAPH_STATEMENTS_HPP
#define GEMINGA_REASONING_SYNTAX_GRAPH_STATEMENTS_HPP

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "reasoning/syntax/graph/node.hpp"
#include "reasoning/syntax/graph/world.hpp"

namespace geminga::graph {

/// Owns its statements. The world outlives it.
class Statements {
 public:
  explicit Statements(World& world) : world_(world) {}
  Statements(const Statements&) = delete;
  Statements& operator=(const Statements&) = delete;
  ~Statements();

  /// False: memory is short, or Redland cannot hold it.
  [[nodiscard]] bool add(const Node& subject, const Node& predicate, const Node& object);
  /// The same of a statement that stays its caller's.
  [[nodiscard]] bool add_copy(const raptor_statement* statement);
  /// Gives literals a form that Redland's Turtle writer writes right, and counts those that are marked for it. False:
  /// memory is short.
  [[nodiscard]] bool make_turtle_of(const Statements& others, std::size_t& marked);
  /// Each once, in an order that depends on nothing but what they say.
  void settle();
  /// Takes out what another one has; both are settled.
  void remove(const Statements& others);
  [[nodiscard]] std::size_t size() const { return all_.size(); }
  void for_each(const TripleSink& sink) const;
  /// Gives them out in their order; to be freed by librdf_free_stream() while they are there.
  [[nodiscard]] librdf_stream* stream() const;

 private:
  [[nodiscard]] raptor_term* term_of(const Node& node) const;

  World& world_;
  std::vector<raptor_statement*> all_;
};

/// A term as plain texts.
[[nodiscard]] Node node_of(const raptor_term& term);

}  // namespace geminga::graph

#endif
