// The listening sockets that clients connect to: on loopback addresses, and on a path.
#ifndef GEMINGA_ENV_ASIO_DOORS_HPP
#define GEMINGA_ENV_ASIO_DOORS_HPP

#include <boost/asio/basic_socket_acceptor.hpp>
#include <boost/asio/generic/stream_protocol.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>
#include <expected>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "env/asio/endpoint.hpp"
#include "env/asio/socket_file.hpp"

namespace geminga::env {

/// The reason why a GCNP address cannot be listened on.
struct ListenError {
  enum class Cause { in_use, not_available, other } cause = Cause::other;
  std::string text;  ///< the system's own words
};

/// Accepts on all sockets alike. Not thread-safe. The handlers that it posts hold it, so it lives as long as they do.
class Doors : public std::enable_shared_from_this<Doors> {
 public:
  using Socket = boost::asio::generic::stream_protocol::socket;
  /// Takes each client that connects.
  using Take = std::function<void(Socket)>;

  explicit Doors(boost::asio::io_context& context) : context_(context) {}

  /// Accepts on a listening socket that a supervisor has made, and owns it then. Gives its address or path. Later calls
  /// of listen() with that address or path do nothing. The error is one line: it is no listening stream socket, or one
  /// that hosts other than this one can reach.
  [[nodiscard]] std::expected<std::string, std::string> adopt(int descriptor);
  /// Binds and listens. Clients wait in the backlog until serve().
  [[nodiscard]] std::expected<void, ListenError> listen(const Endpoint& endpoint);
  /// Listens at a path. The error is one line that says what to do.
  [[nodiscard]] std::expected<void, std::string> listen(const std::string& path);
  void serve(Take take);
  /// Stops accepting, removes the path, and forgets the function that takes clients.
  void close();

 private:
  using Acceptor = boost::asio::basic_socket_acceptor<boost::asio::generic::stream_protocol>;
  struct Door {
    Acceptor acceptor;
    boost::asio::steady_timer retry;
  };

  [[nodiscard]] bool has_adopted(const std::string& place) const;
  void accept(std::size_t number);
  void accept_later(std::size_t number);

  boost::asio::io_context& context_;
  std::vector<Door> doors_;
  std::vector<SocketFile> files_;
  std::vector<std::string> adopted_;  ///< the addresses and paths of sockets that a supervisor has made
  Take take_;
};

}  // namespace geminga::env

#endif
