#include "recording/talk.hpp"

#include "base/text.hpp"
#include "discovery/gcnp/request.hpp"
#include "discovery/gcnp/statement.hpp"
#include "recording/answering.hpp"

namespace geminga::recording {

void Talk::hear(std::string_view octets) {
  if (is_over_) return;
  if (first_word_.take(octets) == gcnp::FirstWord::Verdict::foreign) {
    is_foreign_ = true;
  } else {
    lines_.feed(octets);
  }
}

std::string Talk::answer_to(std::string_view line, const State& state) {
  const auto statement = gcnp::parse(line);
  if (!statement) return gcnp::to_line(statement.error().id, statement.error().error);
  const auto request = gcnp::read_request(*statement);
  if (!request) return gcnp::to_line(statement->id, request.error());
  if (const auto* hello = std::get_if<gcnp::Hello>(&*request)) {
    return gcnp::to_line(welcome(state, peer_, hello->name.value_or("")));
  }
  if (std::holds_alternative<gcnp::Ping>(*request)) return gcnp::to_line({0, "msg", "pong", {}});
  if (std::holds_alternative<gcnp::Bye>(*request)) {
    is_over_ = true;
    return "";
  }
  const auto lines = answer(state, statement->id, *request);
  if (!lines) return gcnp::to_line(statement->id, lines.error());
  std::string text;
  for (const gcnp::Statement& one : *lines) text += gcnp::to_line(one);
  return text;
}

std::string Talk::next_answer(const State& state) {
  if (is_foreign_ && !is_over_) {
    is_over_ = true;
    return gcnp::to_line(
        0, {ErrorCode::malformed, "this is GCNP, and no other protocol: a connection begins with a number"});
  }
  while (!is_over_) {
    const auto line = lines_.next();
    if (!line) return "";
    if (line->is_too_long) {
      const std::string_view word = line->text.substr(0, line->text.find(' '));
      return gcnp::to_line(base::parse_number<std::uint32_t>(word).value_or(0), gcnp::line_too_long());
    }
    // A goodbye is answered by nothing.
    if (std::string text = answer_to(line->text, state); !text.empty()) return text;
  }
  return "";
}

}  // namespace geminga::recording
