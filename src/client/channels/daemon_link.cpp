#include "client/channels/daemon_link.hpp"

#include <cerrno>
#include <utility>

namespace geminga::client {
namespace {

/// The time that a daemon has to read the lines before the goodbye.
constexpr std::chrono::seconds goodbye_patience{3};

}  // namespace

DaemonLink::DaemonLink(Reactor& reactor, Options options, Told told)
    : reactor_(reactor),
      options_(std::move(options)),
      told_(std::move(told)),
      timer_(reactor,
             [this] {
               if (state_ == State::waiting) return connect();
               fail("no answer from " + to_string(options_.endpoints[endpoint_]) + " in time");
             }),
      chance_(std::random_device()()) {}

void DaemonLink::start() {
  endpoint_ = 0;
  connect();
}

void DaemonLink::stop() {
  state_ = State::stopped;
  timer_.set(base::never);
  watch_.stop();
  connection_.reset();
}

void DaemonLink::connect() {
  state_ = State::connecting;
  auto connection = DaemonConnection::open(options_.endpoints[endpoint_]);
  if (!connection) return fail(system_text(connection.error()));
  connection_ = std::move(*connection);
  watch_ = reactor_.watch(connection_->socket(), [this](Reactor::Ready ready) { on_ready(ready); });
  watch_.want(false, true);
  timer_.set(reactor_.now() + options_.timeout);
}

void DaemonLink::on_ready(Reactor::Ready ready) {
  if (state_ == State::connecting) {
    if (!ready.can_write) return;
    if (const int error = pending_error(connection_->socket()); error != 0) return fail(system_text(error));
    return greet();
  }
  if (ready.can_write && connection_->has_unwritten()) write();
  if (ready.can_read && connection_) read();
}

void DaemonLink::greet() {
  state_ = State::greeting;
  connection_->put(hello_statement(options_.name, options_.room, options_.asks_for_keys));
  watch_.want(true, false);
  write();
}

void DaemonLink::say(const gcnp::Statement& statement) {
  if (state_ != State::up || is_leaving_) return;
  const bool was_waiting = connection_->has_unwritten();
  connection_->put(statement);
  if (!was_waiting) write();
}

void DaemonLink::leave() {
  if (state_ != State::up || is_leaving_) return;
  say({0, "sys", "bye", {}});
  is_leaving_ = true;
  timer_.set(reactor_.now() + goodbye_patience);
  end_if_leaving();
}

void DaemonLink::end_if_leaving() {
  if (is_leaving_ && !connection_->has_unwritten()) connection_->finish();
}

void DaemonLink::write() {
  // After an error, what there is to be read says more about the end than the error does.
  [[maybe_unused]] const auto written = connection_->write();
  watch_.want(true, connection_->has_unwritten());
  end_if_leaving();
}

void DaemonLink::read() {
  if (const auto read = connection_->read(); !read) {
    if (read.error() == EAGAIN) return;
    return fail(read.error() == 0 ? "the daemon closed the connection" : system_text(read.error()));
  }
  while (connection_) {
    auto reply = connection_->next();
    if (!reply) return;
    take(std::move(*reply));
  }
}

void DaemonLink::take(std::expected<gcnp::Reply, Error> reply) {
  if (!reply) {
    const std::string text = no_daemon_text(to_string(options_.endpoints[endpoint_]), reply.error());
    if (state_ == State::greeting) told_.refused(text);
    return fail(text);
  }
  if (state_ == State::up) return told_.reply(std::move(*reply));
  if (const auto* event = std::get_if<Event>(&*reply)) {
    if (const auto* error = std::get_if<Error>(&event->what)) {
      told_.refused(error->text);
      fail(error->text);
    }
    return;
  }
  const auto& message = std::get<gcnp::Statement>(*reply);
  if (message.command != "msg" || message.subcommand != "hello") return;
  state_ = State::up;
  has_failed_ = false;
  backoff_.reset();
  timer_.set(base::never);
  told_.up(message);
}

std::string DaemonLink::all_endpoints() const {
  std::string all;
  for (const Endpoint& endpoint : options_.endpoints) all += (all.empty() ? "" : " and ") + to_string(endpoint);
  return all;
}

void DaemonLink::fail(const std::string& reason) {
  const bool was_up = state_ == State::up;
  const std::string gone = where();
  stop();
  has_failed_ = true;
  state_ = State::waiting;
  // The next endpoint is tried at once.
  if (!was_up && ++endpoint_ < options_.endpoints.size()) {
    timer_.set(reactor_.now());
  } else {
    endpoint_ = 0;
    timer_.set(reactor_.now() + backoff_.next(chance_()));
    told_.missing(was_up ? gone : all_endpoints(), reason);
  }
  if (was_up) told_.down(reason);
}

}  // namespace geminga::client
