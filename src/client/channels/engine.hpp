// The engine of a node: its daemon, its publishers and its subscribers, behind one descriptor and without a thread.
#ifndef GEMINGA_CLIENT_CHANNELS_ENGINE_HPP
#define GEMINGA_CLIENT_CHANNELS_ENGINE_HPP

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "client/channels/channel_host.hpp"
#include "client/channels/daemon_link.hpp"
#include "client/channels/log.hpp"
#include "client/channels/news.hpp"
#include "client/channels/publisher_channel.hpp"
#include "client/channels/subscriber_channel.hpp"
#include "client/protocol/session.hpp"
#include "geminga/result.hpp"

namespace geminga::client {

/// Reads sockets and calls functions of the program within process() only; no call waits. Neither copies nor moves. Not
/// thread-safe.
class Engine final : public ChannelHost {
 public:
  /// Begins to look for the daemon.
  explicit Engine(DaemonLink::Options options, Log::Write log = {}, Reactor::Clock clock = Reactor::system_time);
  ~Engine() override;

  [[nodiscard]] int descriptor() const { return reactor_.descriptor(); }
  /// Reads and writes what is ready. Whether a message or an event has come.
  bool process();

  /// Opens a channel and states it as soon as there is a daemon. Error: wrong_use, for a request that cannot be stated
  /// or a port that is taken.
  [[nodiscard]] Result<ChannelNumber, ClientError> publish(NamedPublication publication);
  [[nodiscard]] Result<ChannelNumber, ClientError> subscribe(NamedSubscription subscription, Conversions conversions);
  /// Changes a request. Error: wrong_use, also for mode, protocol, port and address, which its sockets depend on.
  [[nodiscard]] Result<void, ClientError> modify(ChannelNumber number, const Session::Change& change);
  /// Begins to end a channel cleanly; it has ended when find() gives nothing.
  void withdraw(ChannelNumber number);
  /// Begins to end everything cleanly, until has_ended().
  void withdraw_all();
  [[nodiscard]] bool has_ended();

  /// The state of a request; null if it is withdrawn altogether.
  [[nodiscard]] const Session::Request* find(ChannelNumber number) const { return session_.find(number); }
  [[nodiscard]] PublisherChannel* publisher(ChannelNumber number) const;
  [[nodiscard]] SubscriberChannel* subscriber(ChannelNumber number) const;

  [[nodiscard]] bool is_connected() const { return link_.is_up(); }
  /// Whether an attempt to reach the daemon has failed and it is not there.
  [[nodiscard]] bool is_without_daemon() const { return !link_.is_up() && link_.has_failed(); }

  /// Events and messages for the program, whose functions for them are called at the end of process().
  [[nodiscard]] News& news() { return news_; }

  /// Gives further lines of the log to this function; to standard error if it is empty.
  void on_log(Log::Write write) { log_.set(std::move(write)); }

  [[nodiscard]] Reactor& reactor() override { return reactor_; }
  void tell(ChannelEvent event) override { news_.tell(std::move(event)); }
  void on_message(ChannelNumber channel) override { news_.on_message(channel); }
  void state_port(ChannelNumber channel, std::uint16_t port) override;
  void state_attribute(ChannelNumber channel, const std::string& key, const std::string& value) override;
  [[nodiscard]] std::optional<SealingMode> sealing_mode() const override { return mode_; }
  [[nodiscard]] bool is_settling() const override { return settle_.at() != base::never; }
  [[nodiscard]] bool is_own_process() const override { return reactor_.is_own_process(); }
  [[nodiscard]] std::span<std::byte> datagram_room() override { return room_; }

 private:
  DaemonLink::Told told();
  void on_up(const gcnp::Statement& hello);
  void on_down(const std::string& reason);
  void on_reply(gcnp::Reply reply);
  void on_statement(const gcnp::Statement& statement);
  /// Takes the keys of one life for a request.
  void on_keys(const gcnp::Statement& statement);
  /// Takes the mode of this host; plain: the daemon has no keys.
  void on_mode(SealingMode mode);
  void on_settled(const Session::Settled& settled);
  [[nodiscard]] bool is_finishing(ChannelNumber number) const {
    return std::ranges::find(finishing_, number) != finishing_.end();
  }
  void end_finished();
  /// Ends the channel of a request that is refused.
  void close_refused(ChannelNumber number);

  Reactor reactor_;
  Log log_;
  News news_;
  std::vector<std::byte> room_;
  std::optional<SealingMode> mode_;  ///< nothing: no daemon has told it yet
  DaemonLink link_;
  Session session_;
  std::map<ChannelNumber, std::unique_ptr<PublisherChannel>> publishers_;
  std::map<ChannelNumber, std::unique_ptr<SubscriberChannel>> subscribers_;
  std::vector<ChannelNumber> finishing_;  ///< publishers
  Reactor::Timer settle_;                 ///< a daemon that is back has had its time to confirm
  std::string last_refusal_;              ///< of a daemon; the program is told once
  bool is_ending_ = false;
};

/// The daemon's answer to the hello, in the words of the public face.
[[nodiscard]] Welcome welcome_of(const gcnp::Statement& hello);

}  // namespace geminga::client

#endif
