#include "client/channels/daemon_link.hpp"

#include <sys/un.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <expected>
#include <system_error>
#include <utility>

#include "discovery/gcnp/request.hpp"

namespace geminga::client {
namespace {

/// How long a daemon may take to read what was said before the goodbye.
constexpr std::chrono::seconds goodbye_patience{3};

std::string words_of(int number) { return std::generic_category().message(number); }

/// On its way there, or the system's error number.
std::expected<Socket, int> open_stream(const Endpoint& endpoint) {
  if (endpoint.path.empty()) {
    const auto to = peer_address(endpoint.address, endpoint.port);
    if (!to) return std::unexpected(EINVAL);
    auto socket = open_connection(*to);
    if (!socket) return std::unexpected(socket.error().number);
    return std::move(*socket);
  }
  sockaddr_un at{};
  at.sun_family = AF_UNIX;
  if (endpoint.path.size() >= sizeof at.sun_path) return std::unexpected(ENAMETOOLONG);
  std::memcpy(at.sun_path, endpoint.path.data(), endpoint.path.size());
  Socket socket(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  if (!socket.is_open()) return std::unexpected(errno);
  if (::connect(socket.get(), reinterpret_cast<const sockaddr*>(&at), sizeof at) != 0) return std::unexpected(errno);
  return socket;
}

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
  socket_.close();
  out_.clear();
}

void DaemonLink::connect() {
  state_ = State::connecting;
  auto socket = open_stream(options_.endpoints[endpoint_]);
  if (!socket) return fail(words_of(socket.error()));
  socket_ = std::move(*socket);
  watch_ = reactor_.watch(socket_, [this](Reactor::Ready ready) { on_ready(ready); });
  watch_.want(false, true);
  timer_.set(reactor_.now() + options_.timeout);
}

void DaemonLink::on_ready(Reactor::Ready ready) {
  if (state_ == State::connecting) {
    if (!ready.can_write) return;
    if (const int error = pending_error(socket_); error != 0) return fail(words_of(error));
    return greet();
  }
  if (ready.can_write && !out_.empty()) write();
  if (ready.can_read && socket_.is_open()) read();
}

void DaemonLink::greet() {
  state_ = State::greeting;
  reader_ = gcnp::LineReader();
  gcnp::Hello hello;
  if (!options_.name.empty()) hello.name = options_.name;
  if (options_.room > 0) hello.room = options_.room;
  out_ = gcnp::to_line(gcnp::to_statement(0, hello));
  watch_.want(true, false);
  write();
}

void DaemonLink::say(const gcnp::Statement& statement) {
  if (state_ != State::up || is_leaving_) return;
  const bool was_empty = out_.empty();
  out_ += gcnp::to_line(statement);
  if (was_empty) write();
}

void DaemonLink::leave() {
  if (state_ != State::up || is_leaving_) return;
  say({0, "sys", "bye", {}});
  is_leaving_ = true;
  timer_.set(reactor_.now() + goodbye_patience);
  end_if_leaving();
}

void DaemonLink::end_if_leaving() {
  if (is_leaving_ && out_.empty()) ::shutdown(socket_.get(), SHUT_WR);
}

void DaemonLink::write() {
  std::size_t written = 0;
  while (written < out_.size()) {
    const auto count = ::send(socket_.get(), out_.data() + written, out_.size() - written, MSG_NOSIGNAL);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0 && errno != EAGAIN) {
      out_.clear();  // what there is to be read says more about the end than this
      break;
    }
    if (count < 0) break;
    written += static_cast<std::size_t>(count);
  }
  out_.erase(0, written);
  watch_.want(true, !out_.empty());
  end_if_leaving();
}

void DaemonLink::read() {
  std::array<char, 64 * 1024> bytes;
  const auto count = ::recv(socket_.get(), bytes.data(), bytes.size(), 0);
  if (count < 0 && (errno == EAGAIN || errno == EINTR)) return;
  if (count <= 0) return fail(count == 0 ? "the daemon closed the connection" : words_of(errno));
  reader_.feed({bytes.data(), static_cast<std::size_t>(count)});
  while (const auto line = reader_.next()) {
    take_line(*line);
    if (state_ != State::greeting && state_ != State::up) return;
  }
}

void DaemonLink::take_line(const gcnp::LineReader::Line& line) {
  auto reply = line.is_too_long ? std::unexpected(gcnp::line_too_long()) : gcnp::read_reply(line.text);
  if (!reply) {
    const std::string where = to_string(options_.endpoints[endpoint_]);
    const std::string text = "what listens at " + where + " does not speak GCNP: " + reply.error().text;
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

void DaemonLink::fail(const std::string& reason) {
  const bool was_up = state_ == State::up;
  stop();
  has_failed_ = true;
  state_ = State::waiting;
  // The next place is tried at once, as long as there is one.
  if (!was_up && ++endpoint_ < options_.endpoints.size()) {
    timer_.set(reactor_.now());
  } else {
    endpoint_ = 0;
    timer_.set(reactor_.now() + backoff_.next(chance_()));
  }
  if (was_up) told_.down(reason);
}

}  // namespace geminga::client
