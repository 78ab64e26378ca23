// The time of an event in the form of RFC 3339.
#ifndef GEMINGA_SHELL_TIMESTAMP_HPP
#define GEMINGA_SHELL_TIMESTAMP_HPP

#include <chrono>
#include <string>

namespace geminga::shell {

/// `2026-11-22T04:36:13.123Z`: UTC with milliseconds, cut and not rounded. Requires a year from 0 to 9999.
[[nodiscard]] std::string timestamp(std::chrono::system_clock::time_point instant);
/// The present time by the clock of this host.
[[nodiscard]] std::string timestamp();

}  // namespace geminga::shell

#endif
