#include "env/asio/given_socket.hpp"

#include <netinet/in.h>
#include <sys/socket.h>

#include <boost/asio/generic/stream_protocol.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/local/stream_protocol.hpp>
#include <cstring>

#include "env/asio/endpoint.hpp"

namespace geminga::env {
namespace {

namespace net = boost::asio;

int option_of(int descriptor, int name) {
  int value = -1;
  socklen_t size = sizeof value;
  return ::getsockopt(descriptor, SOL_SOCKET, name, &value, &size) == 0 ? value : -1;
}

/// The same octets as an address of one protocol.
template <typename Specific>
Specific as(const net::generic::stream_protocol::endpoint& endpoint) {
  Specific specific;
  specific.resize(endpoint.size());
  std::memcpy(specific.data(), endpoint.data(), endpoint.size());
  return specific;
}

}  // namespace

std::expected<GivenSocket, std::string> inspect_given_socket(int descriptor) {
  if (option_of(descriptor, SO_TYPE) != SOCK_STREAM || option_of(descriptor, SO_ACCEPTCONN) != 1)
    return std::unexpected("is no listening stream socket");
  net::generic::stream_protocol::endpoint endpoint;
  auto size = static_cast<socklen_t>(endpoint.capacity());
  if (::getsockname(descriptor, endpoint.data(), &size) != 0) return std::unexpected("has no address");
  endpoint.resize(size);
  const int family = endpoint.protocol().family();
  if (family == AF_UNIX) return GivenSocket{family, 0, as<net::local::stream_protocol::endpoint>(endpoint).path()};
  if (family != AF_INET && family != AF_INET6) return std::unexpected("is neither a TCP nor a Unix socket");
  const auto address = as<net::ip::tcp::endpoint>(endpoint);
  const std::string place = to_string(Endpoint{address.address().to_string(), address.port()});
  if (!address.address().is_loopback())
    return std::unexpected("listens on " + place + ", which other hosts can reach: give it a loopback address");
  return GivenSocket{family, IPPROTO_TCP, place};
}

}  // namespace geminga::env
