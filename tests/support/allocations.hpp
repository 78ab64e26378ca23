// Counts the allocations of a program that is linked with allocations.cpp.
#ifndef GEMINGA_TESTS_SUPPORT_ALLOCATIONS_HPP
#define GEMINGA_TESTS_SUPPORT_ALLOCATIONS_HPP

#include <cstdint>

namespace geminga::tests {

/// The number of calls of `new` in this thread since it began.
[[nodiscard]] std::uint64_t allocations();

}  // namespace geminga::tests

#endif
