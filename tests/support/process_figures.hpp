// The resources of a running process, as /proc tells them.
#ifndef GEMINGA_TESTS_SUPPORT_PROCESS_FIGURES_HPP
#define GEMINGA_TESTS_SUPPORT_PROCESS_FIGURES_HPP

#include <sys/types.h>

#include <cstddef>

namespace geminga::system {

/// Processor time of the main thread in milliseconds, as the scheduler counts it in nanoseconds.
[[nodiscard]] double processor_ms(pid_t pid);
/// Resident memory in megabytes, shared memory included.
[[nodiscard]] double resident_mb(pid_t pid);
/// Resident memory in megabytes without a file behind it: the memory that the process has allocated.
[[nodiscard]] double anonymous_mb(pid_t pid);
/// Open descriptors.
[[nodiscard]] std::size_t descriptors(pid_t pid);

}  // namespace geminga::system

#endif
