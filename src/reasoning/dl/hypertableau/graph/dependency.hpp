// Which choices a fact depends on: sets of branch numbers, each stored once.
#ifndef GEMINGA_REASONING_DL_HYPERTABLEAU_GRAPH_DEPENDENCY_HPP
#define GEMINGA_REASONING_DL_HYPERTABLEAU_GRAPH_DEPENDENCY_HPP

#include <array>
#include <cstdint>
#include <vector>

#include "base/interner.hpp"

namespace geminga::hypertableau {

/// A set of branch numbers by its number. Equal sets have equal numbers.
using DependencySet = std::uint32_t;
inline constexpr DependencySet no_dependency = 0;

/// Sets as lists in descending order whose tails are shared. A union costs the length of the parts above the shared
/// tail, a repeated one a look at a cache.
class DependencySets {
 public:
  DependencySets() { clear(); }
  void clear();

  [[nodiscard]] DependencySet single(std::uint32_t branch) { return cons(branch, no_dependency); }
  [[nodiscard]] DependencySet unite(DependencySet first, DependencySet second);
  /// The greatest branch of a set that is not empty.
  [[nodiscard]] std::uint32_t last(DependencySet set) const { return cells_[set].branch; }
  /// The set without its greatest branch.
  [[nodiscard]] DependencySet without_last(DependencySet set) const { return cells_[set].rest; }

 private:
  struct Cell {
    std::uint32_t branch;
    DependencySet rest;
  };
  struct Known {
    DependencySet first = 0;
    DependencySet second = 0;
    DependencySet both = 0;
  };
  static constexpr std::size_t known_count = 4096;

  [[nodiscard]] static std::uint64_t hash_of(const Cell& cell) {
    std::uint64_t word = ((std::uint64_t{cell.branch} << 32) | cell.rest) * 0x9e3779b97f4a7c15U;
    word = (word ^ (word >> 32)) * 0xff51afd7ed558ccdU;
    return word ^ (word >> 32);
  }
  DependencySet cons(std::uint32_t branch, DependencySet rest);

  std::vector<Cell> cells_;
  base::NumberTable table_;
  std::array<Known, known_count> known_{};
  std::vector<std::uint32_t> open_;
};

}  // namespace geminga::hypertableau

#endif
