// The output of a program of the system, bounded in time and size.
#ifndef GEMINGA_DOCTOR_COMMAND_OUTPUT_HPP
#define GEMINGA_DOCTOR_COMMAND_OUTPUT_HPP

#include <cstddef>
#include <optional>
#include <string>

namespace geminga::doctor {

/// The most octets that are read. A list of rules that is longer is not judged.
inline constexpr std::size_t max_output_bytes = std::size_t{4} << 20U;

/// Runs a command line by the shell, with /usr/sbin and /sbin in its path, for five seconds at most. Nothing where the
/// program is not there, may not be run, fails, or says more than max_output_bytes. `command` is never made of what
/// comes from outside.
[[nodiscard]] std::optional<std::string> output_of(const std::string& command);

}  // namespace geminga::doctor

#endif
