// A GCNP client of the simulated world, and the checker that watches every event it is sent.
#ifndef GEMINGA_TESTS_SIM_CLIENT_HPP
#define GEMINGA_TESTS_SIM_CLIENT_HPP

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "discovery/gcnp/statement.hpp"
#include "env/env.hpp"

namespace geminga::sim {

class Host;
class World;

/// Made by World::add_client(), which owns it. Its view holds what it was told and not told off again, so that every
/// event is checked: per request and service they are add (modify)* del, and nothing else (no event lost, none
/// doubled).
class Client {
 public:
  /// The view of one request: the words of services (or subscriptions), with the last event about each.
  using View = std::map<std::string, gcnp::Statement, std::less<>>;

  Client(World& world, std::string name) : world_(world), name_(std::move(name)) {}

  [[nodiscard]] const std::string& name() const { return name_; }
  /// The user who runs it, as the host's system tells; empty: it does not.
  std::string user;

  void connect(Host& host);
  /// Sends one statement.
  void say(std::string_view line);
  void send_bytes(std::string bytes);
  /// Octets that wait for it at the host.
  [[nodiscard]] std::size_t unread() const;
  /// Whether it reads what it is told; it does from the start.
  void set_reading(bool is_reading);
  /// Reads so many octets, though it does not read otherwise.
  void read(std::size_t octets);
  /// Closes the connection from this side.
  void hang_up();
  [[nodiscard]] bool is_connected() const { return host_ != nullptr; }
  [[nodiscard]] Host* host() const { return host_; }

  /// Called for each line that comes in, without its end, after it has been checked.
  std::function<void(std::string_view line, const gcnp::Statement& statement)> on_line;
  /// Called when the connection ended from the other side.
  std::function<void()> on_lost;
  /// The lines that came in and have not been taken; kept only while `keeps_lines`.
  std::vector<std::string> lines;
  bool keeps_lines = true;

  /// The view of the request with this id on the present connection.
  [[nodiscard]] const View& view(std::uint32_t request) const;
  /// From the last answer to hello; empty before it.
  [[nodiscard]] const std::string& participant() const { return participant_; }
  [[nodiscard]] const std::string& peer() const { return peer_; }

  // The host's side.
  void connected(Host& host, env::StreamId stream);
  void connection_lost();
  void closed_by_host(env::StreamId stream);
  void receive(env::StreamId stream, std::string_view bytes);

 private:
  void check(std::string_view line, const gcnp::Statement& statement);

  World& world_;
  std::string name_;
  Host* host_ = nullptr;
  env::StreamId stream_{};
  std::string unfinished_;
  std::string participant_;
  std::string peer_;
  std::map<std::uint32_t, View> views_;
};

}  // namespace geminga::sim

#endif
