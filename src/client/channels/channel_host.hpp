// The part of the engine that its publishers and subscribers use.
#ifndef GEMINGA_CLIENT_CHANNELS_CHANNEL_HOST_HPP
#define GEMINGA_CLIENT_CHANNELS_CHANNEL_HOST_HPP

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "client/channels/reactor.hpp"
#include "client/protocol/channel_keys.hpp"
#include "geminga/channel.hpp"

namespace geminga::client {

/// Outlives its channels.
class ChannelHost {
 public:
  virtual ~ChannelHost() = default;
  [[nodiscard]] virtual Reactor& reactor() = 0;
  /// Gives an event to the program.
  virtual void tell(ChannelEvent event) = 0;
  /// The inbox of a subscriber was empty and has a message.
  virtual void on_message(ChannelNumber channel) = 0;
  /// States the port of a publisher that had to change it.
  virtual void state_port(ChannelNumber channel, std::uint16_t port) = 0;
  /// States an attribute of a publisher that is the library's own.
  virtual void state_attribute(ChannelNumber channel, const std::string& key, const std::string& value) = 0;
  /// The mode of this host, as far as the daemon has told it.
  [[nodiscard]] virtual std::optional<SealingMode> sealing_mode() const = 0;
  /// Whether the daemon is back for so short a time that it may not have heard of everything yet.
  [[nodiscard]] virtual bool is_settling() const = 0;
  /// Whether this is the process that opened the node, which alone may seal and send.
  [[nodiscard]] virtual bool is_own_process() const = 0;
  /// Room for one datagram of any size. Its content is void after the call.
  [[nodiscard]] virtual std::span<std::byte> datagram_room() = 0;
};

}  // namespace geminga::client

#endif
