// The wait before the next attempt to connect.
#ifndef GEMINGA_CLIENT_PROTOCOL_BACKOFF_HPP
#define GEMINGA_CLIENT_PROTOCOL_BACKOFF_HPP

#include <algorithm>
#include <chrono>
#include <cstdint>

namespace geminga::client {

/// .1, .2, .4, .8, 1, 1, ... s, each up to a quarter longer by chance (src/client/CHANNELS.md, How a channel ends).
class Backoff {
 public:
  static constexpr std::chrono::milliseconds first{100};
  static constexpr std::chrono::milliseconds longest{1000};

  /// The next wait. `chance` is 64 random bits.
  [[nodiscard]] std::chrono::microseconds next(std::uint64_t chance) {
    const std::chrono::microseconds base = next_;
    next_ = std::min(next_ * 2, longest);
    const auto quarter = static_cast<std::uint64_t>(base.count()) / 4;
    return base + std::chrono::microseconds(chance % (quarter + 1));
  }
  /// An attempt has succeeded: begins with the shortest wait again.
  void reset() { next_ = first; }

 private:
  std::chrono::milliseconds next_ = first;
};

}  // namespace geminga::client

#endif
