// One connected peer: its name, what it stated, the lines that wait for it and those that it waits for.
#ifndef GEMINGA_PARTICIPANT_SESSION_HPP
#define GEMINGA_PARTICIPANT_SESSION_HPP

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <set>
#include <string>
#include <string_view>

#include "env/env.hpp"
#include "gcnp/line_reader.hpp"
#include "gcnp/statement.hpp"
#include "geminga/error.hpp"
#include "geminga/named.hpp"
#include "geminga/service.hpp"
#include "participant/rate_gate.hpp"
#include "participant/settings.hpp"

namespace geminga::participant {

/// A publication as its peer stated it. The names stay, so that another ontology can resolve them anew.
struct StatedPublication {
  NamedIdentity named;
  Publication publication;  ///< its identity is resolved while it is in force; the address is the stated one
  bool is_in_force = true;  ///< false: the loaded ontology does not know its names
};

struct StatedSubscription {
  NamedIdentity named;
  Subscription subscription;
  bool has_limit = false;  ///< the limit was stated; else it follows the mode
  bool is_in_force = true;
};

/// The numbers of publications and subscriptions are one space: an event is about one of them only.
class Session {
 public:
  Session(env::StreamId stream, PeerId peer, const Limits& limits);

  [[nodiscard]] env::StreamId stream() const { return stream_; }
  [[nodiscard]] PeerId peer() const { return peer_; }

  /// "peer-N" until the peer says hello with a name.
  std::string name;
  gcnp::LineReader reader;
  RateGate gate;
  std::map<std::uint32_t, StatedPublication> publications;
  std::map<std::uint32_t, StatedSubscription> subscriptions;
  /// By request, what its peer was told of and not told off again; so that it can be told when the request itself,
  /// which the peer keeps, is out of force for a while.
  std::map<std::uint32_t, std::set<ServiceKey>> told;
  std::uint64_t statements = 0;
  /// Set by `sys bye`, by a flood or by a client that does not speak GCNP: nothing is read from it any more, and at the
  /// end of the event it is closed.
  bool is_closing = false;

  /// Keeps a line until the identifier is claimed. False, and nothing kept, when too many wait already.
  [[nodiscard]] bool hold(std::string_view line, const Limits& limits);
  /// The oldest line that was kept; requires has_held().
  [[nodiscard]] std::string take_held();
  [[nodiscard]] bool has_held() const { return !held_.empty(); }

  void say(const gcnp::Statement& statement) { outbox_ += gcnp::to_line(statement); }
  void say(std::uint32_t id, const Error& error) { outbox_ += gcnp::to_line(id, error); }
  [[nodiscard]] std::size_t outbox_bytes() const { return outbox_.size(); }
  /// Everything said since the last call, to be written at once.
  [[nodiscard]] std::string take_outbox();

 private:
  env::StreamId stream_;
  PeerId peer_;
  std::deque<std::string> held_;
  std::size_t held_bytes_ = 0;
  std::string outbox_;
};

}  // namespace geminga::participant

#endif
