// The datagrams that were sent of late, so that one in our name that is not ours is known for a forgery.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_AIR_SENT_DATAGRAMS_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_AIR_SENT_DATAGRAMS_HPP

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace geminga::participant {

/// Datagrams that are remembered: enough from sending one until its echo comes, for fourteen copies of a state of 1000
/// services on two interfaces. A forgotten one costs a needless contradiction.
inline constexpr std::size_t max_remembered_datagrams = 4096;

/// Remembers a keyed hash of 64 bits of each. The key is random, so that nobody can make another datagram with the same
/// hash.
class SentDatagrams {
 public:
  explicit SentDatagrams(std::uint64_t key) : key_(key) {}

  void add(std::span<const std::byte> datagram);
  /// Cost: linear in what is remembered.
  [[nodiscard]] bool contains(std::span<const std::byte> datagram) const;

 private:
  [[nodiscard]] std::uint64_t hash(std::span<const std::byte> datagram) const;

  std::uint64_t key_;
  std::vector<std::uint64_t> hashes_;  ///< a ring once it is full
  std::size_t next_ = 0;               ///< where the next one goes
};

}  // namespace geminga::participant

#endif
