// The octets that a recording may take in any hour.
#ifndef GEMINGA_RECORDING_ALLOWANCE_HPP
#define GEMINGA_RECORDING_ALLOWANCE_HPP

#include <algorithm>
#include <cstdint>

#include "recording/entry.hpp"

namespace geminga::recording {

/// A bucket that holds half of the hour's octets and is filled with the other half in each hour. So no hour takes more
/// than the limit, wherever it begins, and a burst of half of it is written at once.
class Allowance {
 public:
  explicit Allowance(std::uint64_t octets_an_hour) : most_(octets_an_hour / 2), left_(most_) {}

  /// The most octets that can ever be taken at once.
  [[nodiscard]] std::uint64_t most() const { return most_; }
  /// Takes so many octets, all or none. Times never run backwards.
  bool take(std::uint64_t octets, At now) {
    fill(now);
    if (octets > left_) return false;
    left_ -= octets;
    return true;
  }
  [[nodiscard]] bool has(std::uint64_t octets, At now) {
    fill(now);
    return octets <= left_;
  }

 private:
  void fill(At now) {
    const auto hour = static_cast<std::uint64_t>(std::chrono::milliseconds(std::chrono::hours(1)).count());
    const auto passed = std::min(static_cast<std::uint64_t>((now - filled_).count()), hour);
    const std::uint64_t earned = most_ * passed / hour;
    if (earned == 0) return;  // waits until there is a whole octet, so that none is lost in rounding
    left_ = std::min(most_, left_ + earned);
    filled_ = now;
  }

  std::uint64_t most_;
  std::uint64_t left_;
  At filled_{};
};

}  // namespace geminga::recording

#endif
