#include "bridge/team/team.hpp"

#include <algorithm>
#include <variant>

#include "bridge/team/limits.hpp"
#include "client/cpp/record.hpp"

namespace geminga::bridge {

Team::Team(client::Reactor& reactor, std::vector<client::Endpoint> endpoints, std::string name,
           std::chrono::milliseconds timeout, Tell tell)
    : reactor_(reactor),
      tally_(reactor, tell),
      log_(reactor, [tell](std::string_view line) { tell(std::string(line)); }),
      link_(reactor,
            {.endpoints = std::move(endpoints), .name = std::move(name), .timeout = timeout, .asks_for_keys = false},
            told()),
      session_([this](const gcnp::Statement& statement) { link_.say(statement); }),
      foreign_(session_, tally_),
      ontology_timer_(reactor, [this] { look_at_ontology(); }),
      deadline_timer_(reactor, [this] { check_deadlines(); }) {}

client::DaemonLink::Told Team::told() {
  return {.up = [this](const gcnp::Statement& hello) { on_up(hello); },
          .down = [this](const std::string& reason) { on_down(reason); },
          .reply = [this](gcnp::Reply reply) { on_reply(std::move(reply)); },
          .refused = [this](const std::string& text) { log_.line(text); },
          .missing = [this](const std::string& where, const std::string& reason) { log_.on_no_daemon(where, reason); }};
}

void Team::on_up(const gcnp::Statement& hello) {
  participant_name_ = hello.value("participant_name").value_or("");
  ontology_ = hello.value("ontology").value_or("-");
  log_.on_daemon(link_.where());
  foreign_.on_up();
  session_.on_up();
  ontology_timer_.set(reactor_.now() + ontology_look);
}

void Team::on_down(const std::string&) {
  ontology_timer_.set(base::never);
  session_.on_down();
  while (!questions_.empty()) settle(questions_.begin()->first, false);
}

void Team::ask(const std::string& kind, const Parameters& parameters, Then then) {
  if (!link_.is_up() || questions_.size() >= max_questions) return then(std::nullopt);
  const std::uint32_t number = session_.next_number();
  gcnp::Statement statement{number, "query", kind, {}};
  for (const auto& [key, value] : parameters) statement.parameters.push_back({key, value});
  Question& question = questions_[number];
  question.then = std::move(then);
  question.deadline = reactor_.now() + answer_patience;
  if (deadline_timer_.at() == base::never) deadline_timer_.set(reactor_.now() + answer_patience);
  link_.say(statement);
}

void Team::on_reply(gcnp::Reply reply) {
  if (const auto* statement = std::get_if<gcnp::Statement>(&reply)) return on_message(*statement);
  const Event& event = std::get<Event>(reply);
  if (const auto* error = std::get_if<Error>(&event.what)) return on_error(event.request, *error);
  if (on_event_) on_event_(event);
}

void Team::on_message(const gcnp::Statement& message) {
  if (message.command != "msg") return;
  if (message.subcommand == "pong") {
    for (const auto& settled : session_.on_pong()) {
      if (settled.error && settled.error->code == ErrorCode::not_ready && !settled.is_change) {
        return link_.drop(settled.error->text);
      }
      foreign_.on_settled(settled);
    }
    return;
  }
  const auto found = questions_.find(message.id);
  if (found == questions_.end()) return;
  if (message.subcommand != "end") return found->second.answer.records.push_back(client::record_of(message));
  found->second.answer.end = client::record_of(message);
  settle(message.id, true);
}

void Team::on_error(std::uint32_t number, const Error& error) {
  if (questions_.contains(number)) return settle(number, false);
  if (const auto settled = session_.on_error(number, error)) foreign_.on_settled(*settled);
}

void Team::settle(std::uint32_t number, bool is_answered) {
  auto node = questions_.extract(number);
  Question& question = node.mapped();
  question.then(is_answered ? std::optional(std::move(question.answer)) : std::nullopt);
}

void Team::look_at_ontology() {
  ask("status", {}, [this](std::optional<Answer> answer) {
    if (!link_.is_up()) return;
    ontology_timer_.set(reactor_.now() + ontology_look);
    if (!answer || answer->records.empty()) return;
    const std::string digest(answer->records.front()["ontology"]);
    if (std::exchange(ontology_, digest) != digest) foreign_.on_other_ontology();
  });
}

void Team::check_deadlines() {
  base::Instant first = base::never;
  for (const auto& [number, question] : questions_) first = std::min(first, question.deadline);
  if (first <= reactor_.now()) return link_.drop("it does not answer in time");
  deadline_timer_.set(first);
}

}  // namespace geminga::bridge
