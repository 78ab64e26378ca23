// A session: one connected peer, its statements, what it was told, and what it waits for.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_CLIENTS_SESSION_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_CLIENTS_SESSION_HPP

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "discovery/gcnp/first_word.hpp"
#include "discovery/gcnp/line_reader.hpp"
#include "discovery/gcnp/statement.hpp"
#include "discovery/participant/clients/answering.hpp"
#include "discovery/participant/clients/lag.hpp"
#include "discovery/participant/clients/limits.hpp"
#include "discovery/participant/clients/rate_gate.hpp"
#include "discovery/participant/clients/recent_work.hpp"
#include "discovery/participant/clients/resync.hpp"
#include "discovery/participant/clients/stated_services.hpp"
#include "discovery/participant/clients/told_keys.hpp"
#include "discovery/participant/knowledge/work.hpp"
#include "env/env.hpp"
#include "geminga/error.hpp"
#include "geminga/service.hpp"

namespace geminga::participant {

/// One client that is connected, with all that is kept of it.
class Session {
 public:
  Session(env::StreamId stream, PeerId peer, std::string_view user, const ClientLimits& limits);

  [[nodiscard]] env::StreamId stream() const { return stream_; }
  [[nodiscard]] PeerId peer() const { return peer_; }

  /// "peer-N" until the peer says hello with a name.
  std::string name;
  /// The user who runs the peer, where the system tells; else empty.
  const std::string user;
  gcnp::LineReader reader;
  RateGate gate;
  StatedServices services;
  /// By request, the services that its peer was told of and that are not gone since; so that the peer can be told that
  /// they are gone when the request, which it keeps, is out of force for a while.
  std::map<std::uint32_t, std::set<ServiceKey>> told;
  /// By request, the resync that is under way or waits; without one, events alone keep the peer up to date.
  std::map<std::uint32_t, Resync> resyncs;
  /// The answer under way, behind which the next statement waits.
  std::optional<Answering> answering;
  /// A statement with a class expression that waits for the ontology to be prepared, and behind which the next waits.
  std::optional<std::string> held;
  /// Its services that are still to be entered under its new name.
  std::set<std::uint32_t> to_rename;
  ToldKeys keys;
  std::uint64_t statements = 0;
  std::uint64_t events = 0;
  gcnp::FirstWord first_word;
  base::Instant heard{};  ///< when its last line was handled, or it connected
  Lag lag;
  RecentWork recent_work;
  /// Set by `sys bye`, by a flood or by a client that does not speak GCNP: nothing is read from it any more, and at the
  /// end of the event it is closed.
  bool is_closing = false;
  bool says_bye = false;  ///< it asked for that itself
  /// The connection is over, and what it offered and asked for is being withdrawn.
  bool is_leaving = false;
  bool is_wanted = true;  ///< as Env was told last

  /// Whether its peer is still to be told how things stand for some request.
  [[nodiscard]] bool is_resyncing() const { return !resyncs.empty(); }
  /// A request of the peer is over: nothing is left of it here.
  void forget(std::uint32_t number) {
    services.erase(number);
    told.erase(number);
    resyncs.erase(number);
    to_rename.erase(number);
    keys.forget(number);
  }

  void say(const gcnp::Statement& statement) { outbox_ += gcnp::to_line(statement); }
  /// A line with its end.
  void say(std::string_view line) { outbox_ += line; }
  void say(std::uint32_t id, const Error& error) { outbox_ += gcnp::to_line(id, error); }
  [[nodiscard]] std::size_t outbox_bytes() const { return outbox_.size(); }
  /// Everything said since the last call, to be written at once.
  [[nodiscard]] std::string take_outbox();
  /// Octets that wait for the peer, here and in Env.
  [[nodiscard]] std::size_t backlog(const env::Env& env) const { return env.unsent(stream_) + outbox_.size(); }

 private:
  env::StreamId stream_;
  PeerId peer_;
  std::string outbox_;
};

}  // namespace geminga::participant

#endif
