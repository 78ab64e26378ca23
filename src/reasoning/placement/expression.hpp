// Where a class expression stands among the named classes of an ontology.
#ifndef GEMINGA_REASONING_PLACEMENT_EXPRESSION_HPP
#define GEMINGA_REASONING_PLACEMENT_EXPRESSION_HPP

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "reasoning/compiled/ontology.hpp"

namespace geminga::placement {

/// The place of an expression in the taxonomy of one ontology. Classes are representatives of their nodes, ascending.
/// Everything said here follows from the ontology; where `gaps` is empty, everything that follows is said.
struct ExpressionPlace {
  bool is_satisfiable = true;  ///< false: nothing can be an instance of it; then the lists are empty
  /// The node of the classes that it is equivalent to. `parents` and `children` are those of that node then.
  std::optional<taxonomy::ClassNumber> equivalent;
  std::vector<taxonomy::ClassNumber> parents;   ///< right above it; owl:Thing where nothing else is
  std::vector<taxonomy::ClassNumber> children;  ///< right below it, satisfiable ones
  /// Why something may be missing: short words, sorted, each once. Of what is equivalent to a class nothing is.
  std::vector<std::string> gaps;
  friend bool operator==(const ExpressionPlace&, const ExpressionPlace&) = default;
};

/// Whether every instance of the expression is one of the class, as far as its place says. An expression without
/// instances is below every class.
[[nodiscard]] bool is_below(const ExpressionPlace& place, taxonomy::ClassNumber super,
                            const compiled::Ontology& ontology);
/// Whether every instance of the class is one of the expression, as far as its place says.
[[nodiscard]] bool is_above(const ExpressionPlace& place, taxonomy::ClassNumber sub,
                            const compiled::Ontology& ontology);

/// Edges between them were the expression a class of the taxonomy, by the shortest way: 0 for an equivalent class, 1
/// for a parent, 1 more for each edge beyond. Nothing where the class is not above (below) it.
[[nodiscard]] std::optional<std::uint32_t> distance_up(const ExpressionPlace& place, taxonomy::ClassNumber super,
                                                       const compiled::Ontology& ontology);
[[nodiscard]] std::optional<std::uint32_t> distance_down(const ExpressionPlace& place, taxonomy::ClassNumber sub,
                                                         const compiled::Ontology& ontology);

/// Every class above it, owl:Thing and its equivalents included, ascending by number. All of them where it has no
/// instances.
[[nodiscard]] std::vector<taxonomy::ClassNumber> subsumers(const ExpressionPlace& place,
                                                           const compiled::Ontology& ontology);

}  // namespace geminga::placement

#endif
