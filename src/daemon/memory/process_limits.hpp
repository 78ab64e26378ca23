// Limits of this process: the memory and the descriptors that the system lets it use.
#ifndef GEMINGA_DAEMON_MEMORY_PROCESS_LIMITS_HPP
#define GEMINGA_DAEMON_MEMORY_PROCESS_LIMITS_HPP

#include <cstdint>
#include <optional>
#include <string>

namespace geminga::daemon {

/// The memory that this process may have by its control group (memory.max of cgroup v2), at its start; nothing where it
/// is not bounded. There the kernel ends a process instead of telling it that memory is short.
[[nodiscard]] std::optional<std::uint64_t> memory_of_group();
/// The memory of this process that no file backs; 0 where the system does not tell.
[[nodiscard]] std::uint64_t memory_in_use();

/// Raises the soft limit of open files to the hard one. The error is a line for the user, where fewer than
/// least_descriptors may be open.
inline constexpr std::uint64_t least_descriptors = 32;
[[nodiscard]] std::optional<std::string> check_descriptors();

}  // namespace geminga::daemon

#endif
