// Where the subclasses of a class stand in the ranks of all classes.
#ifndef GEMINGA_REASONING_TAXONOMY_REACH_HPP
#define GEMINGA_REASONING_TAXONOMY_REACH_HPP

#include <cstdint>

namespace geminga::taxonomy {

/// What "is A under B" needs to know of a class, side by side in memory. A question reads two of these. For one in
/// seven of the pairs that are asked about in large ontologies it also reads a list of intervals.
struct Reach {
  static constexpr std::uint32_t flag = std::uint32_t{1} << 31;
  std::uint32_t first = 0;   ///< its rank; flag alone where it can have no instance
  std::uint32_t extent = 0;  ///< how many ranks behind its own are below it; with flag: and there are further intervals
  std::uint32_t further_begin = 0;
  std::uint32_t further_end = 0;
};

}  // namespace geminga::taxonomy

#endif
