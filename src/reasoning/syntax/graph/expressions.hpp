// The class expressions that a query asks for: ?x a [ a owl:Restriction ; owl:onProperty ... ].
//
// The OWL 2 entailment regime of SPARQL reads the blank nodes of such a pattern as one class expression (SPARQL 1.1
// Entailment Regimes, section 7). They are no triples of the graph: the reasoner finds the individuals that are in the
// expression, and the named classes that are below and above it.
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

/// The most class expressions that one query may ask for. Each costs a model of all facts, or a classification.
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
  bool asks_instances = false;  ///< it stands behind rdf:type
  bool asks_classes = false;    ///< it stands before or behind rdfs:subClassOf or owl:equivalentClass
};

/// The IRIs that are found for a class expression.
struct FoundNames {
  std::vector<std::string> instances;     ///< individuals that are in it in every model
  std::vector<std::string> subclasses;    ///< named classes below it, equivalent ones among them
  std::vector<std::string> superclasses;  ///< named classes above it, equivalent ones among them
};

/// Finds the names that a class expression asks for, or says in one line why it cannot.
using FindNames = std::function<std::expected<FoundNames, std::string>(const AskedExpression&)>;

/// The class expressions of a query, with the triples that answer their patterns and no others.
class Expressions {
  using Patterns = std::vector<rasqal_triple*>;

 public:
  explicit Expressions(World& world) : own_(world) {}

  /// Reads the triples of a query's pattern. Returns why it is refused, in one line: a variable in an expression behind
  /// rdf:type, or a blank node of an expression that stands elsewhere, too.
  [[nodiscard]] std::optional<std::string> read(const Patterns& patterns);
  /// How many there are.
  [[nodiscard]] std::size_t size() const { return asked_.size(); }
  /// Whether a class expression asks for triples of the graph, and not for names: it stands beside none of these words,
  /// or has a variable.
  [[nodiscard]] bool has_asserted() const { return has_asserted_; }
  /// Finds the names for each expression, or says why that failed.
  [[nodiscard]] std::optional<std::string> find(const FindNames& find_names);

  /// Whether a pattern is a part of an expression, or asks for the names of one.
  [[nodiscard]] bool answers(const rasqal_triple& pattern) const;
  /// Whether this is the label of a blank node of an expression. In such a pattern it stands for itself.
  [[nodiscard]] bool has_node(std::string_view label) const { return nodes_.contains(label); }
  /// The triples of the expressions, and one for each name that was found; sorted.
  [[nodiscard]] const Statements& triples() const { return own_; }

 private:
  using Labels = std::set<std::string, std::less<>>;

  /// Whether a pattern asks how names and an expression are related.
  [[nodiscard]] bool asks_names(const rasqal_triple& pattern) const;
  [[nodiscard]] bool add_triples(const Patterns& patterns, AskedExpression& expression) const;

  std::vector<AskedExpression> asked_;
  Labels roots_;
  Labels nodes_;
  Statements own_;
  bool has_asserted_ = false;
};

}  // namespace geminga::graph

#endif
