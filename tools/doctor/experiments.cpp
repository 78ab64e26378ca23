#include "doctor/experiments.hpp"

#include <arpa/inet.h>
#include <net/if.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>

namespace geminga::doctor {
namespace {

struct Descriptor {
  explicit Descriptor(int family) : number(::socket(family, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0)) {}
  ~Descriptor() {
    if (number >= 0) ::close(number);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  const int number;
};

/// A socket address of either family, of a numeric address without scope.
struct Target {
  sockaddr_storage storage{};
  socklen_t size = 0;

  Target(const std::string& address, std::uint16_t port, unsigned scope) {
    auto& v4 = reinterpret_cast<sockaddr_in&>(storage);
    auto& v6 = reinterpret_cast<sockaddr_in6&>(storage);
    if (::inet_pton(AF_INET, address.c_str(), &v4.sin_addr) == 1) {
      v4.sin_family = AF_INET;
      v4.sin_port = htons(port);
      size = sizeof v4;
    } else if (::inet_pton(AF_INET6, address.c_str(), &v6.sin6_addr) == 1) {
      v6.sin6_family = AF_INET6;
      v6.sin6_port = htons(port);
      v6.sin6_scope_id = scope;
      size = sizeof v6;
    }
  }
  [[nodiscard]] const sockaddr* get() const { return reinterpret_cast<const sockaddr*>(&storage); }
};

bool set_int(int socket, int level, int option, int value) {
  return ::setsockopt(socket, level, option, &value, sizeof value) == 0;
}

}  // namespace

Sending try_to_send(const Crossing& out) {
  const unsigned index = ::if_nametoindex(out.interface.c_str());
  const Target target(out.group, out.port, index);
  if (index == 0 || target.size == 0) return Sending::leaves;
  const Descriptor socket(out.is_ipv6() ? AF_INET6 : AF_INET);
  if (socket.number < 0) return Sending::leaves;
  bool is_aimed = false;
  if (out.is_ipv6()) {
    is_aimed = set_int(socket.number, IPPROTO_IPV6, IPV6_MULTICAST_IF, static_cast<int>(index)) &&
               set_int(socket.number, IPPROTO_IPV6, IPV6_MULTICAST_HOPS, 0) &&
               set_int(socket.number, IPPROTO_IPV6, IPV6_MULTICAST_LOOP, 0);
  } else {
    ip_mreqn interface{};
    interface.imr_ifindex = static_cast<int>(index);
    is_aimed = ::setsockopt(socket.number, IPPROTO_IP, IP_MULTICAST_IF, &interface, sizeof interface) == 0 &&
               set_int(socket.number, IPPROTO_IP, IP_MULTICAST_TTL, 0) &&
               set_int(socket.number, IPPROTO_IP, IP_MULTICAST_LOOP, 0);
  }
  if (!is_aimed) return Sending::leaves;
  const bool is_sent = ::sendto(socket.number, "", 0, MSG_DONTWAIT | MSG_NOSIGNAL, target.get(), target.size) >= 0;
  if (is_sent) return Sending::leaves;
  if (errno == EPERM) return Sending::refused;  // netfilter's word for a datagram that a rule drops
  // The words for no route, and for a route or a policy of `unreachable`, `prohibit` and `blackhole`.
  const bool has_no_route = errno == ENETUNREACH || errno == EHOSTUNREACH || errno == EACCES || errno == EINVAL;
  return has_no_route ? Sending::no_route : Sending::leaves;
}

bool has_route(const std::string& address) {
  const Target target(address, 9, 0);
  if (target.size == 0) return true;
  const auto& v6 = reinterpret_cast<const sockaddr_in6&>(target.storage);
  if (target.storage.ss_family == AF_INET6 && IN6_IS_ADDR_LINKLOCAL(&v6.sin6_addr)) return true;  // its link is unknown
  const Descriptor socket(target.storage.ss_family);
  if (socket.number < 0 || ::connect(socket.number, target.get(), target.size) == 0) return true;
  return errno != ENETUNREACH && errno != EHOSTUNREACH && errno != EACCES;
}

}  // namespace geminga::doctor
