// All of a node without a thread: its daemon, its publishers and its subscribers, behind one descriptor.
#ifndef GEMINGA_CLIENT_CHANNELS_ENGINE_HPP
#define GEMINGA_CLIENT_CHANNELS_ENGINE_HPP

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "client/channels/channel_host.hpp"
#include "client/channels/daemon_link.hpp"
#include "client/channels/publisher_channel.hpp"
#include "client/channels/subscriber_channel.hpp"
#include "client/protocol/session.hpp"
#include "geminga/result.hpp"

namespace geminga::client {

/// Neither copies nor moves. Not thread-safe. Nothing is read and nobody is told but within process(); no call waits.
class Engine final : public ChannelHost {
 public:
  using OnEvent = std::function<void(const ChannelEvent&)>;
  using OnMessage = std::function<void(Message)>;

  /// Begins to look for the daemon.
  explicit Engine(DaemonLink::Options options);
  ~Engine() override;

  [[nodiscard]] int descriptor() const { return reactor_.descriptor(); }
  /// Whether a message or an event has come.
  bool process();

  /// Opens the channel and states it as soon as there is a daemon. Errors: wrong_use, for what cannot be stated or a
  /// port that is taken.
  [[nodiscard]] Result<ChannelNumber, ClientError> publish(NamedPublication publication);
  [[nodiscard]] Result<ChannelNumber, ClientError> subscribe(NamedSubscription subscription, Conversions conversions);
  /// Errors: wrong_use, also for what the sockets hang on: mode, protocol, port and address.
  [[nodiscard]] Result<void, ClientError> modify(ChannelNumber number, const Session::Change& change);
  /// Begins to end a channel cleanly; it is over when find() gives nothing.
  void withdraw(ChannelNumber number);
  /// Begins to end everything cleanly; it is over when has_ended().
  void withdraw_all();
  [[nodiscard]] bool has_ended();

  /// What became of a request; null where it is withdrawn altogether.
  [[nodiscard]] const Session::Request* find(ChannelNumber number) const { return session_.find(number); }
  [[nodiscard]] PublisherChannel* publisher(ChannelNumber number) const;
  [[nodiscard]] SubscriberChannel* subscriber(ChannelNumber number) const;

  [[nodiscard]] bool is_connected() const { return link_.is_up(); }
  /// Whether the daemon is not there, as far as is known.
  [[nodiscard]] bool is_without_daemon() const { return !link_.is_up() && link_.has_failed(); }

  /// The next event that nobody has taken. Where events were thrown away, the first one is a Problem of channel 0 with
  /// their number.
  [[nodiscard]] std::optional<ChannelEvent> next_event();
  /// From now on events go there, and messages of a subscriber there, at the end of process().
  void on_events(OnEvent on_event) { on_event_ = std::move(on_event); }
  void on_messages(ChannelNumber number, OnMessage on_message);

  /// Whether messages or events have come that nobody has looked at since.
  [[nodiscard]] bool has_news() const { return !news_.empty(); }
  /// The program has looked whether this subscriber has a message; or 0: whether there is an event.
  void has_looked(ChannelNumber number) { news_.erase(number); }
  /// The program is about to look at everything.
  void will_look() { news_.clear(); }
  /// Makes the descriptor readable until the next process(), where there are news.
  void remind() {
    if (has_news()) reminder_.set(reactor_.now());
  }

  [[nodiscard]] Reactor& reactor() override { return reactor_; }
  void tell(ChannelEvent event) override;
  void on_message(ChannelNumber channel) override {
    ready_.push_back(channel);
    news_.insert(channel);
  }
  void state_port(ChannelNumber channel, std::uint16_t port) override;
  [[nodiscard]] std::span<std::byte> datagram_room() override { return room_; }

 private:
  DaemonLink::Told told();
  void on_up(const gcnp::Statement& hello);
  void on_down(const std::string& reason);
  void on_reply(gcnp::Reply reply);
  void on_settled(const Session::Settled& settled);
  [[nodiscard]] bool is_finishing(ChannelNumber number) const {
    return std::ranges::find(finishing_, number) != finishing_.end();
  }
  void end_finished();
  /// Ends what a request carried that is refused.
  void close_refused(ChannelNumber number);
  bool hand_out();

  Reactor reactor_;
  std::vector<std::byte> room_;
  DaemonLink link_;
  Session session_;
  std::map<ChannelNumber, std::unique_ptr<PublisherChannel>> publishers_;
  std::map<ChannelNumber, std::unique_ptr<SubscriberChannel>> subscribers_;
  std::vector<ChannelNumber> finishing_;  ///< publishers
  Reactor::Timer settle_;                 ///< a daemon that is back has told of everybody
  std::string last_refusal_;              ///< of a daemon, told once
  std::deque<ChannelEvent> events_;
  std::uint64_t lost_events_ = 0;  ///< thrown away since the program was last told of such
  OnEvent on_event_;
  std::map<ChannelNumber, OnMessage> on_message_;
  bool has_event_come_ = false;
  std::vector<ChannelNumber> ready_;  ///< subscribers that have got a message
  std::set<ChannelNumber> news_;      ///< those that the program has not looked at since, and 0 for events
  Reactor::Timer reminder_;
  bool is_ending_ = false;
};

/// What the daemon says about itself and this client.
[[nodiscard]] Welcome welcome_of(const gcnp::Statement& hello);

}  // namespace geminga::client

#endif
