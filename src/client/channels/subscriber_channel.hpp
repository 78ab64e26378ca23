// A subscriber's half of a channel: its providers, and the messages of theirs that are delivered.
#ifndef GEMINGA_CLIENT_CHANNELS_SUBSCRIBER_CHANNEL_HPP
#define GEMINGA_CLIENT_CHANNELS_SUBSCRIBER_CHANNEL_HPP

#include <cstdint>
#include <expected>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "client/channels/channel_host.hpp"
#include "client/channels/tcp_inlet.hpp"
#include "client/channels/udp_inlet.hpp"
#include "client/protocol/counterparts.hpp"
#include "client/protocol/frame.hpp"
#include "client/protocol/inbox.hpp"
#include "client/protocol/sequence.hpp"
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
  [[nodiscard]] const ReceiveCount& count() const { return count_; }
  [[nodiscard]] Life life() const { return life_; }
  /// The largest number of providers; 0: all.
  void set_limit(std::uint32_t limit) { limit_ = limit; }

  /// Takes an event of the daemon about a provider.
  void on_event(const ServiceEvent& event);
  void on_daemon_gone() { counterparts_.doubt(); }
  /// The daemon is back and has had its time to confirm every provider.
  void on_settled();
  /// The daemon has taken the request back.
  void on_refused();

 private:
  /// The way in which messages of a provider come.
  enum class Way : std::uint8_t { none, datagrams, hello, group, connection };
  struct Provider {
    ServiceEvent event;
    Way way = Way::none;
    PeerAddress address;
    bool was_told_of_conversion = false;
    std::unique_ptr<TcpInlet> connection{};
  };
  using Number = Counterparts::Number;

  SubscriberChannel(ChannelHost& host, ChannelNumber number, Life life, std::uint32_t limit, Conversions conversions);

  [[nodiscard]] UdpInlet::Told told_by_udp();
  /// Opens what the event of a provider asks for, and closes what it does not ask for.
  void wire(Number number, const ServiceEvent& event);
  void connect(Number number);
  void problem(const std::string& text) { host_.tell(Problem{number_, text}); }

  /// False where no more frames may come from a connection for now.
  bool take_frame(Number number, const Frame& frame);
  void deliver(Number number, std::uint64_t sequence, std::span<const std::byte> payload);
  /// The connection to a provider is gone; whether it is to be made again.
  bool on_lost(Number number);
  /// Stops reading from connections, or goes on.
  void pause(bool is_paused);

  [[nodiscard]] Counterparts::Carrier carrier_of(Number number) const;
  void remove(Number number, std::string_view reason);
  void remove_superfluous();
  void set_timer() { timer_.set(counterparts_.next_end()); }
  void tell(ProviderChange::What what, Number number, std::string_view reason);
  [[nodiscard]] base::Instant now() const { return host_.reactor().now(); }

  ChannelHost& host_;
  ChannelNumber number_;
  Life life_;
  std::uint32_t limit_;
  Conversions conversions_;
  ReceiveCount count_;
  Inbox inbox_;
  Sequence sequence_;
  bool is_paused_ = false;
  Counterparts counterparts_;
  std::map<Number, Provider> providers_;
  UdpInlet udp_;
  Reactor::Timer timer_;
};

}  // namespace geminga::client

#endif
