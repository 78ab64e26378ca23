// The real world on one Boost.Asio event loop: the Env of gemingad.
#ifndef GEMINGA_ENV_ASIO_ASIO_ENV_HPP
#define GEMINGA_ENV_ASIO_ASIO_ENV_HPP

#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>
#include <cstdint>
#include <expected>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "env/asio/endpoint.hpp"
#include "env/asio/event_sink.hpp"
#include "env/asio/link_watch.hpp"
#include "env/asio/links.hpp"
#include "env/asio/multicast.hpp"
#include "env/asio/reception.hpp"
#include "env/asio/routes.hpp"
#include "env/asio/streams.hpp"
#include "env/asio/unicast.hpp"
#include "env/env.hpp"

namespace geminga::env {

/// The interfaces, groups and hosts that the daemon speaks with.
struct AirSettings {
  std::vector<std::string> interfaces;  ///< empty: every one that can multicast, without the loopback
  std::vector<std::string> groups;      ///< numeric multicast addresses
  std::uint16_t port = 0;
  std::vector<HostPort> peers;  ///< hosts that get copies by unicast
  /// Each of them is a link of its own (Interface::is_named_peer), since a relay says other things to it.
  bool are_peers_links = false;
  Admission admission = Admission::nobody;
  /// Announced in place of the interfaces' own.
  std::vector<AnnouncedAddress> announced{};
  friend bool operator==(const AirSettings&, const AirSettings&) = default;
};

/// One event loop, one thread. Everything that happens reaches the EventSink as one event, within which now() is
/// constant and after which queued output goes out. No function throws, except for lack of memory.
class AsioEnv final : public Env {
 public:
  /// Borrows its arguments for its life. Opens no socket yet.
  AsioEnv(boost::asio::io_context& context, base::LogSink& log);
  ~AsioEnv() override;
  AsioEnv(const AsioEnv&) = delete;
  AsioEnv& operator=(const AsioEnv&) = delete;

  /// Listens for GCNP clients, which wait until serve(). An address that `may_be_missing` and does not exist on this
  /// host is left out with a line in the log. The error is one line that says what to do.
  [[nodiscard]] std::expected<void, std::string> listen(const Endpoint& endpoint, bool may_be_missing);
  /// Listens at a path, with a Unix socket (env/asio/socket_file.hpp).
  [[nodiscard]] std::expected<void, std::string> listen(const std::string& path) { return streams_->listen(path); }
  /// Listens on a socket that a supervisor has made, and gives its place (Doors::adopt()). Call it before listen(),
  /// which then leaves that place alone.
  [[nodiscard]] std::expected<std::string, std::string> adopt(int descriptor) { return streams_->adopt(descriptor); }
  /// Opens the interfaces; interfaces() is filled when this returns. A further call changes to other settings, and
  /// tells the sink of the change.
  void open_air(AirSettings settings);
  /// Tells `sink` from now on what happens. It is borrowed for the life of this object.
  void serve(EventSink& sink);
  /// Takes no more clients; for the end.
  void stop_listening() { streams_->stop_listening(); }
  /// Calls `action` as one event: for what the owner itself does with the participant.
  void event(const std::function<void()>& action);
  /// The datagrams that were not handed over.
  [[nodiscard]] const AirCounts& air_counts() const { return air_counts_; }
  /// The hosts that are sent copies.
  [[nodiscard]] UnicastCounts unicast_counts() const;
  /// Whether bytes for a client are still on their way.
  [[nodiscard]] bool is_writing() const { return streams_->is_writing(); }

  [[nodiscard]] base::Instant now() const override { return now_; }
  void wake_at(base::Instant instant) override;
  [[nodiscard]] std::uint64_t random_bits() override;
  [[nodiscard]] const std::vector<Interface>& interfaces() const override { return interfaces_; }
  [[nodiscard]] std::vector<std::string> ignored_interfaces() const override { return ignored_; }
  [[nodiscard]] std::optional<base::Instant> last_heard(InterfaceIndex interface) const override;
  [[nodiscard]] RouteKind route(std::string_view address) override { return routes_.find(address); }
  void send(InterfaceIndex interface, std::span<const std::byte> datagram) override;
  void send_alone(InterfaceIndex interface, std::string_view address, std::span<const std::byte> datagram) override;
  [[nodiscard]] bool is_sender_named() const override;
  [[nodiscard]] bool is_sender_unnamed() const override;
  void answer_sender(base::Duration time) override;
  void write(StreamId stream, std::string_view bytes) override { streams_->write(stream, bytes); }
  [[nodiscard]] std::size_t unsent(StreamId stream) const override { return streams_->unsent(stream); }
  void want(StreamId stream, bool is_wanted) override { streams_->want(stream, is_wanted); }
  void close(StreamId stream) override { streams_->close(stream); }
  [[nodiscard]] base::LogSink& log() override { return log_; }

 private:
  void begin_event();
  /// Calls the action as one event for the sink; does nothing before serve().
  template <typename Action>
  void tell(const Action& action) {
    if (sink_ == nullptr) return;
    begin_event();
    action(*sink_);
    streams_->flush();
  }
  void arm();
  void receive(InterfaceIndex interface, const boost::asio::ip::address& source, std::span<const std::byte> datagram);
  /// Compares the interfaces with those in use, and joins those that are new or came back. Returns whether all that
  /// were asked for are there and can be used.
  bool scan();
  /// Opens an interface. Returns whether it can be used.
  bool open(const Link& link, const std::vector<boost::asio::ip::address>& groups);
  /// Logs an interface that was asked for by name and is not there, once until it comes.
  void say_missing(const std::vector<Interface>& seen);
  /// Logs once what cannot be opened on an interface, and once that all can.
  void say_problems(const MulticastLink& link);
  /// Logs the interfaces for which there is no room, when they change.
  void say_ignored(std::vector<std::string> ignored);
  /// Logs once that sending fails, and once that it works again.
  void watch_sending(const MulticastLink& link);

  boost::asio::io_context& context_;
  base::LogSink& log_;
  boost::asio::steady_timer timer_;
  std::shared_ptr<Streams> streams_;
  base::Instant now_;
  std::vector<Interface> interfaces_;
  AirCounts air_counts_;
  AirSettings settings_;
  std::vector<boost::asio::ip::address> groups_;
  EventSink* sink_ = nullptr;
  std::map<InterfaceIndex, std::unique_ptr<MulticastLink>> links_;
  std::map<InterfaceIndex, int> send_errors_;
  std::map<InterfaceIndex, std::vector<std::string>> problems_;
  std::string scan_problem_;  ///< why the last look at the interfaces failed; empty: it did not
  std::vector<std::string> ignored_;
  std::set<std::string> missing_;
  std::unique_ptr<Unicast> unicast_;
  std::unique_ptr<LinkWatch> watch_;
  Routes routes_;
  base::Instant wanted_ = base::never;  ///< the participant wants its timer
  base::Instant armed_ = base::never;   ///< the timer is set
};

}  // namespace geminga::env

#endif
