#include "client/cpp/blocking_session.hpp"

#include <cerrno>
#include <utility>

namespace geminga::client {

using Kind = ClientError::Kind;

std::expected<void, ClientError> BlockingSession::connect(const std::vector<Endpoint>& endpoints) {
  const auto deadline = deadline_after(timeout_);
  std::string tried;
  std::string reason;
  for (const auto& endpoint : endpoints) {
    where_ = to_string(endpoint);
    auto opened = DaemonConnection::open(endpoint);
    int error = opened ? 0 : opened.error();
    if (error == EINVAL || error == ENAMETOOLONG) {
      const std::string what = endpoint.path.empty() ? " has no IP address in numbers: write ADDRESS:PORT"
                                                     : " is too long for the path of a socket: use a shorter one";
      return std::unexpected(broken(Kind::wrong_use, where_ + what));
    }
    if (opened) {
      connection_ = std::move(*opened);
      if (!wait_until_ready(connection_->socket().get(), POLLOUT, deadline)) {
        return std::unexpected(
            broken(Kind::timed_out, "no connection to " + where_ + " in time: is the daemon stopped?"));
      }
      error = pending_error(connection_->socket());
    }
    if (error == 0) return {};
    reason = system_text(error);
    tried += (tried.empty() ? "" : " and ") + where_;
  }
  return std::unexpected(broken(Kind::unreachable, "no daemon at " + tried + " (" + reason +
                                                       "): start gemingad, or say where it is with GEMINGA_CONNECT"));
}

std::expected<gcnp::Statement, ClientError> BlockingSession::hello(const ClientOptions& options) {
  if (auto sent = send(hello_statement(options.name, options.room)); !sent) {
    return std::unexpected(std::move(sent.error()));
  }
  Wait wait{0, "hello", {}, {}};
  if (auto done = finish(wait); !done) return std::unexpected(std::move(done.error()));
  was_met_ = true;
  return std::move(wait.messages.back());
}

std::expected<void, ClientError> BlockingSession::request(const gcnp::Statement& statement) {
  if (auto sent = send(statement); !sent) return sent;
  // The daemon answers the ping after everything before it, so an error comes before the pong.
  if (auto sent = send({0, "sys", "ping", {}}); !sent) return sent;
  Wait wait{statement.id, "pong", {}, {}};
  if (auto done = finish(wait); !done) return done;
  if (wait.error) return std::unexpected(ClientError{Kind::refused, wait.error->text, wait.error->code});
  return {};
}

std::expected<std::vector<gcnp::Statement>, ClientError> BlockingSession::query(const gcnp::Statement& statement) {
  if (auto sent = send(statement); !sent) return std::unexpected(std::move(sent.error()));
  Wait wait{statement.id, "end", {}, {}};
  if (auto done = finish(wait); !done) return std::unexpected(std::move(done.error()));
  if (wait.error) return std::unexpected(ClientError{Kind::refused, wait.error->text, wait.error->code});
  return std::move(wait.messages);
}

std::expected<std::optional<Event>, ClientError> BlockingSession::next_event(Clock::time_point deadline) {
  while (events_.empty()) {
    if (broken_) return std::unexpected(*broken_);
    const auto read = read_lines(deadline, nullptr);
    if (events_.empty() && !read) {
      if (read.error().kind == Kind::timed_out) return std::nullopt;
      return std::unexpected(read.error());
    }
  }
  std::optional<Event> event = std::move(events_.front());
  events_.pop_front();
  return event;
}

std::uint32_t BlockingSession::next_number() {
  ++last_number_;
  if (last_number_ == 0) ++last_number_;  // 0 is the system's
  return last_number_;
}

std::expected<void, ClientError> BlockingSession::send(const gcnp::Statement& statement) {
  if (broken_) return std::unexpected(*broken_);
  const std::string line = gcnp::to_line(statement);
  const auto read_back = gcnp::parse(std::string_view(line).substr(0, line.size() - 2));
  if (!read_back) return std::unexpected(ClientError{Kind::wrong_use, read_back.error().error.text});
  if (*read_back != statement) {
    return std::unexpected(ClientError{Kind::wrong_use, "a kind, key or value has characters that GCNP cannot carry"});
  }
  connection_->put(statement);
  const auto deadline = deadline_after(timeout_);
  while (true) {
    if (const auto written = connection_->write(); !written) return std::unexpected(lost(written.error()));
    if (!connection_->has_unwritten()) return {};
    if (!wait_until_ready(connection_->socket().get(), POLLOUT, deadline)) {
      broken_ = no_answer();
      return std::unexpected(*broken_);
    }
  }
}

std::expected<void, ClientError> BlockingSession::finish(Wait& wait) {
  const auto deadline = deadline_after(timeout_);
  while (!wait.is_over) {
    if (auto read = read_lines(deadline, &wait); !read) {
      if (read.error().kind == Kind::timed_out) broken_ = read.error();
      return read;
    }
  }
  if (wait.error && wait.id == 0) broken_ = ClientError{Kind::refused, wait.error->text, wait.error->code};
  if (broken_) return std::unexpected(*broken_);
  return {};
}

std::expected<void, ClientError> BlockingSession::read_lines(Clock::time_point deadline, Wait* wait) {
  auto read = connection_->read();
  while (!read && read.error() == EAGAIN) {
    if (!wait_until_ready(connection_->socket().get(), POLLIN, deadline)) return std::unexpected(no_answer());
    read = connection_->read();
  }
  if (!read) return std::unexpected(lost(read.error()));
  while (auto reply = connection_->next()) {
    if (!*reply) {
      return std::unexpected(
          broken(was_met_ ? Kind::closed : Kind::unreachable, no_daemon_text(where_, reply->error())));
    }
    if (auto taken = take(std::move(**reply), wait); !taken) return taken;
  }
  return {};
}

std::expected<void, ClientError> BlockingSession::take(gcnp::Reply reply, Wait* wait) {
  if (auto* event = std::get_if<Event>(&reply)) {
    auto* error = std::get_if<Error>(&event->what);
    if (wait != nullptr && !wait->is_over && error != nullptr && (event->request == wait->id || event->request == 0)) {
      // A refused request is still followed by its pong; a refused hello or query is followed by nothing.
      wait->error = std::move(*error);
      wait->is_over = wait->last != "pong" || event->request == 0;
      if (event->request == 0) wait->id = 0;
      return {};
    }
    if (events_.size() == Client::max_waiting_events) {
      return std::unexpected(broken(Kind::closed, "events were not taken: call poll() or next_event() more often"));
    }
    events_.push_back(std::move(*event));
    return {};
  }
  auto& message = std::get<gcnp::Statement>(reply);
  // A newer daemon may send messages that no call waits for.
  if (wait == nullptr || wait->is_over || message.command != "msg") return {};
  const std::uint32_t id = wait->last == "end" ? wait->id : 0;
  if (message.id != id) return {};
  wait->is_over = message.subcommand == wait->last;
  wait->messages.push_back(std::move(message));
  return {};
}

ClientError BlockingSession::broken(Kind kind, std::string text) {
  broken_ = ClientError{kind, std::move(text)};
  return *broken_;
}

ClientError BlockingSession::lost(int error) {
  if (!was_met_)
    return broken(Kind::unreachable, "what listens at " + where_ + " closed the connection: is it gemingad?");
  const std::string reason = error == 0 ? "End of file" : system_text(error);
  return broken(Kind::closed, "the daemon at " + where_ + " is gone (" + reason + "): start it again");
}

ClientError BlockingSession::no_answer() const {
  return {Kind::timed_out, "no answer from " + where_ + " in time: is the daemon busy or stopped?"};
}

}  // namespace geminga::client
