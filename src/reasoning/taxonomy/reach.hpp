// The ranks of the subclasses of a class among the ranks of all classes.
#ifndef GEMINGA_REASONING_TAXONOMY_REACH_HPP
#define GEMINGA_REASONING_TAXONOMY_REACH_HPP

#include <cstdint>

namespace geminga::taxonomy {

/// The figures of a class for "is A under B", side by side in memory. A question reads two of these. For one in seven
/// pairs of large ontologies it also reads a list of intervals.
struct Reach {
  static constexpr std::uint32_t flag = std::uint32_t{1} << 31;
  std::uint32_t first = 0;  ///< the rank; the flag alone if the class is unsatisfiable
  std::uint32_t extent =
      0;  ///< how many following ranks are below the class; the flag says that there are further intervals
  std::uint32_t further_begin = 0;
  std::uint32_t further_end = 0;
};

}  // namespace geminga::taxonomy

#endif
