#include "discovery/participant/clients/turns.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "base/text.hpp"

namespace geminga::participant {
namespace {

Error too_fast(const ClientLimits& limits) {
  return {ErrorCode::too_many,
          "too many statements: the limit is " + std::to_string(limits.statements_per_second) + " in a second"};
}

/// Whether there is more to do about what the client has said before its next statement.
bool is_being_told(const Session& session) {
  return session.is_resyncing() || session.answering || !session.to_rename.empty();
}

}  // namespace

/// Answers a line that was not read, by the id that it begins with.
void Turns::refuse_line(Session& session, const gcnp::LineReader::Line& line, const Error& error) {
  const std::string_view beginning = line.text.substr(0, gcnp::LineReader::beginning_bytes);
  const std::string_view word = beginning.substr(0, beginning.find(' '));
  parts_.sessions.refuse(session, base::parse_number<std::uint32_t>(word).value_or(0), error);
}

void Turns::take_statement(Session& session, std::string_view line) {
  const auto statement = gcnp::parse(line);
  if (!statement) {
    parts_.sessions.refuse(session, statement.error().id, statement.error().error);
    return;
  }
  const std::uint64_t events = session.events;
  const std::uint64_t classified = parts_.expressions.counts().classified;
  const std::uint64_t decided = parts_.overlaps.counts().decided;
  const auto request = gcnp::read_request(*statement);
  const Refusal refusal =
      request ? parts_.statements.handle(session, statement->id, *request) : Refusal(request.error());
  if (is_awaited(refusal) && parts_.resolver.is_waiting()) {
    session.held = line;  // a refused statement has changed nothing, and is handled anew
    return;
  }
  if (refusal) parts_.sessions.refuse(session, statement->id, *refusal);
  // Now, so that an answer to what comes next stands behind the events of this.
  if (session.is_resyncing() && !session.lag.is_any()) parts_.catch_up.proceed(session);
  parts_.telling.deliver_events();
  session.gate.charge((session.events - events) / work_per_statement +
                      (parts_.expressions.counts().classified - classified) * statements_per_expression +
                      (parts_.overlaps.counts().decided - decided) * statements_per_overlap);
}

void Turns::take_line(Session& session, const gcnp::LineReader::Line& line) {
  ++parts_.sessions.counters.statements;
  ++session.statements;
  session.heard = parts_.env.now();
  parts_.work.add(cost_of_statement);
  switch (session.gate.count(parts_.env.now())) {
    case RateGate::Verdict::pass:
      break;
    case RateGate::Verdict::refuse:
      refuse_line(session, line, too_fast(parts_.limits));
      return;
    case RateGate::Verdict::flood:
      parts_.env.log().write(base::LogLevel::warning, "peer " + session.name + " floods: its connection is closed",
                             {.peer = session.name, .code = "peer_floods"});
      refuse_line(session, line, too_fast(parts_.limits));
      session.is_closing = true;
      return;
  }
  if (line.is_too_long) {
    refuse_line(session, line,
                {ErrorCode::too_large,
                 "the line is too long: the limit is " + std::to_string(gcnp::max_line_bytes) + " octets"});
  } else {
    take_statement(session, line.text);
  }
}

/// The smallest thing that can be done for a client, in the order in which it must be done.
void Turns::do_next(Session& session) {
  if (session.is_leaving) {
    parts_.own.withdraw_one(session);
  } else if (!session.to_rename.empty()) {
    parts_.own.rename_one(session);
  } else if (session.is_resyncing()) {
    parts_.catch_up.proceed(session);
  } else if (session.answering) {
    proceed_answer(session, parts_.work);
  } else if (session.held) {
    take_statement(session, *std::exchange(session.held, std::nullopt));
  } else if (const auto line = session.reader.next()) {
    take_line(session, *line);
  }
  parts_.telling.deliver_events();
}

/// One client's part of a turn. What others were told because of it is work of the turn and not of this client: who
/// asked to be told of a change has caused that, and is bounded by what may wait for it.
void Turns::do_step(Session& session) {
  const Work begin = parts_.work.done();
  parts_.overlaps.begin_step();
  const std::uint64_t events = parts_.sessions.counters.events;
  const std::uint64_t own_events = session.events;
  while (parts_.work.done() - begin < work_in_step && has_work(session)) do_next(session);
  const std::uint64_t others = (parts_.sessions.counters.events - events) - (session.events - own_events);
  session.recent_work.add(parts_.work.done() - begin - others * cost_of_event, parts_.env.now());
}

/// Equal ones in the order of their arrival.
Session* Turns::find_next() const {
  Session* next = nullptr;
  for (const auto& [stream, session] : parts_.sessions.all) {
    if (!has_work(*session)) continue;
    if (next == nullptr || session->recent_work.at(parts_.env.now()) < next->recent_work.at(parts_.env.now()))
      next = session.get();
  }
  return next;
}

bool Turns::has_business(Session& session) {
  if (session.is_leaving) return session.services.count() > 0;
  if (session.is_closing) return false;
  return is_being_told(session) || session.held || session.reader.has_line();
}

bool Turns::has_work(Session& session) const {
  if (!has_business(session)) return false;
  if (session.is_leaving) return true;
  const bool must_wait = session.held && parts_.resolver.is_waiting() && !is_being_told(session);
  return !must_wait && session.backlog(parts_.env) <= parts_.limits.unread_before_more;
}

bool Turns::is_due() const {
  return std::ranges::any_of(parts_.sessions.all, [&](const auto& entry) { return has_work(*entry.second); });
}

void Turns::take() {
  const Work begin = parts_.work.done();
  while (parts_.work.done() - begin < work_in_turn) {
    Session* next = find_next();
    if (next == nullptr) return;
    do_step(*next);
  }
}

}  // namespace geminga::participant
