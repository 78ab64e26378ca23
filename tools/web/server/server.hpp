// All connections of all doors.
#ifndef GEMINGA_WEB_SERVER_SERVER_HPP
#define GEMINGA_WEB_SERVER_SERVER_HPP

#include <boost/asio/io_context.hpp>
#include <cstddef>
#include <cstdint>
#include <expected>
#include <map>
#include <memory>
#include <string>

#include "env/asio/doors.hpp"
#include "env/asio/endpoint.hpp"
#include "web/server/connection.hpp"
#include "web/server/limits.hpp"
#include "web/site/site.hpp"

namespace geminga::web {

/// Serves on the context's one thread. Neither copies nor moves; site and context must outlive it, and the context must
/// not run after it.
class Server {
 public:
  Server(boost::asio::io_context& context, Site& site, Limits limits = {});
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  /// Binds and listens. The error is one line that says what to do.
  [[nodiscard]] std::expected<void, std::string> listen(const env::Endpoint& endpoint);
  /// The same at a path, for its user and group.
  [[nodiscard]] std::expected<void, std::string> listen(const std::string& path);
  /// Takes the readers that connect, from here on.
  void serve();

  [[nodiscard]] std::size_t connection_count() const { return connections_.size(); }
  [[nodiscard]] std::size_t stream_count() const { return streams_; }

 private:
  void take(Connection::Socket socket);
  /// Closes the connection that has waited longest for a request. False: each is being answered.
  bool drop_longest_waiting();
  void turn_away(Connection::Socket socket);

  Site& site_;
  Limits limits_;
  std::shared_ptr<env::Doors> doors_;                                 ///< shared with the handlers that it posts
  std::map<std::uint64_t, std::shared_ptr<Connection>> connections_;  ///< shared with their operations
  std::uint64_t last_ = 0;
  std::size_t streams_ = 0;
};

}  // namespace geminga::web

#endif
