// Directions: along which properties a concept or an at-least restriction speaks of neighbours.
//
// A universal of a node without neighbours is easily satisfied, and so is the first at-least of a property. What one
// node has shown of such an alternative says little of a node that has a neighbour in that direction.
#ifndef GEMINGA_REASONING_DL_HYPERTABLEAU_PROGRAM_DIRECTIONS_HPP
#define GEMINGA_REASONING_DL_HYPERTABLEAU_PROGRAM_DIRECTIONS_HPP

#include <cstdint>
#include <span>
#include <vector>

#include "reasoning/dl/clauses/clause.hpp"

namespace geminga::hypertableau {

/// A property from the subject to its value, or the way back.
using Direction = std::uint32_t;
[[nodiscard]] constexpr Direction direction_of(std::uint32_t property, bool is_inverse) {
  return 2 * property + (is_inverse ? 1U : 0U);
}
[[nodiscard]] constexpr Direction reverse(Direction direction) { return direction ^ 1U; }

class Directions {
 public:
  Directions(const clauses::ClauseSet& set, std::uint32_t concept_count);

  /// The directions in which clauses with this concept in the body have a neighbour, and those below them; ascending.
  [[nodiscard]] std::span<const Direction> of_concept(std::uint32_t id) const { return of_concept_[id]; }
  [[nodiscard]] std::span<const Direction> of_at_least(std::uint32_t index) const {
    return std::span(of_at_least_).subspan(index, 1);
  }

 private:
  void look(const clauses::Clause& clause);
  void add_below(std::vector<Direction>& directions) const;

  std::vector<std::vector<Direction>> of_concept_;
  std::vector<Direction> of_at_least_;
  std::vector<std::vector<Direction>> below_;  ///< by direction: what a clause says to be included
};

}  // namespace geminga::hypertableau

#endif
