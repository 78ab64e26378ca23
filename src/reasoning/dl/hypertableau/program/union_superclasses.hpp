// Superclasses of unions, as far as bounds count them.
//
//   A(x) -> B1(x) or ... or Bn(x),  each Bi below F    so    A(x) -> F(x)
//
// An instance of A is in F whichever alternative holds. If F is the filler of a bound, a neighbour in A counts before
// anything is chosen; a clash of too many neighbours then depends on no alternative of theirs.
#ifndef GEMINGA_REASONING_DL_HYPERTABLEAU_PROGRAM_UNION_SUPERCLASSES_HPP
#define GEMINGA_REASONING_DL_HYPERTABLEAU_PROGRAM_UNION_SUPERCLASSES_HPP

#include <cstdint>
#include <span>
#include <vector>

#include "reasoning/dl/clauses/clause.hpp"

namespace geminga::hypertableau {

class UnionSuperclasses {
 public:
  /// The concepts and unions that are looked at for all fillers together. Beyond it, superclasses are left out.
  static constexpr std::size_t max_looks = 2'000'000;

  /// Looks for the unions below each of the fillers. It knows the inclusions that single clauses say, and those that it
  /// finds.
  UnionSuperclasses(const clauses::ClauseSet& set, std::span<const std::uint32_t> fillers);

  /// The inclusions that it found, one clause A(x) -> F(x) for each.
  [[nodiscard]] const std::vector<clauses::Clause>& clauses() const { return clauses_; }

 private:
  struct Union {
    std::uint32_t concept_id = 0;
    std::uint32_t alternatives = 0;
    std::uint32_t below = 0;  ///< of the alternatives, those that are below the filler in question
  };
  void look(const clauses::Clause& clause);
  void find_below(std::uint32_t filler);

  std::vector<Union> unions_;
  std::vector<std::vector<std::uint32_t>> told_below_;  ///< by concept
  std::vector<std::vector<std::uint32_t>> in_unions_;   ///< by concept: the unions of which it is an alternative
  std::vector<std::uint32_t> found_for_;                ///< by concept: the number of the last filler above it
  std::uint32_t fillers_ = 0;
  std::size_t looks_ = 0;
  std::vector<clauses::Clause> clauses_;
};

}  // namespace geminga::hypertableau

#endif
