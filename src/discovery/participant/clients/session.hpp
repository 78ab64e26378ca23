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
#include "discovery/participant/clients/limits.hpp"
#include "discovery/participant/clients/rate_gate.hpp"
#include "discovery/participant/clients/resync.hpp"
#include "discovery/participant/knowledge/work.hpp"
#include "env/env.hpp"
#include "geminga/error.hpp"
#include "geminga/life.hpp"
#include "geminga/named.hpp"
#include "geminga/service.hpp"

namespace geminga::participant {

/// A publication as its peer stated it. The names are kept, so that another ontology can resolve them anew.
struct StatedPublication {
  NamedIdentity named;
  Publication service;      ///< its identity is resolved while it is in force; the address is the stated one
  bool is_in_force = true;  ///< false: the loaded ontology does not know its names, or there is none yet
  bool is_awaited = false;  ///< not in force because the ontology is not ready; its peer has not been told
};

struct StatedSubscription {
  NamedIdentity named;
  Subscription service;
  bool has_limit = false;  ///< the limit was stated; else it follows the mode
  bool is_quiet = false;   ///< it has a place of the room that its peer asked for, and is not announced
  bool is_in_force = true;
  bool is_awaited = false;

  /// Whether the request is announced: requests for participants (descriptions) are not.
  [[nodiscard]] bool is_announced() const { return !is_quiet && service.mode != ChannelMode::participant; }
};

/// The numbers of publications and subscriptions are one space: an event is about one of them only.
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
  std::map<std::uint32_t, StatedPublication> publications;
  std::map<std::uint32_t, StatedSubscription> subscriptions;
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
  bool asks_for_keys = false;  ///< its peer asked for the keys of its channels
  bool has_keys = false;       ///< and was given some
  /// By request, the channels whose keys its peer has.
  std::set<std::pair<std::uint32_t, Life>> channels_told;
  std::size_t room = 0;   ///< how many quiet subscriptions it may have
  std::size_t quiet = 0;  ///< and has
  std::uint64_t statements = 0;
  std::uint64_t events = 0;
  gcnp::FirstWord first_word;
  base::Instant heard{};  ///< when its last line was handled, or it connected
  /// Since when it is too far behind to be told of every change and has read nothing; nothing: it is not behind. It is
  /// told so (`msg lagged`) when it has caught up.
  std::optional<base::Instant> lags_since;
  /// Octets that waited for it when it began to lag, or when it had read something since then: `lags_since` moves on.
  std::size_t lag_backlog = 0;
  /// Set by `sys bye`, by a flood or by a client that does not speak GCNP: nothing is read from it any more, and at the
  /// end of the event it is closed.
  bool is_closing = false;
  bool says_bye = false;  ///< it asked for that itself
  /// The connection is over, and what it offered and asked for is being withdrawn.
  bool is_leaving = false;
  bool is_wanted = true;  ///< as Env was told last

  /// Whether its peer is still to be told how things stand for some request.
  [[nodiscard]] bool is_resyncing() const { return !resyncs.empty(); }
  [[nodiscard]] std::size_t service_count() const { return publications.size() + subscriptions.size(); }
  /// Those that are announced, and count for the limits that all peers share.
  [[nodiscard]] std::size_t shared_count() const { return service_count() - quiet; }
  /// Work that was done for it lately: each half-life counts half of it.
  [[nodiscard]] Work used(base::Instant now) const;
  void use(Work work, base::Instant now);

  /// Calls `what` with the number and the statement of each request.
  template <typename What>
  void for_each_request(const What& what) const {
    for (const auto& [number, stated] : publications) what(number, stated);
    for (const auto& [number, stated] : subscriptions) what(number, stated);
  }
  /// Calls `what` with the statement of this number, if there is one.
  template <typename What>
  void with_request(std::uint32_t number, const What& what) {
    if (const auto one = publications.find(number); one != publications.end()) what(one->second);
    if (const auto one = subscriptions.find(number); one != subscriptions.end()) what(one->second);
  }
  /// A request of the peer is over: nothing is left of it here.
  void forget(std::uint32_t number) {
    publications.erase(number);
    subscriptions.erase(number);
    told.erase(number);
    resyncs.erase(number);
    to_rename.erase(number);
    std::erase_if(channels_told, [number](const auto& one) { return one.first == number; });
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
  Work used_ = 0;
  base::Instant used_at_{};
  std::string outbox_;
};

}  // namespace geminga::participant

#endif
