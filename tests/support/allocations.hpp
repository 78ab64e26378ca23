// Counts what a program that is linked with allocations.cpp asks the allocator for.
#ifndef GEMINGA_TESTS_SUPPORT_ALLOCATIONS_HPP
#define GEMINGA_TESTS_SUPPORT_ALLOCATIONS_HPP

#include <cstdint>

namespace geminga::tests {

/// How often `new` was used in this thread since it began.
[[nodiscard]] std::uint64_t allocations();

}  // namespace geminga::tests

#endif
