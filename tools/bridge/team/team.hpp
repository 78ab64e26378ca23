// The team as a bridge sees it: a client of the local daemon that comes back by itself.
#ifndef GEMINGA_BRIDGE_TEAM_TEAM_HPP
#define GEMINGA_BRIDGE_TEAM_TEAM_HPP

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bridge/team/foreign_services.hpp"
#include "bridge/team/tally.hpp"
#include "client/channels/daemon_link.hpp"
#include "client/channels/endpoint.hpp"
#include "client/channels/log.hpp"
#include "client/channels/reactor.hpp"
#include "client/protocol/session.hpp"
#include "geminga/client.hpp"

namespace geminga::bridge {

/// States the services of others, and asks the daemon questions. Everything ends with its connection, and is stated
/// again when the daemon is back. No call waits. Neither copies nor moves. Not thread-safe.
class Team {
 public:
  using Tell = std::function<void(const std::string& line)>;
  using Parameters = std::vector<std::pair<std::string, std::string>>;
  /// Takes the answer; nothing: there is none, because the daemon is away, late or refuses.
  using Then = std::function<void(std::optional<Answer> answer)>;

  /// `name` is the peer's. The reactor must outlive it.
  Team(client::Reactor& reactor, std::vector<client::Endpoint> endpoints, std::string name,
       std::chrono::milliseconds timeout, Tell tell);

  /// Begins to connect.
  void start() { link_.start(); }
  /// Withdraws everything; is_up() is false when the daemon has read that.
  void leave() { link_.leave(); }
  [[nodiscard]] bool is_up() const { return link_.is_up(); }

  /// The services and requests of others.
  [[nodiscard]] ForeignServices& foreign() { return foreign_; }
  [[nodiscard]] Tally& tally() { return tally_; }
  /// The name of the participant; empty: it has none, or was never there.
  [[nodiscard]] const std::string& participant_name() const { return participant_name_; }

  /// Asks `query KIND key=value...`. `then` is called once, perhaps before this returns.
  void ask(const std::string& kind, const Parameters& parameters, Then then);
  /// Gives the events of the services and requests of others to this function.
  void on_event(std::function<void(const Event&)> on_event) { on_event_ = std::move(on_event); }

 private:
  struct Question {
    Then then;
    Answer answer;
    base::Instant deadline{};
  };

  client::DaemonLink::Told told();
  void on_up(const gcnp::Statement& hello);
  void on_down(const std::string& reason);
  void on_reply(gcnp::Reply reply);
  void on_message(const gcnp::Statement& message);
  void on_error(std::uint32_t number, const Error& error);
  void settle(std::uint32_t number, bool is_answered);
  void look_at_ontology();
  void check_deadlines();

  client::Reactor& reactor_;
  Tally tally_;
  client::Log log_;
  client::DaemonLink link_;
  client::Session session_;
  ForeignServices foreign_;
  std::map<std::uint32_t, Question> questions_;
  std::function<void(const Event&)> on_event_;
  std::string participant_name_;
  std::string ontology_;  ///< the digest
  client::Reactor::Timer ontology_timer_;
  client::Reactor::Timer deadline_timer_;
};

}  // namespace geminga::bridge

#endif
