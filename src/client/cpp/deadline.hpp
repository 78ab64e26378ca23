// The instant until which a call waits, and the wait for a descriptor.
#ifndef GEMINGA_CLIENT_CPP_DEADLINE_HPP
#define GEMINGA_CLIENT_CPP_DEADLINE_HPP

#include <poll.h>

#include <algorithm>
#include <chrono>
#include <limits>

namespace geminga::client {

using Clock = std::chrono::steady_clock;

/// Now and a timeout, which may be as long as "for ever".
[[nodiscard]] inline Clock::time_point deadline_after(std::chrono::milliseconds timeout) {
  const auto now = Clock::now();
  // In milliseconds, since "for ever" has no place among nanoseconds.
  const auto longest = std::chrono::duration_cast<std::chrono::milliseconds>(Clock::time_point::max() - now);
  return timeout < longest ? now + timeout : Clock::time_point::max();
}

/// Waits until poll(2) reports one of `events`, or an error, of the descriptor. False where the deadline comes first.
[[nodiscard]] inline bool wait_until_ready(int descriptor, short events, Clock::time_point deadline) {
  for (auto now = Clock::now(); now < deadline; now = Clock::now()) {
    constexpr long long longest = std::numeric_limits<int>::max();
    const long long left = std::chrono::ceil<std::chrono::milliseconds>(deadline - now).count();
    pollfd waiting{descriptor, events, 0};
    if (::poll(&waiting, 1, static_cast<int>(std::min(left, longest))) > 0) return true;
  }
  return false;
}

}  // namespace geminga::client

#endif
