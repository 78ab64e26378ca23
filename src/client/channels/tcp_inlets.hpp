// The connections of a subscriber to its providers over TCP, and the places that they share.
#ifndef GEMINGA_CLIENT_CHANNELS_TCP_INLETS_HPP
#define GEMINGA_CLIENT_CHANNELS_TCP_INLETS_HPP

#include <functional>
#include <map>
#include <memory>
#include <string>

#include "client/channels/channel_host.hpp"
#include "client/channels/tcp_inlet.hpp"
#include "client/protocol/counterparts.hpp"
#include "client/protocol/provider_places.hpp"
#include "client/protocol/sealed_frame.hpp"

namespace geminga::client {

/// A provider that has a place is connected to; the others wait for one (src/client/CHANNELS.md, Places). Neither
/// copies nor moves. The functions of `Told` may close any provider.
class TcpInlets {
 public:
  using Number = Counterparts::Number;
  struct Told {
    /// A message or an end of a provider. `is_proved`: it was opened with a key, and made after the connection was.
    std::function<void(Number, const Frame&, bool is_proved)> frame;
    /// The connection to a provider, or its place, is gone. The result says whether it is to be made again.
    std::function<bool(Number)> lost;
    /// Octets came that are no frame, or one that is not believed.
    std::function<void()> dropped;
    std::function<void(const std::string& text)> problem;
  };

  /// Requires that host and sealer outlive it.
  TcpInlets(ChannelHost& host, Sealer& sealer, Told told);
  TcpInlets(const TcpInlets&) = delete;
  TcpInlets& operator=(const TcpInlets&) = delete;

  /// Connects to a provider that is not open, as soon as there is a place.
  void open(Number provider, Life life, const PeerAddress& address, const ChannelKeys& keys);
  /// Takes other keys for a provider that is open.
  void set_keys(Number provider, const ChannelKeys& keys);
  /// The provider has delivered a message, so it is among the last of its address that lose their places.
  void serve(Number provider) { places_.serve(provider); }
  /// Ends the connection and gives the place to a provider that waits. Does nothing for a provider that is not open.
  void close(Number provider);
  [[nodiscard]] bool is_connected(Number provider) const;
  /// Stops reading from all connections, or goes on.
  void pause(bool is_paused);
  [[nodiscard]] bool is_paused() const { return is_paused_; }

 private:
  struct Provider {
    Life life = no_life;
    PeerAddress address;
    ChannelKeys keys;
    std::unique_ptr<TcpInlet> inlet{};  ///< null while it waits for a place
  };

  void connect(Number provider);
  /// False where no more frames may come for now.
  bool take(Number provider, const Frame& frame, bool is_proved);
  /// Gives the places of providers that are not connected to those that wait.
  void rotate();
  void set_timer();
  [[nodiscard]] base::Instant now() const { return host_.reactor().now(); }

  ChannelHost& host_;
  Sealer& sealer_;
  Told told_;
  ProviderPlaces places_;
  Crowding crowding_;
  bool is_paused_ = false;
  std::map<Number, Provider> providers_;
  Reactor::Timer timer_;
};

}  // namespace geminga::client

#endif
