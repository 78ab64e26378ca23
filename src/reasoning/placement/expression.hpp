// The place of a class expression among the named classes of an ontology.
#ifndef GEMINGA_REASONING_PLACEMENT_EXPRESSION_HPP
#define GEMINGA_REASONING_PLACEMENT_EXPRESSION_HPP

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "reasoning/taxonomy/class_number.hpp"

namespace geminga::compiled {
class Ontology;
}

namespace geminga::placement {

/// The place of an expression in the taxonomy of one ontology. Classes are representatives of their nodes, ascending.
/// Everything here follows from the ontology. If `gaps` is empty, nothing is missing.
struct ExpressionPlace {
  bool is_satisfiable = true;  ///< false: nothing can be an instance of it; then the lists are empty
  /// The node of the classes that it is equivalent to, if any. Then `parents` and `children` are those of that node.
  std::optional<taxonomy::ClassNumber> equivalent;
  std::vector<taxonomy::ClassNumber> parents;   ///< right above it; owl:Thing if no other class is
  std::vector<taxonomy::ClassNumber> children;  ///< satisfiable classes right below it
  /// The reasons why something may be missing: short words, sorted, each once. Nothing is missing for an expression
  /// that is equivalent to a class.
  std::vector<std::string> gaps;
  friend bool operator==(const ExpressionPlace&, const ExpressionPlace&) = default;
};

/// True if, by its place, every instance of the expression is one of the class. An expression without instances is
/// below every class.
[[nodiscard]] bool is_below(const ExpressionPlace& place, taxonomy::ClassNumber super,
                            const compiled::Ontology& ontology);
/// True if, by its place, every instance of the class is one of the expression.
[[nodiscard]] bool is_above(const ExpressionPlace& place, taxonomy::ClassNumber sub,
                            const compiled::Ontology& ontology);

/// The number of edges between them on the shortest path, as if the expression were a class of the taxonomy: 0 for an
/// equivalent class, 1 for a parent, and 1 more for each further edge. Nothing if the class is not above (below) it.
[[nodiscard]] std::optional<std::uint32_t> distance_up(const ExpressionPlace& place, taxonomy::ClassNumber super,
                                                       const compiled::Ontology& ontology);
[[nodiscard]] std::optional<std::uint32_t> distance_down(const ExpressionPlace& place, taxonomy::ClassNumber sub,
                                                         const compiled::Ontology& ontology);

/// Every class above it, including owl:Thing and its equivalents, ascending by number. If the expression has no
/// instances, these are all classes.
[[nodiscard]] std::vector<taxonomy::ClassNumber> subsumers(const ExpressionPlace& place,
                                                           const compiled::Ontology& ontology);

}  // namespace geminga::placement

#endif
