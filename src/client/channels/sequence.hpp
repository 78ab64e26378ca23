// Which messages of one life are new, and how many were missed between them.
#ifndef GEMINGA_CLIENT_CHANNELS_SEQUENCE_HPP
#define GEMINGA_CLIENT_CHANNELS_SEQUENCE_HPP

#include <cstdint>
#include <optional>

namespace geminga::client {

/// What is not newer than the newest is old, so that no message comes twice and none out of order. What came before the
/// first one was not missed.
class Sequence {
 public:
  /// How many messages are missing before this one; nothing where it is old. A message has at least the number 1.
  std::optional<std::uint64_t> take(std::uint64_t number) {
    if (number <= last_) return std::nullopt;
    const std::uint64_t missed = last_ == 0 ? 0 : number - last_ - 1;
    last_ = number;
    return missed;
  }

 private:
  std::uint64_t last_ = 0;
};

}  // namespace geminga::client

#endif
