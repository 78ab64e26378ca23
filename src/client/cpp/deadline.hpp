// The instant until which a call waits.
#ifndef GEMINGA_CLIENT_CPP_DEADLINE_HPP
#define GEMINGA_CLIENT_CPP_DEADLINE_HPP

#include <chrono>

namespace geminga::client {

/// Now and a timeout, which may be as long as "for ever".
[[nodiscard]] inline std::chrono::steady_clock::time_point deadline_after(std::chrono::milliseconds timeout) {
  using Clock = std::chrono::steady_clock;
  const auto now = Clock::now();
  // In milliseconds, since "for ever" has no place among nanoseconds.
  const auto longest = std::chrono::duration_cast<std::chrono::milliseconds>(Clock::time_point::max() - now);
  return timeout < longest ? now + timeout : Clock::time_point::max();
}

}  // namespace geminga::client

#endif
