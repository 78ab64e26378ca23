// A subscriber's half of a channel: its providers, and the messages of theirs that are delivered.
#ifndef GEMINGA_CLIENT_CHANNELS_SUBSCRIBER_CHANNEL_HPP
#define GEMINGA_CLIENT_CHANNELS_SUBSCRIBER_CHANNEL_HPP

#include <cstdint>
#include <expected>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "client/channels/channel_host.hpp"
#include "client/channels/ended_matches.hpp"
#include "client/channels/tcp_inlets.hpp"
#include "client/channels/udp_inlet.hpp"
#include "client/protocol/counterparts.hpp"
#include "client/protocol/delivery.hpp"
#include "client/protocol/provider_keys.hpp"
#include "client/protocol/sealed_frame.hpp"
#include "geminga/channel.hpp"
#include "geminga/named.hpp"

namespace geminga::client {

/// Events go to the host. Neither copies nor moves. Not thread-safe.
class SubscriberChannel {
 public:
  /// Opens the UDP socket if `udp` is among the protocols, and fills port, protocols and life into `subscription`. The
  /// error is one line about a port or address that cannot be had.
  [[nodiscard]] static std::expected<std::unique_ptr<SubscriberChannel>, std::string> open(
      ChannelHost& host, ChannelNumber number, NamedSubscription& subscription, Conversions conversions);
  SubscriberChannel(const SubscriberChannel&) = delete;
  SubscriberChannel& operator=(const SubscriberChannel&) = delete;

  /// The next message that is here.
  [[nodiscard]] std::optional<Message> take();
  [[nodiscard]] const ReceiveCount& count() const { return delivery_.count(); }
  [[nodiscard]] Life life() const { return sealer_.life(); }
  /// The largest number of providers; 0: all.
  void set_limit(std::uint32_t limit) { limit_ = limit; }

  /// Takes the keys of a publisher's life, also before the event that tells of it.
  void set_keys(Life publisher, const ChannelKeys& keys);
  /// The daemon has no keys, so that all channels are plain; or it will tell those of each life.
  void on_daemon_keys(bool has_keys);
  /// The host's mode has become known or is another one.
  void on_mode();
  /// Takes an event of the daemon about a provider.
  void on_event(const ServiceEvent& event);
  void on_daemon_gone();
  /// The daemon is back and has had its time to confirm every provider.
  void on_settled();
  /// The daemon has taken the request back.
  void on_refused();

 private:
  /// The way in which messages of a provider come.
  enum class Way : std::uint8_t { none, datagrams, hello, group, connection };
  /// An end over UDP that anybody could have forged: it counts if the daemon says the same in time.
  struct SaidEnd {
    std::uint64_t last = 0;
    base::Instant until{};
  };
  struct Provider {
    ServiceEvent event;
    Way way = Way::none;
    PeerAddress address{};
    SaidEnd said_end{};
    bool was_told_of_conversion = false;
    std::string last_problem{};  ///< that the program was told
  };
  using Number = Counterparts::Number;

  SubscriberChannel(ChannelHost& host, ChannelNumber number, Life life, std::uint32_t limit, Conversions conversions);
  [[nodiscard]] UdpInlet::Told told_by_udp();
  [[nodiscard]] TcpInlets::Told told_by_tcp();

  void on_add(const ServiceEvent& event);
  void on_del(const ServiceEvent& event);
  /// Removes the providers whose time is over.
  void expire();
  void remove_superfluous();
  void remove(Number number, std::string_view reason);

  /// The way of an offer; none, and the program is told, if there is none.
  [[nodiscard]] Way way_of(Number number, const ServiceEvent& event, const std::optional<PeerAddress>& address);
  /// Opens what the event of a provider asks for, and closes what it does not ask for.
  void wire(Number number);
  void use_keys(Life publisher);
  /// The connection to a provider is gone; whether it is to be made again.
  bool on_lost(Number number);
  [[nodiscard]] Counterparts::Carrier carrier_of(Number number) const;

  void take_frame(Number number, const Frame& frame, bool is_proved);
  void take_end(Number number, const Frame& frame, Delivery::Carrier carrier);
  void deliver(Number number, const Frame& frame, Delivery::Carrier carrier);

  void tell(ProviderChange::What what, Number number, std::string_view reason);
  /// Tells a problem of a provider, once until there is another one.
  void problem_of(Number number, const std::string& text);
  void problem(const std::string& text) { host_.tell(Problem{number_, text}); }
  void set_timer() { timer_.set(counterparts_.next_end()); }
  [[nodiscard]] base::Instant now() const { return host_.reactor().now(); }

  ChannelHost& host_;
  ChannelNumber number_;
  Sealer sealer_;
  std::uint32_t limit_;
  Counterparts counterparts_;
  std::map<Number, Provider> providers_;
  ProviderKeys keys_;
  Delivery delivery_;
  EndedMatches ended_;
  UdpInlet udp_;
  TcpInlets tcp_;
  Reactor::Timer timer_;
};

}  // namespace geminga::client

#endif
