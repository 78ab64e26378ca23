// Measurements that are made once for a whole team: memory, allocations, and the best of many.
#ifndef GEMINGA_TESTS_BENCH_MATCHING_WHOLE_HPP
#define GEMINGA_TESTS_BENCH_MATCHING_WHOLE_HPP

#include <cstdint>

namespace geminga::matching {

/// Prints the rows of a team of this size.
void measure_whole(std::uint32_t size);

}  // namespace geminga::matching

#endif
