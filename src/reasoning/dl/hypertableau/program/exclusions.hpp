// Which concepts, and which properties, exclude each other, as far as single clauses say it: A(x), B(x) -> false, and
// R(x,y), S(x,y) -> false.
#ifndef GEMINGA_REASONING_DL_HYPERTABLEAU_PROGRAM_EXCLUSIONS_HPP
#define GEMINGA_REASONING_DL_HYPERTABLEAU_PROGRAM_EXCLUSIONS_HPP

#include <cstdint>
#include <vector>

#include "reasoning/dl/clauses/clause.hpp"
#include "reasoning/dl/hypertableau/program/hierarchy.hpp"

namespace geminga::hypertableau {

/// The exclusions of concepts. Borrows the hierarchy of concepts.
class ConceptExclusions {
 public:
  ConceptExclusions(const clauses::ClauseSet& set, Hierarchy& hierarchy);

  /// Those that something above the concept excludes, or that all alternatives of a union above it exclude; ascending.
  [[nodiscard]] std::vector<std::uint32_t> of(std::uint32_t id);

 private:
  void look(const clauses::Clause& clause);
  [[nodiscard]] std::vector<std::uint32_t> told_of(std::uint32_t id);

  Hierarchy& hierarchy_;
  std::vector<std::vector<std::uint32_t>> told_;                 ///< by concept: A(x), B(x) -> false
  std::vector<std::vector<std::vector<std::uint32_t>>> unions_;  ///< by concept: the alternatives of each
};

/// The exclusions of properties, by directions (directions.hpp) and behind those data properties. Borrows their
/// hierarchy.
class RoleExclusions {
 public:
  RoleExclusions(const clauses::ClauseSet& set, Hierarchy& hierarchy);

  /// The directions that something above this one excludes: no thing has a neighbour along both. Ascending.
  [[nodiscard]] std::vector<std::uint32_t> of(std::uint32_t direction);

 private:
  void add(std::uint32_t one, std::uint32_t other);

  Hierarchy& hierarchy_;
  std::vector<std::vector<std::uint32_t>> told_;  ///< by direction
};

}  // namespace geminga::hypertableau

#endif
