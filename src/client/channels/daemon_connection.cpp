#include "client/channels/daemon_connection.hpp"

#include <sys/un.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

#include "discovery/gcnp/request.hpp"

namespace geminga::client {

std::expected<DaemonConnection, int> DaemonConnection::open(const Endpoint& endpoint) {
  if (endpoint.path.empty()) {
    const auto to = peer_address(endpoint.address, endpoint.port);
    if (!to) return std::unexpected(EINVAL);
    auto socket = open_connection(*to);
    if (!socket) return std::unexpected(socket.error().number);
    return DaemonConnection(std::move(*socket));
  }
  sockaddr_un at{};
  at.sun_family = AF_UNIX;
  if (endpoint.path.size() >= sizeof at.sun_path) return std::unexpected(ENAMETOOLONG);
  std::memcpy(at.sun_path, endpoint.path.data(), endpoint.path.size());
  Socket socket(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  if (!socket.is_open()) return std::unexpected(errno);
  if (::connect(socket.get(), reinterpret_cast<const sockaddr*>(&at), sizeof at) != 0) return std::unexpected(errno);
  return DaemonConnection(std::move(socket));
}

std::expected<void, int> DaemonConnection::write() {
  std::size_t written = 0;
  while (written < unwritten_.size()) {
    const auto count = ::send(socket_.get(), unwritten_.data() + written, unwritten_.size() - written, MSG_NOSIGNAL);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0 && errno == EAGAIN) break;
    if (count < 0) {
      const int error = errno;
      unwritten_.clear();
      return std::unexpected(error);
    }
    written += static_cast<std::size_t>(count);
  }
  unwritten_.erase(0, written);
  return {};
}

void DaemonConnection::finish() { ::shutdown(socket_.get(), SHUT_WR); }

std::expected<void, int> DaemonConnection::read() {
  std::array<char, 64 * 1024> bytes;
  const auto count = ::recv(socket_.get(), bytes.data(), bytes.size(), 0);
  if (count < 0) return std::unexpected(errno == EINTR ? EAGAIN : errno);
  if (count == 0) return std::unexpected(0);
  reader_.feed({bytes.data(), static_cast<std::size_t>(count)});
  return {};
}

std::optional<std::expected<gcnp::Reply, Error>> DaemonConnection::next() {
  const auto line = reader_.next();
  if (!line) return std::nullopt;
  if (line->is_too_long) return std::unexpected(gcnp::line_too_long());
  return gcnp::read_reply(line->text);
}

gcnp::Statement hello_statement(const std::string& name, std::uint32_t room, bool asks_for_keys) {
  gcnp::Hello hello;
  if (!name.empty()) hello.name = name;
  if (room > 0) hello.room = room;
  if (asks_for_keys) hello.keys = true;
  return gcnp::to_statement(0, hello);
}

std::string no_daemon_text(const std::string& where, const Error& error) {
  return "what listens at " + where + " does not speak GCNP: " + error.text;
}

std::string system_text(int number) { return std::generic_category().message(number); }

}  // namespace geminga::client
