// The class expressions for whose instances a query asks: ?x a [ a owl:Restriction ; owl:onProperty ... ].
//
// The OWL 2 entailment regime of SPARQL reads the blank nodes of such a pattern as one class expression (SPARQL 1.1
// Entailment Regimes, section 7). They are no triples of the graph: the reasoner finds the instances.
#ifndef GEMINGA_REASONING_SYNTAX_GRAPH_EXPRESSIONS_HPP
#define GEMINGA_REASONING_SYNTAX_GRAPH_EXPRESSIONS_HPP

#include <cstddef>
#include <expected>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "reasoning/syntax/graph/axioms/node.hpp"
#include "reasoning/syntax/graph/terms/statements.hpp"
#include "reasoning/syntax/graph/terms/world.hpp"

namespace geminga::graph {

/// The most class expressions that one query may ask for. Each costs a model of all facts.
inline constexpr std::size_t max_expressions = 16;

/// The triples of a class expression. The labels of its blank nodes are the query's.
struct AskedExpression {
  struct Triple {
    Node subject;
    Node predicate;
    Node object;
  };
  Node root;  ///< blank
  std::vector<Triple> triples;
};

/// Finds the IRIs of the individuals of a class expression, or says in one line why it cannot.
using FindInstances = std::function<std::expected<std::vector<std::string>, std::string>(const AskedExpression&)>;

/// The class expressions of a query, with the triples that answer their patterns and no others.
class Expressions {
 public:
  explicit Expressions(World& world) : own_(world) {}

  /// Reads the triples of a query's pattern. Returns why it is refused, in one line: a variable in an expression, or a
  /// blank node of an expression that stands elsewhere, too.
  [[nodiscard]] std::optional<std::string> read(const std::vector<rasqal_triple*>& patterns);
  /// How many there are.
  [[nodiscard]] std::size_t size() const { return asked_.size(); }
  /// Finds the instances of each expression, or says why that failed.
  [[nodiscard]] std::optional<std::string> find(const FindInstances& find_instances);

  /// Whether a pattern is a part of an expression, or asks for the instances of one.
  [[nodiscard]] bool answers(const rasqal_triple& pattern) const;
  /// Whether this is the label of a blank node of an expression. In such a pattern it stands for itself.
  [[nodiscard]] bool has_node(std::string_view label) const { return nodes_.contains(label); }
  /// The triples of the expressions, and one of rdf:type for each instance; sorted.
  [[nodiscard]] const Statements& triples() const { return own_; }

 private:
  [[nodiscard]] std::optional<std::string> take(std::string_view root, const std::vector<rasqal_triple*>& patterns);

  std::vector<AskedExpression> asked_;
  std::set<std::string, std::less<>> roots_;
  std::set<std::string, std::less<>> nodes_;
  Statements own_;
};

}  // namespace geminga::graph

#endif
