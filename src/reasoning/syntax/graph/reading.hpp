// A query as rasqal reads it, with the queries and the values within it.
//
// rasqal gives out the patterns of a query, and neither what an inner query selects nor the rows of VALUES. These are
// read again from the text, each as a query of its own.
#ifndef GEMINGA_REASONING_SYNTAX_GRAPH_READING_HPP
#define GEMINGA_REASONING_SYNTAX_GRAPH_READING_HPP

#include <expected>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include "reasoning/syntax/graph/terms/terms.hpp"

namespace geminga::graph {

struct FreeQuery {
  void operator()(rasqal_query* query) const { rasqal_free_query(query); }
};
using OwnedQuery = std::unique_ptr<rasqal_query, FreeQuery>;

/// A block of VALUES.
struct GivenValues {
  std::vector<std::string> variables;
  Rows rows;  ///< by place among the variables; `unbound` is UNDEF
};

/// The sub-patterns of a pattern.
[[nodiscard]] std::vector<rasqal_graph_pattern*> parts_of(rasqal_graph_pattern* pattern);

class ReadQuery {
 public:
  /// Reads a query, or says in one line why it cannot be read or is refused: what would fetch or change something, and
  /// what is not computed here. `is_inner` says that it stands in another one.
  [[nodiscard]] static std::expected<std::unique_ptr<ReadQuery>, std::string> read(Terms& terms,
                                                                                   const std::string& text,
                                                                                   bool is_inner = false);

  [[nodiscard]] rasqal_query* query() const { return query_.get(); }
  [[nodiscard]] rasqal_graph_pattern* pattern() const { return rasqal_query_get_query_graph_pattern(query_.get()); }
  /// The query of a SELECT within the pattern.
  [[nodiscard]] const ReadQuery& inner(const rasqal_graph_pattern* pattern) const {
    return *inner_[place_of_inner_.at(pattern)];
  }
  /// The queries directly within it, in the order of the text.
  [[nodiscard]] const std::vector<std::unique_ptr<ReadQuery>>& inner_queries() const { return inner_; }
  /// The formula that computes a variable with AS; null for one that the pattern binds. rasqal has one variable for
  /// those of the same name in a query and in one within it.
  [[nodiscard]] const rasqal_expression* formula_of(const rasqal_variable& variable) const;
  /// The variables that SELECT * gives out: those that its pattern binds, and not those of MINUS and EXISTS alone.
  [[nodiscard]] std::set<std::string, std::less<>> visible() const;
  /// The triples of its pattern, without those of inner queries.
  [[nodiscard]] std::vector<rasqal_triple*> triples() const;
  /// The values of a VALUES within the pattern.
  [[nodiscard]] const GivenValues& values(const rasqal_graph_pattern* pattern) const { return values_.at(pattern); }
  /// The values behind the pattern; null if there are none.
  [[nodiscard]] const GivenValues* last_values() const { return last_ ? &*last_ : nullptr; }

 private:
  ReadQuery() = default;
  [[nodiscard]] std::optional<std::string> read_inner(Terms& terms, const std::string& text);

  OwnedQuery query_;
  std::vector<std::unique_ptr<ReadQuery>> inner_;
  std::unordered_map<const rasqal_graph_pattern*, std::size_t> place_of_inner_;
  std::unordered_map<const rasqal_graph_pattern*, GivenValues> values_;
  std::optional<GivenValues> last_;
};

/// The projected variables of a query, in their order.
[[nodiscard]] std::vector<const rasqal_variable*> selected(const ReadQuery& read);

}  // namespace geminga::graph

#endif
