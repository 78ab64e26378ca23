#include "client/channels/socket.hpp"

#include <arpa/inet.h>
#include <ifaddrs.h>
#include <net/if.h>
#include <netinet/tcp.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <system_error>

namespace geminga::client {
namespace {

/// Not in every libc: linux/in6.h.
constexpr int ipv6_multicast_all = 29;
/// Keep-alive of connections, in seconds: the silence before the first probe, the time between two, and their number.
constexpr int keep_alive_idle = 5;
constexpr int keep_alive_interval = 2;
constexpr int keep_alive_count = 3;
/// The time after which a connection is broken whose other end does not confirm what it was sent.
constexpr int unconfirmed_ms = 11'000;

/// The receive buffer for a burst of datagrams. The system gives less if its limit is less.
constexpr int wanted_receive_buffer = 4 * 1024 * 1024;

SocketError error_of(int number, const std::string& what) {
  return {number, what + ": " + std::generic_category().message(number)};
}

bool set(const Socket& socket, int level, int option, int value) {
  return ::setsockopt(socket.get(), level, option, &value, sizeof value) == 0;
}

/// Small messages leave at once, and a peer that is gone without a word is noticed.
void set_connection_options(const Socket& socket) {
  set(socket, IPPROTO_TCP, TCP_NODELAY, 1);
  set(socket, SOL_SOCKET, SO_KEEPALIVE, 1);
  set(socket, IPPROTO_TCP, TCP_KEEPIDLE, keep_alive_idle);
  set(socket, IPPROTO_TCP, TCP_KEEPINTVL, keep_alive_interval);
  set(socket, IPPROTO_TCP, TCP_KEEPCNT, keep_alive_count);
  set(socket, IPPROTO_TCP, TCP_USER_TIMEOUT, unconfirmed_ms);
}

std::expected<Socket, SocketError> open_bound(int type, int family, const Binding& binding) {
  Socket socket(::socket(family, type | SOCK_CLOEXEC | SOCK_NONBLOCK, 0), family);
  if (!socket.is_open()) return std::unexpected(error_of(errno, "no socket"));
  if (binding.is_shared || type == SOCK_STREAM) set(socket, SOL_SOCKET, SO_REUSEADDR, 1);
  PeerAddress at;
  at.port = binding.port;
  if (!binding.address.empty()) {
    const auto stated = peer_address(binding.address, binding.port);
    if (!stated) return std::unexpected(SocketError{EINVAL, binding.address + " is no address of this host"});
    at = *stated;
  } else if (family == AF_INET) {
    at = *peer_address("0.0.0.0", binding.port);
  }
  if (family == AF_INET6) set(socket, IPPROTO_IPV6, IPV6_V6ONLY, 0);
  const auto system = system_address(at, family);
  if (!system) return std::unexpected(SocketError{EAFNOSUPPORT, "this host does not speak IPv6"});
  if (::bind(socket.get(), system->get(), system->size) != 0) {
    return std::unexpected(error_of(
        errno, "port " + std::to_string(binding.port) + (binding.address.empty() ? "" : " of " + binding.address)));
  }
  return socket;
}

/// A socket for both families, or for IPv4 if the host has no IPv6.
std::expected<Socket, SocketError> open_any(int type, Binding binding) {
  auto socket = open_bound(type, AF_INET6, binding);
  if (!socket && (socket.error().number == EAFNOSUPPORT || socket.error().number == EADDRNOTAVAIL)) {
    if (auto four = open_bound(type, AF_INET, binding)) return four;
    // The address by which others reach this host need not be one of its own.
    if (!binding.address.empty() && socket.error().number == EADDRNOTAVAIL) {
      binding.address.clear();
      return open_any(type, binding);
    }
  }
  return socket;
}

bool join(const Socket& socket, const PeerAddress& group, unsigned interface) {
  if (group.is_ipv4()) {
    ip_mreqn request{};
    std::memcpy(&request.imr_multiaddr, group.octets.data() + 12, sizeof request.imr_multiaddr);
    request.imr_ifindex = static_cast<int>(interface);
    return ::setsockopt(socket.get(), IPPROTO_IP, IP_ADD_MEMBERSHIP, &request, sizeof request) == 0;
  }
  ipv6_mreq request{};
  std::memcpy(&request.ipv6mr_multiaddr, group.octets.data(), sizeof request.ipv6mr_multiaddr);
  request.ipv6mr_interface = interface;
  return ::setsockopt(socket.get(), IPPROTO_IPV6, IPV6_JOIN_GROUP, &request, sizeof request) == 0;
}

}  // namespace

void Socket::close() {
  if (number_ >= 0) ::close(std::exchange(number_, -1));
}

std::expected<Socket, SocketError> open_datagrams(const Binding& binding) {
  auto socket = open_any(SOCK_DGRAM, binding);
  if (!socket) return socket;
  set(*socket, SOL_SOCKET, SO_RCVBUF, wanted_receive_buffer);
  set(*socket, IPPROTO_IP, IP_MULTICAST_ALL, 0);
  set(*socket, IPPROTO_IPV6, ipv6_multicast_all, 0);
  set(*socket, IPPROTO_IP, IP_MULTICAST_TTL, 1);
  set(*socket, IPPROTO_IPV6, IPV6_MULTICAST_HOPS, 1);
  return socket;
}

std::expected<Socket, SocketError> open_listener(const Binding& binding) {
  auto socket = open_any(SOCK_STREAM, binding);
  if (socket && ::listen(socket->get(), SOMAXCONN) != 0) return std::unexpected(error_of(errno, "listen"));
  return socket;
}

std::expected<Socket, SocketError> open_connection(const PeerAddress& to) {
  const int family = to.is_ipv4() ? AF_INET : AF_INET6;
  Socket socket(::socket(family, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  if (!socket.is_open()) return std::unexpected(error_of(errno, "no socket"));
  set_connection_options(socket);
  const auto system = system_address(to, family);
  if (::connect(socket.get(), system->get(), system->size) != 0 && errno != EINPROGRESS) {
    return std::unexpected(error_of(errno, to_string(to)));
  }
  return socket;
}

std::expected<Socket, SocketError> open_group(const PeerAddress& group) {
  const int family = group.is_ipv4() ? AF_INET : AF_INET6;
  Socket socket(::socket(family, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  if (!socket.is_open()) return std::unexpected(error_of(errno, "no socket"));
  set(socket, SOL_SOCKET, SO_REUSEADDR, 1);
  set(socket, SOL_SOCKET, SO_RCVBUF, wanted_receive_buffer);
  set(socket, IPPROTO_IP, IP_MULTICAST_ALL, 0);
  if (family == AF_INET6) set(socket, IPPROTO_IPV6, ipv6_multicast_all, 0);
  // A link-local group on every interface has no single address to bind to. The sender is checked later anyway.
  PeerAddress at = group;
  if (family == AF_INET6 && group.zone == 0 && (group.octets[1] & 0x0f) == 2) at.octets = {};
  if (family == AF_INET6) set(socket, IPPROTO_IPV6, IPV6_V6ONLY, 1);
  const auto system = system_address(at, family);
  if (::bind(socket.get(), system->get(), system->size) != 0) {
    return std::unexpected(error_of(errno, "group " + to_string(group)));
  }
  if (const int error = join_group(socket, group); error != 0) {
    return std::unexpected(error_of(error, "group " + to_string(group)));
  }
  return socket;
}

int join_group(const Socket& socket, const PeerAddress& group) {
  bool has_joined = false;
  int error = ENODEV;
  for (const unsigned interface : multicast_interfaces(group.is_ipv4())) {
    if (group.zone != 0 && group.zone != interface) continue;
    // EADDRINUSE: it is joined on this interface already.
    if (join(socket, group, interface) || errno == EADDRINUSE) {
      has_joined = true;
    } else {
      error = errno;
    }
  }
  return has_joined ? 0 : error;
}

std::uint16_t port_of(const Socket& socket) {
  sockaddr_storage own{};
  socklen_t size = sizeof own;
  if (::getsockname(socket.get(), reinterpret_cast<sockaddr*>(&own), &size) != 0) return 0;
  return peer_address(own).port;
}

PeerAddress peer_of(const Socket& socket) {
  sockaddr_storage other{};
  socklen_t size = sizeof other;
  if (::getpeername(socket.get(), reinterpret_cast<sockaddr*>(&other), &size) != 0) return {};
  return peer_address(other);
}

int pending_error(const Socket& socket) {
  int error = 0;
  socklen_t size = sizeof error;
  return ::getsockopt(socket.get(), SOL_SOCKET, SO_ERROR, &error, &size) == 0 ? error : errno;
}

std::optional<std::size_t> write_some(const Socket& socket, std::span<iovec> parts) {
  msghdr message{};
  message.msg_iov = parts.data();
  message.msg_iovlen = parts.size();
  while (true) {
    const auto count = ::sendmsg(socket.get(), &message, MSG_NOSIGNAL);
    if (count >= 0) return static_cast<std::size_t>(count);
    if (errno == EAGAIN) return 0;
    if (errno != EINTR) return std::nullopt;
  }
}

std::optional<Socket> accept(const Socket& listener) {
  Socket socket(::accept4(listener.get(), nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK));
  if (!socket.is_open()) return std::nullopt;
  set_connection_options(socket);
  return socket;
}

std::vector<unsigned> multicast_interfaces(bool is_ipv4) {
  std::vector<unsigned> others;
  std::vector<unsigned> loopbacks;
  ifaddrs* list = nullptr;
  if (::getifaddrs(&list) != 0) return {};
  for (const ifaddrs* one = list; one != nullptr; one = one->ifa_next) {
    if (one->ifa_addr == nullptr || (one->ifa_flags & IFF_UP) == 0) continue;
    if (one->ifa_addr->sa_family != (is_ipv4 ? AF_INET : AF_INET6)) continue;
    const unsigned number = ::if_nametoindex(one->ifa_name);
    auto& interfaces = (one->ifa_flags & IFF_LOOPBACK) != 0 ? loopbacks : others;
    if (number != 0 && std::ranges::find(interfaces, number) == interfaces.end()) interfaces.push_back(number);
  }
  ::freeifaddrs(list);
  return others.empty() ? loopbacks : others;
}

int send_datagram(const Socket& socket, const PeerAddress& to, std::span<const iovec> parts, unsigned interface) {
  auto system = system_address(to, socket.family());
  if (!system) return EAFNOSUPPORT;
  if (parts.size() == 1 && interface == 0) {  // cheaper than a message with all that it may have
    const iovec& one = parts.front();
    return ::sendto(socket.get(), one.iov_base, one.iov_len, MSG_NOSIGNAL, system->get(), system->size) < 0 ? errno : 0;
  }
  msghdr message{};
  message.msg_name = &system->storage;
  message.msg_namelen = system->size;
  message.msg_iov = const_cast<iovec*>(parts.data());
  message.msg_iovlen = parts.size();
  alignas(cmsghdr) char control[CMSG_SPACE(sizeof(in6_pktinfo))]{};
  if (interface != 0) {
    message.msg_control = control;
    // A mapped address leaves through the IPv4 half of the socket, which takes IPv4's own options.
    const bool is_four = to.is_ipv4();
    message.msg_controllen = is_four ? CMSG_SPACE(sizeof(in_pktinfo)) : CMSG_SPACE(sizeof(in6_pktinfo));
    cmsghdr* header = CMSG_FIRSTHDR(&message);
    if (is_four) {
      in_pktinfo info{};
      info.ipi_ifindex = static_cast<int>(interface);
      header->cmsg_level = IPPROTO_IP;
      header->cmsg_type = IP_PKTINFO;
      header->cmsg_len = CMSG_LEN(sizeof info);
      std::memcpy(CMSG_DATA(header), &info, sizeof info);
    } else {
      in6_pktinfo info{};
      info.ipi6_ifindex = interface;
      header->cmsg_level = IPPROTO_IPV6;
      header->cmsg_type = IPV6_PKTINFO;
      header->cmsg_len = CMSG_LEN(sizeof info);
      std::memcpy(CMSG_DATA(header), &info, sizeof info);
    }
  }
  return ::sendmsg(socket.get(), &message, MSG_NOSIGNAL) < 0 ? errno : 0;
}

}  // namespace geminga::client
