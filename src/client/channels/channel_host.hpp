// What a publisher or subscriber needs of the engine that it belongs to.
#ifndef GEMINGA_CLIENT_CHANNELS_CHANNEL_HOST_HPP
#define GEMINGA_CLIENT_CHANNELS_CHANNEL_HOST_HPP

#include <cstddef>
#include <cstdint>
#include <span>

#include "client/channels/reactor.hpp"
#include "geminga/channel.hpp"

namespace geminga::client {

/// Outlives its channels.
class ChannelHost {
 public:
  virtual ~ChannelHost() = default;
  [[nodiscard]] virtual Reactor& reactor() = 0;
  /// Tells the program.
  virtual void tell(ChannelEvent event) = 0;
  /// The subscriber has a message and had none.
  virtual void on_message(ChannelNumber channel) = 0;
  /// The publisher is reached at another port than it stated.
  virtual void state_port(ChannelNumber channel, std::uint16_t port) = 0;
  /// Room for one datagram of any size, whose content nobody keeps between calls.
  [[nodiscard]] virtual std::span<std::byte> datagram_room() = 0;
};

}  // namespace geminga::client

#endif
