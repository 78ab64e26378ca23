// A subscriber's half of a channel: its providers, and the messages of theirs that are delivered.
#ifndef GEMINGA_CLIENT_CHANNELS_SUBSCRIBER_CHANNEL_HPP
#define GEMINGA_CLIENT_CHANNELS_SUBSCRIBER_CHANNEL_HPP

#include <cstdint>
#include <deque>
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
#include "client/protocol/inbox.hpp"
#include "client/protocol/provider_places.hpp"
#include "client/protocol/sealed_frame.hpp"
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
  struct Provider {
    ServiceEvent event;
    Way way = Way::none;
    PeerAddress address;
    bool was_told_of_conversion = false;
    bool is_served = false;      ///< has delivered a message over TCP
    std::string last_problem{};  ///< that the program was told
    /// The last sequence that an end said which anybody could have forged, and how long it counts.
    std::uint64_t last_at_end = 0;
    base::Instant end_until{};
    std::unique_ptr<TcpInlet> connection{};
  };
  using Number = Counterparts::Number;

  SubscriberChannel(ChannelHost& host, ChannelNumber number, Life life, std::uint32_t limit, Conversions conversions);

  /// A provider over TCP that has ended and may still be matched.
  struct Ended {
    ServiceEvent event;
    base::Instant until;
  };

  [[nodiscard]] UdpInlet::Told told_by_udp();
  void on_add(const ServiceEvent& event);
  void on_del(const ServiceEvent& event);
  /// The way of an offer; none, and the program is told, if there is none.
  [[nodiscard]] Way way_of(Number number, const ServiceEvent& event, const std::optional<PeerAddress>& address);
  /// The keys for a provider; nothing: the daemon has not told them yet.
  [[nodiscard]] std::optional<ChannelKeys> keys_of(Life publisher) const;
  void use_keys(Life publisher);
  /// Keeps the keys of a life without a provider, as long as there are not too many.
  void keep_keys(Life publisher);
  /// Opens what the event of a provider asks for, and closes what it does not ask for.
  void wire(Number number, const ServiceEvent& event);
  void connect(Number number);
  void claim_place(Number number);
  void leave_place(Number number);
  /// Gives the places of providers that are not connected to those that wait.
  void rotate_places();
  void set_place_timer();
  /// Connects again to providers that have ended and are still matched.
  void return_to_ended();
  /// Tells a problem of a provider, once until there is another one.
  void problem_of(Number number, const std::string& text);
  void problem(const std::string& text) { host_.tell(Problem{number_, text}); }

  /// False where no more frames may come from a connection for now.
  bool take_frame(Number number, const Frame& frame, bool is_proved);
  void take_end(Number number, const Frame& frame, bool is_proved);
  /// Counts the messages that are missing before an end.
  void count_missed_at_end(Number number, std::uint64_t last, bool is_proved);
  void deliver(Number number, const Frame& frame, bool is_proved);
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
  Sealer sealer_;
  std::uint32_t limit_;
  Conversions conversions_;
  ReceiveCount count_;
  Inbox inbox_;
  Sequence sequence_;
  bool has_plain_daemon_ = false;     ///< the daemon has no keys
  std::map<Life, ChannelKeys> keys_;  ///< that the daemon has told
  std::deque<Life> waiting_keys_;     ///< of lives without a provider, in the order in which they came
  ProviderPlaces places_;
  Crowding crowding_;
  std::map<ServiceKey, Ended> ended_;
  bool is_paused_ = false;
  Counterparts counterparts_;
  std::map<Number, Provider> providers_;
  UdpInlet udp_;
  Reactor::Timer timer_;
  Reactor::Timer place_timer_;
  Reactor::Timer again_timer_;
};

}  // namespace geminga::client

#endif
