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
#include <vector>

#include "client/channels/channel_host.hpp"
#include "client/channels/socket.hpp"
#include "client/protocol/counterparts.hpp"
#include "client/protocol/early_frames.hpp"
#include "client/protocol/handshake.hpp"
#include "client/protocol/intake.hpp"

namespace geminga::client {

/// Believes a datagram by its address, its life and its seal (src/client/CHANNELS.md, What is believed), keeps early
/// frames, and says hello. Neither copies nor moves. The functions of `Told` may forget any provider.
class UdpInlet {
 public:
  using Number = Counterparts::Number;
  struct Told {
    /// A message or an end from the address and life of a provider. `is_proved`: it was opened with a key, and made
    /// after this channel was.
    std::function<void(Number, const Frame&, bool is_proved)> frame;
    /// A datagram of a provider without a life.
    std::function<void(Number, std::span<const std::byte>)> plain;
    /// A datagram that was not believed.
    std::function<void()> dropped;
    /// One that was told as dropped is delivered now.
    std::function<void()> found;
    std::function<void(const std::string& text)> problem;
  };

  UdpInlet(ChannelHost& host, Sealer& sealer, Told told);
  /// Tells the providers of streams that nobody listens any more.
  ~UdpInlet();
  UdpInlet(const UdpInlet&) = delete;
  UdpInlet& operator=(const UdpInlet&) = delete;

  /// Opens the own socket. The result is its port; the error is one line about an address or port that cannot be had.
  [[nodiscard]] std::expected<std::uint16_t, std::string> open(const std::string& address, std::uint16_t port);

  /// Believes datagrams from this address. Says hello there if it is a stream or there are keys.
  void hear(Number provider, Life life, const PeerAddress& address, const ChannelKeys& keys, bool is_stream);
  /// Believes datagrams to this group, from any address with the group's port.
  void join(Number provider, Life life, const PeerAddress& group, const ChannelKeys& keys);
  /// Takes other keys for a provider that is heard.
  void set_keys(Number provider, const ChannelKeys& keys);
  /// Takes either back. A publisher of a stream is told the end.
  void forget(Number provider);
  /// Tells the frames that came from the provider before hear().
  void deliver_early(Number provider);
  /// Reads all that the provider's socket holds now.
  void read_all(Number provider);

 private:
  struct Source {
    Life life = no_life;
    PeerAddress address;  ///< of the provider, or of the group
    Intake intake;
    bool is_stream = false;
    std::optional<Handshake> handshake{};
    base::Instant due = base::never;       ///< the instant of the next hello
    std::optional<PeerAddress> greeted{};  ///< where hellos are taken
    Socket group{};
    Reactor::Watch group_watch{};
  };

  void read(const Socket& socket, std::optional<Number> group, int most);
  void take(std::span<const std::byte> bytes, const PeerAddress& from, std::optional<Number> group);
  /// The provider whose socket has this address; of a group, where `group` says so.
  [[nodiscard]] std::optional<Number> source_of(const PeerAddress& from, std::optional<Number> group) const;
  /// The source whose answer to a hello this sealed frame claims to be, from whatever address of its host it came: the
  /// challenge in it proves it.
  [[nodiscard]] std::optional<Number> answerer_of(const ReadFrame& frame) const;
  /// Takes a frame of a provider with its life. Whether it is believed.
  bool take_frame(Number number, const ReadFrame& frame, const PeerAddress& from);
  /// Keeps a frame that was opened until there is a floor, for which it asks.
  bool await_floor(Number number, const ReadFrame& frame, const PeerAddress& from);
  void on_floor(Number number, const Frame& frame, bool is_proved);
  /// Begins or ends saying hello as the keys ask for it.
  void begin_handshake(Source& source);
  void greet(Number number, const PeerAddress& at);
  void say_due_hellos();
  void say_hello(Source& source);
  void say(const Source& source, FrameKind kind);
  void set_timer();
  void join_all();
  [[nodiscard]] base::Instant now() const { return host_.reactor().now(); }

  ChannelHost& host_;
  Sealer& sealer_;
  Told told_;
  Socket socket_;
  Reactor::Watch watch_;
  std::map<Number, Source> sources_;
  std::map<PeerAddress, Number> by_address_;  ///< of those that are heard or answer at the own socket
  EarlyFrames early_;
  std::vector<std::byte> opened_;  ///< room for the payload of a sealed frame
  Reactor::Timer hello_;
  Reactor::Timer interfaces_;
};

}  // namespace geminga::client

#endif
