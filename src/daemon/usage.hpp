// The memory and processor time of this process, as the kernel counts them.
#ifndef GEMINGA_DAEMON_USAGE_HPP
#define GEMINGA_DAEMON_USAGE_HPP

#include <cstdint>

namespace geminga::daemon {

struct Usage {
  std::uint64_t resident_bytes = 0;
  std::uint64_t peak_resident_bytes = 0;
  double processor_seconds = 0;
};

/// Reads /proc and getrusage(2); zero where they cannot be read.
[[nodiscard]] Usage read_usage();

}  // namespace geminga::daemon

#endif
