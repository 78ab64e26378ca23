// Puts answers on the wire.
#include <utility>

#include "discovery/participant/queries/lines.hpp"

namespace geminga::participant {

Piece::Piece(Core& core, Session& session, gcnp::Statement& line)
    : core_(core), session_(session), line_(line), begin_(core.work()) {}

void Piece::tell(Line line) {
  line_.parameters = std::move(line);
  session_.say(line_);
  core_.worked += cost_of_answer_line;
  ++told_;
}

void Piece::look_at(std::size_t entries) {
  core_.worked += entries * cost_of_entry;
  looked_at_ += entries;
}

bool Piece::is_full() const { return core_.work() - begin_ >= work_in_step; }

Answering telling(Answer answer) {
  Answering answering{.kind = std::move(answer.kind), .proceed = {}, .end = std::move(answer.end)};
  answering.looked_at = answer.looked_through;
  answering.proceed = [lines = std::move(answer.lines), next = std::size_t{0}](Core&, Piece& piece) mutable {
    while (next < lines.size() && !piece.is_full()) piece.tell(std::move(lines[next++]));
    return next == lines.size();
  };
  return answering;
}

std::optional<Error> reply(Core& core, Session& session, std::uint32_t id, std::expected<Answering, Error> answering) {
  if (!answering) return std::move(answering.error());
  answering->id = id;
  core.worked += answering->looked_at * cost_of_entry;
  session.answering = std::move(*answering);
  proceed_answer(core, session);
  return std::nullopt;
}

void proceed_answer(Core& core, Session& session) {
  Answering& answering = *session.answering;
  gcnp::Statement statement{.id = answering.id, .command = "msg", .subcommand = answering.kind, .parameters = {}};
  Piece piece(core, session, statement);
  const bool is_over = answering.proceed(core, piece);
  answering.told += piece.told();
  answering.looked_at += piece.looked_at();
  if (!is_over) return;
  statement.subcommand = "end";
  statement.parameters.clear();
  append(statement.parameters, "count", answering.told);
  statement.parameters.insert(statement.parameters.end(), answering.end.begin(), answering.end.end());
  statement.parameters.insert(statement.parameters.end(), piece.end().begin(), piece.end().end());
  session.say(statement);
  session.gate.charge(answering.looked_at / work_per_statement);
  session.answering.reset();
}

}  // namespace geminga::participant
