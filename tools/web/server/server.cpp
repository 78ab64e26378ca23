#include "web/server/server.hpp"

#include <sys/socket.h>

#include <algorithm>
#include <boost/asio/ip/tcp.hpp>
#include <string_view>
#include <utility>

namespace geminga::web {
namespace {

/// The response where there is no room, which a fresh socket takes at once.
constexpr std::string_view no_room =
    "HTTP/1.1 503 Service Unavailable\r\nContent-Type: application/json\r\nConnection: close\r\nRetry-After: 1\r\n"
    "Content-Length: 66\r\n\r\n{\"error\":\"there are as many connections as may be: try it later\"}\n";

}  // namespace

Server::Server(boost::asio::io_context& context, Site& site, Limits limits)
    : site_(site), limits_(limits), doors_(std::make_shared<env::Doors>(context)) {}

Server::~Server() {
  doors_->close();
  for (const auto& [number, connection] : connections_) connection->close();
}

std::expected<void, std::string> Server::listen(const env::Endpoint& endpoint) {
  const auto listening = doors_->listen(endpoint);
  if (listening) return {};
  const std::string advice = listening.error().cause == env::ListenError::Cause::in_use
                                 ? "is another geminga-web running? choose another port with --listen"
                                 : "choose another address with --listen";
  return std::unexpected("cannot listen on " + env::to_string(endpoint) + " (" + listening.error().text +
                         "): " + advice);
}

std::expected<void, std::string> Server::listen(const std::string& path) { return doors_->listen(path); }

void Server::serve() {
  doors_->serve([this](Connection::Socket socket) { take(std::move(socket)); });
}

void Server::take(Connection::Socket socket) {
  if (connections_.size() >= limits_.connections && !drop_longest_waiting()) return turn_away(std::move(socket));
  boost::system::error_code ignored;
  socket.set_option(boost::asio::ip::tcp::no_delay(true), ignored);  // a Unix socket has no such option and needs none
  const std::uint64_t number = ++last_;
  const auto connection =
      std::make_shared<Connection>(std::move(socket), site_, limits_,
                                   Connection::Owner{.takes_stream =
                                                         [this] {
                                                           if (streams_ >= limits_.streams) return false;
                                                           ++streams_;
                                                           return true;
                                                         },
                                                     .stream_ended = [this] { --streams_; },
                                                     .ended = [this, number] { connections_.erase(number); }});
  connections_.emplace(number, connection);
  connection->start();
}

bool Server::drop_longest_waiting() {
  auto longest = connections_.end();
  for (auto one = connections_.begin(); one != connections_.end(); ++one) {
    if (!one->second->is_waiting()) continue;
    if (longest == connections_.end() || one->second->since() < longest->second->since()) longest = one;
  }
  if (longest == connections_.end()) return false;
  longest->second->close();
  connections_.erase(longest);
  return true;
}

void Server::turn_away(Connection::Socket socket) {
  site_.count(503);
  ::send(socket.native_handle(), no_room.data(), no_room.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
}

}  // namespace geminga::web
