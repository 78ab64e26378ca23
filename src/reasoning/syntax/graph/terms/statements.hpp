// Triples as Redland holds them: kept and put in order.
#ifndef GEMINGA_REASONING_SYNTAX_GRAPH_TERMS_STATEMENTS_HPP
#define GEMINGA_REASONING_SYNTAX_GRAPH_TERMS_STATEMENTS_HPP

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "reasoning/syntax/graph/axioms/node.hpp"
#include "reasoning/syntax/graph/terms/world.hpp"

namespace geminga::graph {

/// Owns its statements. The world must outlive it.
class Statements {
 public:
  explicit Statements(World& world) : world_(world) {}
  Statements(const Statements&) = delete;
  Statements& operator=(const Statements&) = delete;
  ~Statements();

  /// False if memory is short or Redland cannot hold the triple.
  [[nodiscard]] bool add(const Node& subject, const Node& predicate, const Node& object);
  /// The same for a statement that the caller keeps.
  [[nodiscard]] bool add_copy(const raptor_statement* statement);
  /// Sorts them by what they say and drops repeats.
  void sort();
  /// Removes what another one has. Both must be sorted.
  void remove(const Statements& others);
  [[nodiscard]] World& world() const { return world_; }
  [[nodiscard]] std::size_t size() const { return all_.size(); }
  void for_each(const TripleSink& sink) const;
  [[nodiscard]] std::span<raptor_statement* const> all() const { return all_; }

 private:
  World& world_;
  std::vector<raptor_statement*> all_;
};

/// A new term; null if memory is short or Redland cannot hold it. A text of xsd:string is a plain one.
[[nodiscard]] raptor_term* new_term(World& world, const Node& node);
/// The octets of the texts of a term.
[[nodiscard]] std::size_t octets_of(const raptor_term& term);
/// A term as plain texts.
[[nodiscard]] Node node_of(const raptor_term& term);

}  // namespace geminga::graph

#endif
