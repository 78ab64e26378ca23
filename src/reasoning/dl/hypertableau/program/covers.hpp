// Bounds that cover a union together.
//
//   >= n R.A(x), each A being B1 or ... or Bk, <= mi Si.Bi(x) for each i, R below each Si -> false
//   where the numbers of the different bounds among them are less than n together
//
// The union may be that of a class, of a range, or of a universal that holds of x. An alternative of which x may have
// no neighbour adds nothing, and one without a bound that is itself a union adds the bounds of its alternatives. A
// neighbour in several concepts is in what follows from them together: in A and B1, if it is in A and one of B1 or B2.
#ifndef GEMINGA_REASONING_DL_HYPERTABLEAU_PROGRAM_COVERS_HPP
#define GEMINGA_REASONING_DL_HYPERTABLEAU_PROGRAM_COVERS_HPP

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "reasoning/dl/clauses/clause.hpp"
#include "reasoning/dl/hypertableau/program/bound.hpp"
#include "reasoning/dl/hypertableau/program/hierarchy.hpp"

namespace geminga::hypertableau {

/// Most `count` neighbours, if the bound holds of the node. Without a bound: none, if the node is in all of the guard.
struct Limit {
  std::uint32_t count = 0;
  std::uint32_t bound = no_predicate;
  std::vector<std::uint32_t> guard;
};

/// If the node is in all of the guard, each neighbour that an at-least asks for is among those of one of the
/// alternatives, which one of its limits limits.
struct Cover {
  std::vector<std::uint32_t> guard;
  std::vector<std::vector<Limit>> alternatives;  ///< the limits of each, ascending by number
};

class Covers {
 public:
  /// The clauses that are looked at for all at-leasts together, and the covers of one. Beyond these, covers are left
  /// out.
  static constexpr std::size_t max_looks = 500'000;
  static constexpr std::size_t max_covers = 64;

  Covers() = default;
  /// The `inclusions` are clauses A(x) -> B(x) that follow from the set.
  Covers(const clauses::ClauseSet& set, std::span<const clauses::Clause> inclusions, std::span<const Bound> bounds);

  /// Those that may allow fewer neighbours than the at-least asks for.
  [[nodiscard]] std::span<const Cover> of(std::uint32_t at_least) const {
    return at_least < covers_.size() ? covers_[at_least] : std::span<const Cover>();
  }
  [[nodiscard]] bool is_any_of(std::uint32_t bound) const { return bound < is_used_.size() && is_used_[bound]; }

 private:
  /// A clause about a neighbour y of x: what it asks of both, the direction from x to y if it asks for one, and what y
  /// is one of.
  struct Said {
    std::vector<std::uint32_t> of_node;
    std::vector<std::uint32_t> of_neighbour;  ///< ascending
    std::uint32_t direction = no_predicate;
    std::vector<std::uint32_t> alternatives;
  };
  /// The neighbours of an at-least: the directions in which they are, and the concepts that they are in; ascending.
  struct Asked {
    std::vector<std::uint32_t> directions;
    std::vector<std::uint32_t> concepts;
  };

  void look(const clauses::Clause& clause, clauses::Variable node, clauses::Variable neighbour);
  void look(const clauses::Clause& clause);
  [[nodiscard]] std::vector<const Said*> said_of(const Asked& asked);
  void add_joint(Asked& asked);
  [[nodiscard]] std::vector<Limit> limits_of(const Asked& asked);
  [[nodiscard]] bool add_limits(const Asked& asked, std::uint32_t alternative, int depth, Cover& cover);
  void find_covers(const clauses::AtLeast& at_least, std::vector<Cover>& found);

  std::span<const Bound> bounds_;  ///< only while it is constructed
  Hierarchy roles_{0};
  Hierarchy concepts_{0};
  std::vector<Said> said_;
  std::map<std::uint32_t, std::vector<std::uint32_t>> by_concept_;    ///< said_ that ask this of the neighbour first
  std::map<std::uint32_t, std::vector<std::uint32_t>> by_direction_;  ///< said_ that ask for nothing of it but this
  std::map<std::uint32_t, std::vector<std::uint32_t>> bounds_in_;     ///< by direction
  std::vector<std::vector<Cover>> covers_;                            ///< by at-least
  std::vector<bool> is_used_;                                         ///< by bound
  std::size_t looks_ = 0;
};

}  // namespace geminga::hypertableau

#endif
