#include "system/stranger.hpp"

#include <arpa/inet.h>
#include <net/if.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>

namespace geminga::system {
namespace {

sockaddr_in endpoint(const std::string& address, std::uint16_t port) {
  sockaddr_in made{};
  made.sin_family = AF_INET;
  made.sin_port = htons(port);
  ::inet_pton(AF_INET, address.c_str(), &made.sin_addr);
  return made;
}

const sockaddr* plain(const sockaddr_in& address) { return reinterpret_cast<const sockaddr*>(&address); }

}  // namespace

Stranger::Stranger(const Lab& lab, std::size_t host, const std::string& source)
    : group_(endpoint("239.192.47.17", lab.udp_port())) {
  lab.visit(host, [&] {
    ip_mreqn interface{};
    interface.imr_ifindex = static_cast<int>(::if_nametoindex(lab.interface_of(host).c_str()));
    socket_ = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
    ::setsockopt(socket_, IPPROTO_IP, IP_MULTICAST_IF, &interface, sizeof interface);
    sockaddr_in own = endpoint(source.empty() ? lab.address_of(host) : source, 0);
    if (::bind(socket_, plain(own), sizeof own) != 0) throw std::system_error(errno, std::generic_category(), "bind");
    socklen_t size = sizeof own;
    ::getsockname(socket_, reinterpret_cast<sockaddr*>(&own), &size);
    own_port_ = own.sin_port;

    ear_ = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
    const int on = 1;
    ::setsockopt(ear_, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
    if (::bind(ear_, plain(group_), sizeof group_) != 0)
      throw std::system_error(errno, std::generic_category(), "bind");
    interface.imr_multiaddr = group_.sin_addr;
    ::setsockopt(ear_, IPPROTO_IP, IP_ADD_MEMBERSHIP, &interface, sizeof interface);
  });
}

Stranger::~Stranger() {
  ::close(socket_);
  ::close(ear_);
}

bool Stranger::send(const std::string& bytes) const {
  return ::sendto(socket_, bytes.data(), bytes.size(), 0, plain(group_), sizeof group_) ==
         static_cast<ssize_t>(bytes.size());
}

bool Stranger::send_to(const std::string& address, std::uint16_t port, const std::string& bytes) const {
  const sockaddr_in target = endpoint(address, port);
  return ::sendto(socket_, bytes.data(), bytes.size(), 0, plain(target), sizeof target) ==
         static_cast<ssize_t>(bytes.size());
}

std::optional<std::string> Stranger::hear() const {
  constexpr int moment_ms = 10;
  for (;;) {
    pollfd ready{.fd = ear_, .events = POLLIN, .revents = 0};
    if (::poll(&ready, 1, moment_ms) <= 0) return std::nullopt;
    std::array<char, 2048> buffer;
    sockaddr_in from{};
    socklen_t size = sizeof from;
    const ssize_t got =
        ::recvfrom(ear_, buffer.data(), buffer.size(), MSG_DONTWAIT, reinterpret_cast<sockaddr*>(&from), &size);
    if (got < 0) return std::nullopt;
    if (from.sin_port != own_port_) return std::string(buffer.data(), static_cast<std::size_t>(got));
  }
}

}  // namespace geminga::system
