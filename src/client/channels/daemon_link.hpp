// The link to the local daemon, which connects again whenever the connection is lost.
#ifndef GEMINGA_CLIENT_CHANNELS_DAEMON_LINK_HPP
#define GEMINGA_CLIENT_CHANNELS_DAEMON_LINK_HPP

#include <chrono>
#include <expected>
#include <functional>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "client/channels/daemon_connection.hpp"
#include "client/channels/endpoint.hpp"
#include "client/channels/reactor.hpp"
#include "client/protocol/backoff.hpp"
#include "discovery/gcnp/event.hpp"
#include "discovery/gcnp/statement.hpp"

namespace geminga::client {

/// Says hello by itself. Neither copies nor moves. Not thread-safe.
class DaemonLink {
 public:
  struct Told {
    std::function<void(const gcnp::Statement& hello)> up;  ///< the daemon answered the hello
    std::function<void(const std::string& reason)> down;   ///< the daemon is gone
    std::function<void(gcnp::Reply)> reply;                ///< any other reply
    std::function<void(const std::string& text)> refused;  ///< the program that listens there does not accept us
    /// The daemon was not reached where these endpoints are, or it is gone from there.
    std::function<void(const std::string& where, const std::string& reason)> missing;
  };
  struct Options {
    std::vector<Endpoint> endpoints;
    std::string name;
    std::chrono::milliseconds timeout{};  ///< for connecting, and for the answer to the hello
    std::uint32_t room = 0;               ///< as in ClientOptions
    bool asks_for_keys = true;            ///< of its channels
  };

  DaemonLink(Reactor& reactor, Options options, Told told);

  /// Begins to connect.
  void start();
  [[nodiscard]] bool is_up() const { return state_ == State::up; }
  /// Whether an attempt has failed since it was up, or since the start.
  [[nodiscard]] bool has_failed() const { return has_failed_; }
  /// The endpoint of the attempt under way, or of the daemon.
  [[nodiscard]] std::string where() const { return to_string(options_.endpoints[endpoint_]); }
  /// Says a line, if the daemon is there.
  void say(const gcnp::Statement& statement);
  /// Says goodbye. `down` is called when the daemon has read everything, or has taken too long for that.
  void leave();
  /// Closes the connection to a daemon that cannot serve us now, and connects again later.
  void drop(const std::string& reason) {
    if (is_up()) fail(reason);
  }
  /// Closes the connection, without a goodbye.
  void stop();

 private:
  enum class State : std::uint8_t { stopped, waiting, connecting, greeting, up };

  void connect();
  void on_ready(Reactor::Ready ready);
  void greet();
  void read();
  void take(std::expected<gcnp::Reply, Error> reply);
  void write();
  /// Closes our half if everything is written.
  void end_if_leaving();
  [[nodiscard]] std::string all_endpoints() const;
  /// The attempt has failed, or the daemon is gone: tries again later.
  void fail(const std::string& reason);

  Reactor& reactor_;
  Options options_;
  Told told_;
  State state_ = State::stopped;
  bool is_leaving_ = false;
  std::size_t endpoint_ = 0;  ///< of the attempt under way
  bool has_failed_ = false;
  std::optional<DaemonConnection> connection_;  ///< from connecting on
  Reactor::Watch watch_;
  Reactor::Timer timer_;
  Backoff backoff_;
  std::minstd_rand chance_;
};

}  // namespace geminga::client

#endif
