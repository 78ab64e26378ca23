// So many in each second, and no more.
#ifndef GEMINGA_BRIDGE_WORDS_ALLOWANCE_HPP
#define GEMINGA_BRIDGE_WORDS_ALLOWANCE_HPP

#include <chrono>
#include <cstdint>

#include "base/time.hpp"

namespace geminga::bridge {

/// Pure. A second begins with the first that is taken after the end of the former one.
class Allowance {
 public:
  explicit Allowance(std::uint32_t per_second) : per_second_(per_second) {}

  /// Takes one; false: none is left in this second.
  bool take(base::Instant now) {
    if (now >= end_) {
      end_ = now + std::chrono::seconds(1);
      left_ = per_second_;
    }
    if (left_ == 0) return false;
    --left_;
    return true;
  }

 private:
  std::uint32_t per_second_;
  std::uint32_t left_ = 0;
  base::Instant end_{};
};

}  // namespace geminga::bridge

#endif
