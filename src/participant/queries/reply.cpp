// Puts an answer on the wire.
#include "participant/queries/lines.hpp"

namespace geminga::participant {

std::optional<Error> reply(Session& session, std::uint32_t id, const Answered& answered) {
  if (!answered) return answered.error();
  gcnp::Statement statement{.id = id, .command = "msg", .subcommand = answered->kind, .parameters = {}};
  for (const Line& line : answered->lines) {
    statement.parameters = line;
    session.say(statement);
  }
  statement.subcommand = "end";
  statement.parameters.clear();
  append(statement.parameters, "count", answered->lines.size());
  statement.parameters.insert(statement.parameters.end(), answered->end.begin(), answered->end.end());
  session.say(statement);
  session.gate.charge(answered->looked_through / work_per_statement);
  return std::nullopt;
}

}  // namespace geminga::participant
