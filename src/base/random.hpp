// A seeded generator with its own ranges, because the standard's distributions differ between libraries.
#ifndef GEMINGA_BASE_RANDOM_HPP
#define GEMINGA_BASE_RANDOM_HPP

#include <array>
#include <cstdint>

#include "base/time.hpp"

namespace geminga::base {

/// xoshiro256** (Blackman and Vigna, 2018), seeded through splitmix64. The same seed gives the same sequence on every
/// platform. Not for secrets. Not thread-safe.
class Random {
 public:
  explicit Random(std::uint64_t seed);

  /// 64 random bits.
  std::uint64_t next();
  /// Uniform in [0, bound), without bias (by rejection, as OpenBSD arc4random_uniform). Requires bound > 0.
  std::uint64_t below(std::uint64_t bound);
  /// Uniform in [0, 1) with 53 bits.
  double unit();
  /// True with the given probability.
  bool chance(double probability) { return unit() < probability; }
  /// Uniform in [low, high]. Requires low <= high.
  Duration between(Duration low, Duration high);

 private:
  std::array<std::uint64_t, 4> state_;
};

}  // namespace geminga::base

#endif
