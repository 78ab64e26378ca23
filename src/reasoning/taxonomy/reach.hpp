// Where the subclasses of a class stand among the ranks of all classes.
#ifndef GEMINGA_REASONING_TAXONOMY_REACH_HPP
#define GEMINGA_REASONING_TAXONOMY_REACH_HPP

#include <cstdint>

namespace geminga::taxonomy {

/// What "is A under B" needs of a class, in one place: two of these and, for one in seven of the pairs that one asks
/// about in large ontologies, a list of intervals are a question's misses of the cache.
struct Reach {
  static constexpr std::uint32_t flag = std::uint32_t{1} << 31;
  std::uint32_t first = 0;   ///< its rank; flag alone where it can have no instance
  std::uint32_t extent = 0;  ///< how many ranks behind its own are below it; with flag: and there are further intervals
  std::uint32_t further_begin = 0;
  std::uint32_t further_end = 0;
};

}  // namespace geminga::taxonomy

#endif
