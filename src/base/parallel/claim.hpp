// An entry of a shared table that one thread makes while others wait for it.
#ifndef GEMINGA_BASE_PARALLEL_CLAIM_HPP
#define GEMINGA_BASE_PARALLEL_CLAIM_HPP

#include <atomic>
#include <cstdint>

namespace geminga::parallel {

/// Releases the claimed entry at the end of the scope, so that no thread waits for one that failed to make it.
class Claim {
 public:
  Claim(std::atomic<std::uint32_t>& entry, std::uint32_t unclaimed) : entry_(entry), value_(unclaimed) {}
  Claim(const Claim&) = delete;
  Claim& operator=(const Claim&) = delete;
  ~Claim() { entry_.store(value_, std::memory_order_release); }

  /// Sets the value that the entry holds from the end of the scope on.
  void settle(std::uint32_t value) { value_ = value; }

 private:
  std::atomic<std::uint32_t>& entry_;
  std::uint32_t value_;
};

}  // namespace geminga::parallel

#endif
