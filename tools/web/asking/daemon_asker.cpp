#include "web/asking/daemon_asker.hpp"

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>

#include "client/cpp/record.hpp"

namespace geminga::web {
namespace {

using Kind = ClientError::Kind;

/// The line of a question, or why GCNP cannot carry it.
std::expected<gcnp::Statement, ClientError> statement_of(std::uint32_t number, const Query& query) {
  gcnp::Statement statement{number, "query", query.kind, {}};
  for (const auto& [key, value] : query.parameters) statement.parameters.push_back({key, value});
  const std::string line = gcnp::to_line(statement);
  const auto read_back = gcnp::parse(std::string_view(line).substr(0, line.size() - 2));
  if (!read_back) return std::unexpected(ClientError{Kind::wrong_use, read_back.error().error.text});
  if (*read_back == statement) return statement;
  return std::unexpected(ClientError{Kind::wrong_use, "a key or value has characters that GCNP cannot carry"});
}

std::size_t octets_of(const gcnp::Statement& message) {
  std::size_t octets = line_cost;
  for (const auto& parameter : message.parameters) {
    octets += parameter_cost + parameter.key.size() + (parameter.value ? parameter.value->size() : 0);
  }
  return octets;
}

Outcome shared(Result<Answer, ClientError> outcome) {
  return std::make_shared<const Result<Answer, ClientError>>(std::move(outcome));
}

}  // namespace

DaemonAsker::DaemonAsker(client::Reactor& reactor, std::vector<client::Endpoint> endpoints,
                         std::chrono::milliseconds timeout)
    : reactor_(reactor),
      timeout_(timeout),
      absence_{Kind::unreachable, "the daemon has not answered yet: try again"},
      link_(reactor,
            {.endpoints = std::move(endpoints), .name = "geminga-web", .timeout = timeout, .asks_for_keys = false},
            {.up = [this](const gcnp::Statement&) { on_up(); },
             .down = [this](const std::string& reason) { on_down(reason); },
             .reply = [this](const gcnp::Reply& reply) { on_reply(reply); },
             .refused = [](const std::string&) {},
             .missing =
                 [this](const std::string& where, const std::string& reason) {
                   absence_ = {Kind::unreachable, "no daemon at " + where + " (" + reason +
                                                      "): start gemingad, or say where it is with GEMINGA_CONNECT"};
                 }}),
      timer_(reactor, [this] { check_deadlines(); }) {}

void DaemonAsker::ask(const Query& query, Then then) {
  if (!link_.is_up()) return then(shared(std::unexpected(absence_)));
  if (const Outcome recent = recent_.find(query, reactor_.now())) return then(recent);
  if (const auto asked = numbers_.find(query); asked != numbers_.end()) {
    open_.at(asked->second).waiting.push_back(std::move(then));
    return;
  }
  if (open_.size() >= max_open_questions) {
    return then(shared(std::unexpected(
        ClientError{Kind::refused, "too many questions wait for the daemon: ask again later", ErrorCode::too_many})));
  }
  const std::uint32_t number = std::max<std::uint32_t>(last_number_ + 1, 1);  // 0 is the system's
  const auto statement = statement_of(number, query);
  if (!statement) return then(shared(std::unexpected(statement.error())));
  last_number_ = number;
  Open& open = open_[number];
  open.query = query;
  open.deadline = reactor_.now() + timeout_;
  open.waiting.push_back(std::move(then));
  numbers_.insert_or_assign(query, number);
  arm();
  link_.say(*statement);
}

Presence DaemonAsker::presence() const {
  return link_.is_up() ? Presence{.is_up = true} : Presence{.is_up = false, .reason = absence_.text};
}

void DaemonAsker::on_up() { recent_.clear(); }

void DaemonAsker::on_down(const std::string& reason) {
  recent_.clear();
  const ClientError error{Kind::closed, "the daemon is gone (" + reason + "): ask again later"};
  while (!open_.empty()) settle(open_.begin()->first, std::unexpected(error));
}

void DaemonAsker::on_reply(const gcnp::Reply& reply) {
  if (const auto* event = std::get_if<Event>(&reply)) {
    const auto* error = std::get_if<Error>(&event->what);
    if (error == nullptr || !open_.contains(event->request)) return;
    return settle(event->request, std::unexpected(ClientError{Kind::refused, error->text, error->code}));
  }
  const auto& message = std::get<gcnp::Statement>(reply);
  // A newer daemon may say what nobody here has asked for.
  if (message.command == "msg" && open_.contains(message.id)) take_line(message.id, message);
}

void DaemonAsker::take_line(std::uint32_t number, const gcnp::Statement& message) {
  Open& open = open_.at(number);
  open.octets += octets_of(message);
  if (open.octets > max_answer_octets) return link_.drop("its answer is longer than any may be");
  if (message.subcommand != "end") {
    open.answer.records.push_back(client::record_of(message));
    return;
  }
  open.answer.end = client::record_of(message);
  settle(number, std::move(open.answer));
}

void DaemonAsker::settle(std::uint32_t number, Result<Answer, ClientError> outcome) {
  const auto found = open_.find(number);
  Open open = std::move(found->second);
  open_.erase(found);
  numbers_.erase(open.query);
  arm();
  const Outcome result = shared(std::move(outcome));
  if (result->has_value()) recent_.put(std::move(open.query), result, open.octets, reactor_.now());
  for (const Then& then : open.waiting) then(result);
}

void DaemonAsker::check_deadlines() {
  const base::Instant now = reactor_.now();
  std::vector<std::uint32_t> late;
  for (const auto& [number, open] : open_) {
    if (open.deadline <= now) late.push_back(number);
  }
  if (late.empty()) return arm();
  for (const std::uint32_t number : late) {
    settle(number, std::unexpected(ClientError{Kind::timed_out, "no answer from " + link_.where() +
                                                                    " in time: is the daemon busy or stopped?"}));
  }
  link_.drop("no answer in time");
}

void DaemonAsker::arm() {
  // Numbers ascend, and so do deadlines but where the numbers have begun again.
  base::Instant first = base::never;
  for (const auto& [number, open] : open_) first = std::min(first, open.deadline);
  timer_.set(first);
}

}  // namespace geminga::web
