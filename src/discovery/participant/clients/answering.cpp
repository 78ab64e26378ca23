#include "discovery/participant/clients/answering.hpp"

#include <utility>

#include "discovery/gcnp/parameters.hpp"
#include "discovery/participant/clients/limits.hpp"
#include "discovery/participant/clients/session.hpp"

namespace geminga::participant {

Piece::Piece(Session& session, WorkMeter& work, gcnp::Statement& line)
    : session_(session), work_(work), line_(line), begin_(work.done()) {}

void Piece::tell(Line line) {
  line_.parameters = std::move(line);
  session_.say(line_);
  work_.add(cost_of_answer_line);
  ++told_;
}

void Piece::look_at(std::size_t entries) {
  work_.add(entries * cost_of_entry);
  looked_at_ += entries;
}

bool Piece::is_full() const { return work_.done() - begin_ >= work_in_step; }

Answering telling(Answer answer) {
  Answering answering{.kind = std::move(answer.kind), .proceed = {}, .end = std::move(answer.end)};
  answering.looked_at = answer.looked_through;
  answering.proceed = [lines = std::move(answer.lines), next = std::size_t{0}](Piece& piece) mutable {
    while (next < lines.size() && !piece.is_full()) piece.tell(std::move(lines[next++]));
    return next == lines.size();
  };
  return answering;
}

void begin_answer(Session& session, WorkMeter& work, std::uint32_t id, Answering answering) {
  answering.id = id;
  work.add(answering.looked_at * cost_of_entry);
  session.answering = std::move(answering);
  proceed_answer(session, work);
}

void proceed_answer(Session& session, WorkMeter& work) {
  Answering& answering = *session.answering;
  gcnp::Statement statement{.id = answering.id, .command = "msg", .subcommand = answering.kind, .parameters = {}};
  Piece piece(session, work, statement);
  const bool is_over = answering.proceed(piece);
  answering.told += piece.told();
  answering.looked_at += piece.looked_at();
  if (!is_over) return;
  statement.subcommand = "end";
  statement.parameters.clear();
  gcnp::append(statement.parameters, "count", answering.told);
  statement.parameters.insert(statement.parameters.end(), answering.end.begin(), answering.end.end());
  statement.parameters.insert(statement.parameters.end(), piece.end().begin(), piece.end().end());
  session.say(statement);
  session.gate.charge(answering.looked_at / work_per_statement);
  session.answering.reset();
}

}  // namespace geminga::participant
