// The UDP sockets of a subscriber: its own, and one for each multicast group. It decides whose a datagram is.
#ifndef GEMINGA_CLIENT_CHANNELS_UDP_INLET_HPP
#define GEMINGA_CLIENT_CHANNELS_UDP_INLET_HPP

#include <cstdint>
#include <expected>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>

#include "client/channels/channel_host.hpp"
#include "client/channels/socket.hpp"
#include "client/protocol/counterparts.hpp"
#include "client/protocol/early_frames.hpp"
#include "client/protocol/frame.hpp"

namespace geminga::client {

/// Believes a datagram by its address and life (src/client/CHANNELS.md, What is believed), keeps early frames, and says
/// hello to streams. Neither copies nor moves. The functions of `Told` may forget any provider.
class UdpInlet {
 public:
  using Number = Counterparts::Number;
  struct Told {
    /// A frame from the address of a provider, and with its life where it is not from a group.
    std::function<void(Number, const Frame&)> frame;
    /// A datagram of a provider without a life.
    std::function<void(Number, std::span<const std::byte>)> plain;
    /// A datagram that was not believed.
    std::function<void()> dropped;
    /// One that was told as dropped is delivered now.
    std::function<void()> found;
    std::function<void(const std::string& text)> problem;
  };

  UdpInlet(ChannelHost& host, Life own, Told told);
  /// Tells the providers of streams that nobody listens any more.
  ~UdpInlet();
  UdpInlet(const UdpInlet&) = delete;
  UdpInlet& operator=(const UdpInlet&) = delete;

  /// Opens the own socket. The result is its port; the error is one line about an address or port that cannot be had.
  [[nodiscard]] std::expected<std::uint16_t, std::string> open(const std::string& address, std::uint16_t port);

  /// Believes datagrams from this address. Says hello there once a second where `says_hello`.
  void hear(Number provider, Life life, const PeerAddress& address, bool says_hello);
  /// Believes datagrams to this group, from any address with the group's port.
  void join(Number provider, Life life, const PeerAddress& group);
  /// Takes either back. A publisher that was said hello to is told the end.
  void forget(Number provider);
  /// Tells the frames that came from the provider before hear().
  void deliver_early(Number provider);
  /// Reads all that the provider's socket holds now.
  void read_all(Number provider);

 private:
  struct Source {
    Life life = no_life;
    PeerAddress address;
    bool says_hello = false;
    Socket group{};
    Reactor::Watch group_watch{};
  };

  void read(const Socket& socket, std::optional<Number> group, int most);
  void take(std::span<const std::byte> bytes, const PeerAddress& from, std::optional<Number> group);
  void say_hello_to_all();
  void say(const Source& source, FrameKind kind) const;
  void join_all();
  [[nodiscard]] base::Instant now() const { return host_.reactor().now(); }

  ChannelHost& host_;
  Life own_;
  Told told_;
  Socket socket_;
  Reactor::Watch watch_;
  std::map<Number, Source> sources_;
  std::map<PeerAddress, Number> by_address_;  ///< of those that are heard at the own socket
  EarlyFrames early_;
  Reactor::Timer hello_;
  Reactor::Timer interfaces_;
};

}  // namespace geminga::client

#endif
