#include "discovery/participant/turns.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "base/text.hpp"
#include "discovery/participant/own_services.hpp"
#include "discovery/participant/queries/queries.hpp"
#include "discovery/participant/statements.hpp"
#include "discovery/participant/telling.hpp"

namespace geminga::participant {
namespace {

Error too_fast(const Core& core) {
  return {ErrorCode::too_many, "too many statements: the limit is " +
                                   std::to_string(core.settings.limits.statements_per_second) + " in a second"};
}

/// Whether there is more to do about what the client has said before its next statement.
bool is_being_told(const Session& session) {
  return has_picture(session) || session.answering || !session.to_rename.empty();
}

/// Answers a line that was not read, by the id that it begins with.
void refuse(Core& core, Session& session, const gcnp::LineReader::Line& line, const Error& error) {
  const std::string_view beginning = line.text.substr(0, gcnp::LineReader::beginning_bytes);
  const std::string_view word = beginning.substr(0, beginning.find(' '));
  core.refuse(session, base::parse_number<std::uint32_t>(word).value_or(0), error);
}

void take_statement(Core& core, Session& session, std::string_view line) {
  const auto statement = gcnp::parse(line);
  if (!statement) {
    core.refuse(session, statement.error().id, statement.error().error);
    return;
  }
  const std::uint64_t events = session.events;
  const std::uint64_t classified = core.expressions.counts().classified;
  const std::uint64_t decided = core.overlaps.counts().decided;
  const auto request = gcnp::read_request(*statement);
  const Refusal refusal = request ? handle(core, session, statement->id, *request) : Refusal(request.error());
  if (refusal && refusal->code == ErrorCode::not_ready && core.expressions.is_waiting(core.vocabulary())) {
    session.held = line;  // a refused statement has changed nothing, and is handled anew
    return;
  }
  if (refusal) core.refuse(session, statement->id, *refusal);
  // Now, so that an answer to what comes next stands behind the events of this.
  if (has_picture(session) && !session.lags_since) proceed_picture(core, session);
  deliver_events(core);
  session.gate.charge((session.events - events) / work_per_statement +
                      (core.expressions.counts().classified - classified) * statements_per_expression +
                      (core.overlaps.counts().decided - decided) * statements_per_overlap);
}

void take_line(Core& core, Session& session, const gcnp::LineReader::Line& line) {
  ++core.counters.statements;
  ++session.statements;
  session.heard = core.env.now();
  core.worked += cost_of_statement;
  switch (session.gate.count(core.env.now())) {
    case RateGate::Verdict::pass:
      break;
    case RateGate::Verdict::refuse:
      refuse(core, session, line, too_fast(core));
      return;
    case RateGate::Verdict::flood:
      core.log(base::LogLevel::warning, "peer " + session.name + " floods: its connection is closed");
      refuse(core, session, line, too_fast(core));
      session.is_closing = true;
      return;
  }
  if (line.is_too_long) {
    refuse(core, session, line,
           {ErrorCode::too_large,
            "the line is too long: the limit is " + std::to_string(gcnp::max_line_bytes) + " octets"});
  } else {
    take_statement(core, session, line.text);
  }
}

/// The smallest thing that can be done for a client, in the order in which it must be done.
void do_next(Core& core, Session& session) {
  if (session.is_leaving) {
    withdraw_one(core, session);
  } else if (!session.to_rename.empty()) {
    rename_one(core, session);
  } else if (has_picture(session)) {
    proceed_picture(core, session);
  } else if (session.answering) {
    proceed_answer(core, session);
  } else if (session.held) {
    take_statement(core, session, *std::exchange(session.held, std::nullopt));
  } else if (const auto line = session.reader.next()) {
    take_line(core, session, *line);
  }
  deliver_events(core);
}

/// One client's part of a turn. What others were told because of it is work of the turn and not of this client: who
/// asked to be told of a change has caused that, and is bounded by what may wait for it.
void do_step(Core& core, Session& session) {
  const Work begin = core.work();
  core.overlaps.begin_step();
  const std::uint64_t events = core.counters.events;
  const std::uint64_t own_events = session.events;
  while (core.work() - begin < work_in_step && has_work(core, session)) do_next(core, session);
  const std::uint64_t others = (core.counters.events - events) - (session.events - own_events);
  session.use(core.work() - begin - others * cost_of_event, core.env.now());
}

/// Equal ones in the order of their arrival.
Session* find_next(Core& core) {
  Session* next = nullptr;
  for (const auto& [stream, session] : core.sessions) {
    if (!has_work(core, *session)) continue;
    if (next == nullptr || session->used(core.env.now()) < next->used(core.env.now())) next = session.get();
  }
  return next;
}

}  // namespace

bool has_business(Session& session) {
  if (session.is_leaving) return session.service_count() > 0;
  if (session.is_closing) return false;
  return is_being_told(session) || session.held || session.reader.has_line();
}

bool has_work(Core& core, Session& session) {
  if (!has_business(session)) return false;
  if (session.is_leaving) return true;
  const bool must_wait = session.held && core.expressions.is_waiting(core.vocabulary()) && !is_being_told(session);
  return !must_wait && core.backlog(session) <= core.settings.limits.unread_before_more;
}

bool is_turn_due(Core& core) {
  return core.phase == Phase::ready &&
         std::ranges::any_of(core.sessions, [&](const auto& entry) { return has_work(core, *entry.second); });
}

void take_turn(Core& core) {
  const Work begin = core.work();
  while (core.work() - begin < work_in_turn) {
    Session* next = find_next(core);
    if (next == nullptr) return;
    do_step(core, *next);
  }
}

}  // namespace geminga::participant
