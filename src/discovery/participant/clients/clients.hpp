// The clients on this host: how they come, how their octets come in and go out, and how they go.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_CLIENTS_CLIENTS_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_CLIENTS_CLIENTS_HPP

#include <optional>
#include <string_view>

#include "discovery/matching/matcher.hpp"
#include "discovery/participant/clients/admission.hpp"
#include "discovery/participant/clients/answering.hpp"
#include "discovery/participant/clients/catch_up.hpp"
#include "discovery/participant/clients/greeting.hpp"
#include "discovery/participant/clients/key_telling.hpp"
#include "discovery/participant/clients/limits.hpp"
#include "discovery/participant/clients/own_services.hpp"
#include "discovery/participant/clients/reentry.hpp"
#include "discovery/participant/clients/sessions.hpp"
#include "discovery/participant/clients/statement_names.hpp"
#include "discovery/participant/clients/statements.hpp"
#include "discovery/participant/clients/telling.hpp"
#include "discovery/participant/clients/turns.hpp"
#include "discovery/participant/clients/wording.hpp"
#include "discovery/participant/knowledge/expressions.hpp"
#include "discovery/participant/knowledge/overlaps.hpp"
#include "discovery/participant/knowledge/resolver.hpp"
#include "discovery/participant/knowledge/self.hpp"
#include "discovery/participant/knowledge/work.hpp"
#include "env/env.hpp"

namespace geminga::participant {

/// Owns the sessions, and what is done for them: telling, own services, statements and turns. It knows nothing of the
/// air.
class Clients {
 public:
  /// The parts of knowledge that statements read and change. All are borrowed for its life.
  struct Knows {
    const Self& self;
    matching::Matcher& matcher;
    Resolver& resolver;
    const Expressions& expressions;
    Overlaps& overlaps;
    WorkMeter& work;
  };
  /// Borrows `env` and `limits` for its life. `ask` answers queries, `keys_of` gives the keys of channels, `way_of` the
  /// ways to other participants.
  Clients(env::Env& env, const ClientLimits& limits, const Knows& knows, Ask ask, KeysOf keys_of,
          Wording::WayOf way_of);
  Clients(const Clients&) = delete;
  Clients& operator=(const Clients&) = delete;

  /// A client has connected. Where there is room for no more, a silent one gives way, or the new one is closed.
  void open(env::StreamId stream, std::string_view user);
  /// A client has connected that is not wanted: it is told why, and closed.
  void refuse(env::StreamId stream, const Error& error);
  /// Takes in octets of a client, and keeps them for its turn. One that does not begin as GCNP does is closed.
  void hear(env::StreamId stream, std::string_view bytes);
  /// The client is gone.
  void lose(env::StreamId stream);

  /// Closes those that are to be closed, and those that lag and have read nothing for too long.
  void close_due();
  /// Hands to Env what the peers are told, and has it go on reading those of which nothing waits.
  void write();
  /// Closes all with this error, if there is one.
  void close_all(const std::optional<Error>& error);
  /// When the next client is to be closed because it reads nothing.
  [[nodiscard]] base::Instant deadline() const;
  /// Ends the answers under way: what is left of them would be about classes of the former ontology.
  void end_answers();

  [[nodiscard]] const Sessions& sessions() const { return sessions_; }
  [[nodiscard]] KeyTelling& keys() { return keys_; }
  [[nodiscard]] Telling& telling() { return telling_; }
  [[nodiscard]] OwnServices& own() { return own_; }
  [[nodiscard]] const OwnServices& own() const { return own_; }
  [[nodiscard]] Reentry& reentry() { return reentry_; }
  [[nodiscard]] const Reentry& reentry() const { return reentry_; }
  [[nodiscard]] Turns& turns() { return turns_; }

 private:
  using At = Sessions::Map::iterator;
  void leave(At one);
  void close(At one);
  [[nodiscard]] At find_silent();
  [[nodiscard]] At find_of_greediest(std::string_view user);
  [[nodiscard]] bool make_place(std::string_view user);
  [[nodiscard]] bool is_stuck(Session& session);

  env::Env& env_;
  const ClientLimits& limits_;
  Sessions sessions_;
  std::uint32_t next_peer_ = 1;
  KeyTelling keys_;
  Wording wording_;
  Telling telling_;
  CatchUp catch_up_;
  OwnServices own_;
  StatementNames names_;
  Reentry reentry_;
  Admission admission_;
  Greeting greeting_;
  Statements statements_;
  Turns turns_;
};

}  // namespace geminga::participant

#endif
