// The questions to the local daemon over one connection of GCNP.
#ifndef GEMINGA_WEB_ASKING_DAEMON_ASKER_HPP
#define GEMINGA_WEB_ASKING_DAEMON_ASKER_HPP

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "client/channels/daemon_link.hpp"
#include "client/channels/endpoint.hpp"
#include "client/channels/reactor.hpp"
#include "discovery/gcnp/event.hpp"
#include "discovery/gcnp/statement.hpp"
#include "web/asking/asker.hpp"
#include "web/asking/limits.hpp"
#include "web/asking/recent_answers.hpp"

namespace geminga::web {

/// Connects again by itself, by the rules of the client libraries (client/protocol/backoff.hpp). Offers nothing, asks
/// for no service, and does not ask for the keys of channels.
///
/// The same question is asked once at a time and answered to all who ask it; an answer is given again for answer_life.
/// A daemon that does not answer in time, says more than max_answer_octets or says what is no GCNP is left, all that
/// waits is told so, and a new connection is tried. Times go by `reactor`, which must outlive this.
class DaemonAsker : public Asker {
 public:
  DaemonAsker(client::Reactor& reactor, std::vector<client::Endpoint> endpoints, std::chrono::milliseconds timeout);

  /// Begins to connect.
  void start() { link_.start(); }
  /// Errors: wrong_use, where GCNP cannot carry the question; unreachable; refused, by the daemon or where
  /// max_open_questions wait; closed and timed_out, where the daemon was left meanwhile.
  void ask(const Query& query, Then then) override;
  [[nodiscard]] Presence presence() const override;

 private:
  /// A question that waits, and as much of its answer as has come.
  struct Open {
    Query query;
    std::vector<Then> waiting;
    Answer answer;
    std::size_t octets = 0;
    base::Instant deadline{};
  };

  void on_up();
  void on_down(const std::string& reason);
  void on_reply(const gcnp::Reply& reply);
  void take_line(std::uint32_t number, const gcnp::Statement& message);
  void settle(std::uint32_t number, Result<Answer, ClientError> outcome);
  void check_deadlines();
  void arm();

  client::Reactor& reactor_;
  std::chrono::milliseconds timeout_;
  std::map<std::uint32_t, Open> open_;  ///< by the number of the statement
  std::map<Query, std::uint32_t> numbers_;
  RecentAnswers recent_;
  std::uint32_t last_number_ = 0;
  ClientError absence_;  ///< why there is no daemon, while there is none
  client::DaemonLink link_;
  client::Reactor::Timer timer_;
};

}  // namespace geminga::web

#endif
