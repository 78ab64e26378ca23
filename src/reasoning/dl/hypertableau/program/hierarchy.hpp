// Inclusions that single clauses say: A(x) -> B(x), R(x,y) -> S(x,y), U(x,v) -> V(x,v).
#ifndef GEMINGA_REASONING_DL_HYPERTABLEAU_PROGRAM_HIERARCHY_HPP
#define GEMINGA_REASONING_DL_HYPERTABLEAU_PROGRAM_HIERARCHY_HPP

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "reasoning/dl/clauses/clause.hpp"

namespace geminga::hypertableau {

/// The things above each of many things, as far as it is told.
class Hierarchy {
 public:
  explicit Hierarchy(std::size_t count) : above_(count), found_by_(count, 0) {}
  void add(std::uint32_t low, std::uint32_t high) { above_[low].push_back(high); }
  /// Ascending, with `start`.
  [[nodiscard]] std::vector<std::uint32_t> all_above(std::uint32_t start);

 private:
  std::vector<std::vector<std::uint32_t>> above_;
  std::vector<std::uint32_t> found_by_;  ///< the last search that found it
  std::uint32_t searches_ = 0;
};

/// By the numbers of concepts. The `inclusions` are clauses A(x) -> B(x) that follow from the set.
[[nodiscard]] Hierarchy hierarchy_of_concepts(const clauses::ClauseSet& set,
                                              std::span<const clauses::Clause> inclusions);
/// By directions (directions.hpp); behind those, data properties.
[[nodiscard]] Hierarchy hierarchy_of_roles(const clauses::ClauseSet& set);

}  // namespace geminga::hypertableau

#endif
