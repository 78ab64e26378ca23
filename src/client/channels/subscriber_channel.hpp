// The consumer's half of a channel: who its providers are, and which messages of theirs are delivered.
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
#include "client/channels/early_frames.hpp"
#include "client/channels/frame.hpp"
#include "client/channels/inbox.hpp"
#include "client/channels/parties.hpp"
#include "client/channels/provider_connection.hpp"
#include "client/channels/sequence.hpp"
#include "geminga/channel.hpp"
#include "geminga/named.hpp"

namespace geminga::client {

/// Neither copies nor moves. Not thread-safe. What it tells goes to the host.
class SubscriberChannel {
 public:
  /// Opens its UDP socket where a protocol admits one, and fills port, protocols and life into `subscription`. The
  /// error is one line about a stated port or address that cannot be had.
  [[nodiscard]] static std::expected<std::unique_ptr<SubscriberChannel>, std::string> open(
      ChannelHost& host, ChannelNumber number, NamedSubscription& subscription, Conversions conversions);
  /// Tells the providers of streams that nobody listens any more.
  ~SubscriberChannel();
  SubscriberChannel(const SubscriberChannel&) = delete;
  SubscriberChannel& operator=(const SubscriberChannel&) = delete;

  /// The next message, if one is there.
  [[nodiscard]] std::optional<Message> take();
  [[nodiscard]] bool has_message() const { return !inbox_.is_empty(); }
  [[nodiscard]] const ReceiveCount& count() const { return count_; }
  [[nodiscard]] Life life() const { return life_; }
  /// The providers that there may be; 0: all.
  void set_limit(std::uint32_t limit) { limit_ = limit; }

  /// What the daemon tells of providers.
  void on_event(const ServiceEvent& event);
  void on_daemon_gone() { parties_.doubt(); }
  /// The daemon is back and has had its time to tell of everybody again.
  void on_settled();
  /// The daemon has taken the request back.
  void on_refused();

 private:
  /// How messages of a provider come.
  enum class Way : std::uint8_t { none, datagrams, hello, group, connection };
  struct Provider {
    ServiceEvent event;
    Way way = Way::none;
    PeerAddress address;
    bool was_told_of_conversion = false;
    std::unique_ptr<ProviderConnection> connection{};
    Socket group{};
    Reactor::Watch group_watch{};
  };

  SubscriberChannel(ChannelHost& host, ChannelNumber number, Life life, std::uint32_t limit, Conversions conversions);

  void watch_socket();
  /// Opens what the provider's event asks for, closes what it does not any more.
  void wire(Parties::Number number, const ServiceEvent& event);
  void connect(Parties::Number number);
  void join(Parties::Number number);
  /// Joins every group on the interfaces that there are.
  void join_all();
  void problem(const std::string& text) { host_.tell(Problem{number_, text}); }

  void read(const Socket& socket, std::optional<Parties::Number> group);
  void take_datagram(std::span<const std::byte> bytes, const PeerAddress& from, std::optional<Parties::Number> group);
  /// Keeps a frame of whom the daemon may tell soon.
  void take_early(const Frame& frame, const PeerAddress& from);
  /// Delivers what came from the provider before the daemon told of it.
  void deliver_early(Parties::Number number);
  /// False where nothing more may be read for now.
  bool take_frame(Parties::Number number, const Frame& frame);
  bool deliver(Parties::Number number, std::uint64_t sequence, std::span<const std::byte> payload);
  bool on_lost(Parties::Number number);
  void pause(bool is_paused);

  void say_hello();
  void say(const Provider& provider, FrameKind kind);
  [[nodiscard]] Parties::Carrier carrier_of(Parties::Number number) const;
  void remove(Parties::Number number, std::string_view reason);
  void remove_superfluous();
  void set_timer() { timer_.set(parties_.next_end()); }
  void tell(ProviderChange::What what, Parties::Number number, std::string_view reason);
  [[nodiscard]] base::Instant now() const { return host_.reactor().now(); }

  ChannelHost& host_;
  ChannelNumber number_;
  Life life_;
  std::uint32_t limit_;
  Conversions conversions_;
  ReceiveCount count_;
  Inbox inbox_;
  Sequences sequences_;
  EarlyFrames early_;
  bool is_paused_ = false;
  Parties parties_;
  std::map<Parties::Number, Provider> providers_;
  std::map<PeerAddress, Parties::Number> by_address_;  ///< of those whose datagrams come from there
  Socket socket_;
  Reactor::Watch watch_;
  Reactor::Timer timer_;
  Reactor::Timer hello_;
  Reactor::Timer interfaces_;
};

}  // namespace geminga::client

#endif
