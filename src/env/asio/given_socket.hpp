// Listening sockets that a supervisor has made and gives to the daemon.
#ifndef GEMINGA_ENV_ASIO_GIVEN_SOCKET_HPP
#define GEMINGA_ENV_ASIO_GIVEN_SOCKET_HPP

#include <expected>
#include <string>

namespace geminga::env {

struct GivenSocket {
  int family = 0;
  int protocol = 0;
  std::string place;  ///< its address and port as endpoint.hpp writes them, or its path
};

/// Finds out where a given socket listens. The error is half a sentence: it is no listening stream socket, or one that
/// other hosts can reach, since over TCP every program that connects may publish.
[[nodiscard]] std::expected<GivenSocket, std::string> inspect_given_socket(int descriptor);

}  // namespace geminga::env

#endif
