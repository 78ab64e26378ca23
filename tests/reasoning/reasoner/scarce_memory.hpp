// A world in which memory runs out in a thread of the reasoner's own.
#ifndef GEMINGA_TESTS_REASONING_REASONER_SCARCE_MEMORY_HPP
#define GEMINGA_TESTS_REASONING_REASONER_SCARCE_MEMORY_HPP

#include <cstdint>

namespace geminga::reasoner {

/// As long as it lives, the allocation with this number, from 1, that another thread than the test's asks for fails,
/// and all that come after it there. The test program's operator new asks it.
class ScarceMemory {
 public:
  explicit ScarceMemory(std::uint64_t first_failure);
  ScarceMemory(const ScarceMemory&) = delete;
  ScarceMemory& operator=(const ScarceMemory&) = delete;
  ~ScarceMemory();
  /// Whether that many allocations were asked for.
  [[nodiscard]] bool has_failed() const;
};

}  // namespace geminga::reasoner

#endif
