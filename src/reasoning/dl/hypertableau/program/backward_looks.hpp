// Backward looks: the edges between a node and its parent that stop another node from being its copy.
//
// Suppose that a node w is expanded and that b has its label. Then what is below w may stand below b, too, unless w is
// seen together with its parent by something that sees more than this pair: a bound, which counts the parent, or a
// clause about two neighbours. Where such a clause asks for a class of w, only nodes in that class look back. A clause
// about w and its parent alone is kept by b and its own parent, which have the labels and edges that it looks at.
//
// An at-least of w for which the parent is the witness is satisfied beside b by a copy of that parent, with a copy of
// all that is around it. But a nominal has no copy, and a denial that looks at neighbours would see the parent of b and
// the copy at once. So in ontologies with one of these an at-least looks back, too.
#ifndef GEMINGA_REASONING_DL_HYPERTABLEAU_PROGRAM_BACKWARD_LOOKS_HPP
#define GEMINGA_REASONING_DL_HYPERTABLEAU_PROGRAM_BACKWARD_LOOKS_HPP

#include <cstdint>
#include <span>
#include <vector>

#include "reasoning/dl/clauses/clause.hpp"
#include "reasoning/dl/hypertableau/program/denials.hpp"
#include "reasoning/dl/hypertableau/program/directions.hpp"

namespace geminga::hypertableau {

class BackwardLooks {
 public:
  BackwardLooks(const clauses::ClauseSet& set, const Denials& denials);

  /// Whether an edge may lead from a node to its parent, or anything looks against the direction of one. If not,
  /// nothing looks back.
  [[nodiscard]] bool has_inverses() const { return has_inverses_; }
  /// By the direction from a node to its parent: whether some node looks back along it.
  [[nodiscard]] const std::vector<bool>& directions() const { return is_looked_along_; }
  /// Whether every node looks back along it.
  [[nodiscard]] bool is_of_all(Direction direction) const { return is_of_all_[direction]; }
  /// The concepts of which a node must be in one to look back along it for a bound or clause; ascending.
  [[nodiscard]] std::span<const std::uint32_t> guards(Direction direction) const { return guards_[direction]; }
  /// Whether a node looks back along the directions of its at-leasts.
  [[nodiscard]] bool are_of_at_leasts() const { return are_of_at_leasts_; }

 private:
  void find_inverses(const clauses::ClauseSet& set);
  void note_inverses(const clauses::Clause& clause);
  void look(const clauses::Clause& clause);

  std::vector<bool> is_looked_along_;
  std::vector<bool> is_of_all_;
  std::vector<std::vector<std::uint32_t>> guards_;
  bool are_of_at_leasts_ = false;
  bool has_inverses_ = false;
};

}  // namespace geminga::hypertableau

#endif
