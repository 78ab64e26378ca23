#include "daemon/memory/memory_watch.hpp"

#include <malloc.h>

#include <chrono>

namespace geminga::daemon {
namespace {

/// The time between two looks at the memory in use, and between two attempts to keep some back again.
constexpr std::chrono::seconds memory_look_interval{1};

}  // namespace

bool MemoryWatch::is_short(base::Instant now) {
  bool is_short = MemoryReserve::take_shortage();
  is_reserve_used_ = is_reserve_used_ || is_short;
  if (now < next_look_) return is_short;
  next_look_ = now + memory_look_interval;
  // Seven eighths: the kernel ends a process at its limit without a word.
  if (most_ && memory_in_use() > *most_ / 8 * 7) is_short = true;
  if (is_reserve_used_ || is_short) {
    ::malloc_trim(0);
    is_reserve_used_ = !reserve_.refill();
  }
  return is_short;
}

}  // namespace geminga::daemon
