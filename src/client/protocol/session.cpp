#include "client/protocol/session.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "client/protocol/life.hpp"
#include "client/protocol/named_change.hpp"
#include "discovery/gcnp/request.hpp"

namespace geminga::client {
namespace {

gcnp::Statement create_statement(ChannelNumber number, const Session::Stated& stated) {
  if (const auto* publication = std::get_if<NamedPublication>(&stated)) {
    return gcnp::to_statement(number, gcnp::PubCreate{*publication});
  }
  return gcnp::to_statement(number, gcnp::SubCreate{std::get<NamedSubscription>(stated)});
}

/// The error that a daemon would find in the line of a statement.
std::optional<Error> fault_of(const gcnp::Statement& statement) {
  const std::string line = gcnp::to_line(statement);
  const auto read_back = gcnp::parse(std::string_view(line).substr(0, line.size() - 2));
  if (!read_back) return read_back.error().error;
  if (*read_back != statement) return Error{ErrorCode::malformed, "a value has characters that GCNP cannot carry"};
  const auto request = gcnp::read_request(*read_back);
  return request ? std::nullopt : std::optional(request.error());
}

}  // namespace

std::optional<Error> Session::fault(const Stated& stated) { return fault_of(create_statement(1, stated)); }

std::string Session::words(const Stated& stated) {
  gcnp::Statement statement = create_statement(1, stated);
  std::erase_if(statement.parameters, [](const auto& one) { return one.key == channel_attribute; });
  const std::string line = gcnp::to_line(statement);
  const std::string before = "1 " + statement.command + ' ' + statement.subcommand + ' ';
  return line.substr(before.size(), line.size() - before.size() - 2);
}

void Session::ask(ChannelNumber number, const gcnp::Statement& statement, std::optional<Stated> changed,
                  bool has_ping) {
  say_(statement);
  asked_.push_back({number, std::move(changed), std::nullopt, has_ping});
  if (has_ping) say_({0, "sys", "ping", {}});
}

void Session::create(ChannelNumber number, Stated stated) {
  const auto made = session_.emplace(number, Request{std::move(stated)}).first;
  if (is_up_) ask(number, create_statement(number, made->second.stated), std::nullopt, true);
}

std::expected<void, Error> Session::modify(ChannelNumber number, const Change& change) {
  Request& request = session_.at(number);
  // A change follows the earlier ones that are not answered yet.
  Stated changed = request.stated;
  for (const Asked& asked : asked_) {
    if (asked.number == number && asked.changed) changed = *asked.changed;
  }
  gcnp::Statement statement;
  if (const auto* publication = std::get_if<PublicationChange>(&change)) {
    apply(*publication, std::get<NamedPublication>(changed));
    statement = gcnp::to_statement(number, *publication);
  } else {
    apply(std::get<SubscriptionChange>(change), std::get<NamedSubscription>(changed));
    statement = gcnp::to_statement(number, std::get<SubscriptionChange>(change));
  }
  if (auto error = fault_of(statement)) return std::unexpected(std::move(*error));
  ++request.open_changes;
  if (is_up_) {
    ask(number, statement, std::move(changed), true);
  } else {
    request.stated = std::move(changed);
  }
  return {};
}

void Session::remove(ChannelNumber number) {
  const auto found = session_.find(number);
  if (found == session_.end()) return;
  const bool is_publication = std::holds_alternative<NamedPublication>(found->second.stated);
  const bool is_stated = is_up_ && found->second.state != State::refused;
  session_.erase(found);
  if (!is_stated) return;
  const auto remove = is_publication ? gcnp::Request(gcnp::PubRemove{}) : gcnp::Request(gcnp::SubRemove{});
  ask(number, gcnp::to_statement(number, remove), std::nullopt, true);
}

void Session::on_up() {
  is_up_ = true;
  for (const auto& [number, request] : session_) {
    if (request.state != State::refused) {
      ask(number, create_statement(number, request.stated), std::nullopt, false);
    }
  }
  if (asked_.empty()) return;
  asked_.back().has_ping = true;
  say_({0, "sys", "ping", {}});
}

void Session::on_down() {
  is_up_ = false;
  for (Asked& asked : asked_) {
    const auto found = session_.find(asked.number);
    if (found != session_.end() && asked.changed) found->second.stated = std::move(*asked.changed);
  }
  asked_.clear();
}

std::vector<Session::Settled> Session::on_pong() {
  std::vector<Settled> settled;
  bool is_last = asked_.empty();
  while (!is_last) {
    is_last = asked_.front().has_ping;
    Asked asked = std::move(asked_.front());
    asked_.pop_front();
    if (session_.contains(asked.number)) settled.push_back(settle(std::move(asked)));
    if (asked_.empty()) break;
  }
  return settled;
}

Session::Settled Session::settle(Asked asked) {
  Request& request = session_.at(asked.number);
  Settled settled{asked.number, asked.error, asked.changed.has_value(), true};
  if (settled.is_change) {
    --request.open_changes;
    request.last_change = asked.error;
    if (!asked.error) request.stated = std::move(*asked.changed);
    return settled;
  }
  if (asked.error) {
    // A request that this daemon cannot take now is stated to the next one.
    if (asked.error->code == ErrorCode::not_ready) return settled;
    request.state = State::refused;
    request.refusal = std::move(asked.error);
  } else {
    settled.is_news = request.state == State::asked || request.open_changes > 0;
    request.state = State::accepted;
    request.open_changes = 0;
    request.last_change.reset();
  }
  return settled;
}

std::optional<Session::Settled> Session::on_error(ChannelNumber number, const Error& error) {
  const auto asked =
      std::ranges::find_if(asked_, [number](const Asked& one) { return one.number == number && !one.error; });
  if (asked != asked_.end()) {
    asked->error = error;
    return std::nullopt;
  }
  const auto found = session_.find(number);
  if (found != session_.end() && error.code == ErrorCode::too_many) {
    found->second.state = State::refused;
    found->second.refusal = error;
  }
  return Settled{number, error, false, true};
}

const Session::Request* Session::find(ChannelNumber number) const {
  const auto found = session_.find(number);
  return found == session_.end() ? nullptr : &found->second;
}

}  // namespace geminga::client
