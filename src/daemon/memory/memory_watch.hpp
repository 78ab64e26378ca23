// The watch over the daemon's memory: after each event it sees whether memory was short, or is about to end.
#ifndef GEMINGA_DAEMON_MEMORY_MEMORY_WATCH_HPP
#define GEMINGA_DAEMON_MEMORY_MEMORY_WATCH_HPP

#include <cstdint>
#include <optional>

#include "base/time.hpp"
#include "daemon/memory/memory_reserve.hpp"
#include "daemon/memory/process_limits.hpp"

namespace geminga::daemon {

/// Owns the reserve, and makes it whole again after it was used. One object a process, as the reserve is.
class MemoryWatch {
 public:
  MemoryWatch() = default;
  MemoryWatch(const MemoryWatch&) = delete;
  MemoryWatch& operator=(const MemoryWatch&) = delete;

  /// Whether room must be made now: memory was short since the last call, or the control group has little left. Call
  /// after each event; it asks the system once a second at most.
  [[nodiscard]] bool is_short(base::Instant now);

 private:
  MemoryReserve reserve_;
  const std::optional<std::uint64_t> most_ = memory_of_group();
  base::Instant next_look_{};
  bool is_reserve_used_ = false;  ///< and is not whole yet
};

}  // namespace geminga::daemon

#endif
