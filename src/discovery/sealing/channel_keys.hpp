// The keys of a channel, which client libraries seal messages with (src/discovery/sealing/SEALING.md, "Keys of
// channels").
#ifndef GEMINGA_DISCOVERY_SEALING_CHANNEL_KEYS_HPP
#define GEMINGA_DISCOVERY_SEALING_CHANNEL_KEYS_HPP

#include <cstdint>

#include "discovery/sealing/key.hpp"

namespace geminga::sealing {

/// Two keys of one channel under one key of the team. A value that wipes itself when it ends.
struct ChannelKeys {
  ChannelKeys() = default;
  ChannelKeys(const ChannelKeys&) = default;
  ChannelKeys& operator=(const ChannelKeys&) = default;
  ~ChannelKeys();

  KeyId id{};
  Key::Secret forward{};  ///< seals what the publisher sends
  Key::Secret back{};     ///< seals what its consumers send
};

/// Derives the keys of the channel of the publication with this life by keyed BLAKE2b. About 2 us.
[[nodiscard]] ChannelKeys channel_keys(const Key& key, std::uint64_t life);

}  // namespace geminga::sealing

#endif
