// Turns: the order in which clients are served, so that no event does more than a bounded part of their work.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_CLIENTS_TURNS_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_CLIENTS_TURNS_HPP

#include <string_view>

#include "base/log.hpp"
#include "discovery/participant/clients/catch_up.hpp"
#include "discovery/participant/clients/limits.hpp"
#include "discovery/participant/clients/own_services.hpp"
#include "discovery/participant/clients/sessions.hpp"
#include "discovery/participant/clients/statements.hpp"
#include "discovery/participant/clients/telling.hpp"
#include "discovery/participant/knowledge/expressions.hpp"
#include "discovery/participant/knowledge/overlaps.hpp"
#include "discovery/participant/knowledge/resolver.hpp"
#include "discovery/participant/knowledge/work.hpp"
#include "env/env.hpp"

namespace geminga::participant {

class Turns {
 public:
  /// The parts that it works with. All are borrowed for its life.
  struct Parts {
    env::Env& env;
    const ClientLimits& limits;
    Sessions& sessions;
    Telling& telling;
    CatchUp& catch_up;
    OwnServices& own;
    Statements& statements;
    const Resolver& resolver;
    const Expressions& expressions;  ///< how much they have cost
    Overlaps& overlaps;              ///< each step may decide a few
    WorkMeter& work;
  };
  explicit Turns(const Parts& parts) : parts_(parts) {}

  /// Whether something of the client waits to be handled: lines, the rest of an answer, what it is to be told.
  [[nodiscard]] static bool has_business(Session& session);
  /// Whether some of that can be done now: it does not wait for an ontology, and there is room for what the client is
  /// told.
  [[nodiscard]] bool has_work(Session& session) const;
  /// Whether any client has work: then another turn is due at once.
  [[nodiscard]] bool is_due() const;
  /// Does work for clients until work_in_turn is done or nobody has any. Of those that have, the one that used the
  /// least lately is served, then the next. Requires an identifier.
  ///
  /// A statement is not divided. It judges each service that it is about against each subscription that it may meet,
  /// and gives each local peer at most one event for each of its requests that the service concerns: at most as many as
  /// ClientLimits::services in all.
  void take();

 private:
  [[nodiscard]] Session* find_next() const;
  void do_step(Session& session);
  void do_next(Session& session);
  void take_line(Session& session, const gcnp::LineReader::Line& line);
  void take_statement(Session& session, std::string_view line);
  void refuse_line(Session& session, const gcnp::LineReader::Line& line, const Error& error);

  Parts parts_;
};

}  // namespace geminga::participant

#endif
