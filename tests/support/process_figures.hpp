// What a running process takes of the machine, as /proc tells it.
#ifndef GEMINGA_TESTS_SUPPORT_PROCESS_FIGURES_HPP
#define GEMINGA_TESTS_SUPPORT_PROCESS_FIGURES_HPP

#include <sys/types.h>

#include <cstddef>

namespace geminga::system {

/// Processor time of the main thread in milliseconds, as the scheduler counts it in nanoseconds.
[[nodiscard]] double processor_ms(pid_t pid);
/// Resident memory in megabytes, what is shared with others included.
[[nodiscard]] double resident_mb(pid_t pid);
/// Resident memory in megabytes that no file is behind: what the process has allocated.
[[nodiscard]] double anonymous_mb(pid_t pid);
/// Open descriptors.
[[nodiscard]] std::size_t descriptors(pid_t pid);

}  // namespace geminga::system

#endif
