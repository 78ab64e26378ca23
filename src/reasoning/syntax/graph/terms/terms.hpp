// The terms of one query: those of the graph that it meets and those that it makes, each with a number.
#ifndef GEMINGA_REASONING_SYNTAX_GRAPH_TERMS_TERMS_HPP
#define GEMINGA_REASONING_SYNTAX_GRAPH_TERMS_TERMS_HPP

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "reasoning/syntax/graph/terms/literals.hpp"
#include "reasoning/syntax/graph/terms/statements.hpp"

namespace geminga::graph {

/// The number of a term. Equal terms have one number.
using TermNumber = std::uint32_t;
/// The number of no term: a variable that is not bound.
inline constexpr TermNumber unbound = 0;

/// The values of a query's variables, by the number of the variable.
using Row = std::vector<TermNumber>;
using Rows = std::vector<Row>;

/// Numbers terms. References to nodes stay valid.
class Terms {
 public:
  explicit Terms(World& world) : world_(world) { entries_.emplace_back(); }

  /// The number of a term of the graph, which must outlive this; found by its address after the first time.
  [[nodiscard]] TermNumber number_of(const raptor_term& term);
  /// The number of any node; `unbound` for none. A text of xsd:string is the plain one (RDF 1.1 Concepts, section 3.3).
  [[nodiscard]] TermNumber number_of(const std::optional<Node>& node);
  /// Null for `unbound`, and if memory is short.
  [[nodiscard]] raptor_term* term(TermNumber number);
  [[nodiscard]] const Node& node(TermNumber number) const { return entries_[number].node; }
  [[nodiscard]] World& world() const { return world_; }

 private:
  struct Entry {
    Node node;
    OwnedTerm term;
  };
  World& world_;
  std::deque<Entry> entries_;
  std::unordered_map<const raptor_term*, TermNumber> by_address_;
  std::unordered_map<std::string, TermNumber> by_text_;
};

/// The variables of a query by their names. That of a blank node has a name that no variable has.
class Variables {
 public:
  /// The number of a variable, which is a new one for a new name.
  [[nodiscard]] std::size_t number_of(const rasqal_variable& variable);
  [[nodiscard]] std::size_t number_of(const std::string& name);
  [[nodiscard]] std::size_t size() const { return numbers_.size(); }

 private:
  std::unordered_map<std::string, std::size_t> numbers_;
};

/// The value of a variable in a row, which may be older than the variable.
[[nodiscard]] inline TermNumber value_in(const Row& row, std::size_t variable) {
  return variable < row.size() ? row[variable] : unbound;
}
/// Sets it.
inline void set_in(Row& row, std::size_t variable, TermNumber value) {
  if (variable >= row.size()) row.resize(variable + 1, unbound);
  row[variable] = value;
}

}  // namespace geminga::graph

#endif
