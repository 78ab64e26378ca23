#include "doctor/listening.hpp"

#include <arpa/inet.h>
#include <net/if.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

namespace geminga::doctor {
namespace {

/// A group at a port on one interface.
struct Ear {
  std::string interface;
  std::string group;
  std::uint16_t port = 0;
};

bool set(int socket, int level, int option, const auto& value) {
  return ::setsockopt(socket, level, option, &value, sizeof value) == 0;
}

/// Whether the socket hears that group at that port on that interface alone.
bool attend(int socket, const Ear& ear) {
  const unsigned index = ::if_nametoindex(ear.interface.c_str());
  if (index == 0 || !set(socket, SOL_SOCKET, SO_REUSEADDR, 1)) return false;
  sockaddr_in v4{};
  if (::inet_pton(AF_INET, ear.group.c_str(), &v4.sin_addr) == 1) {
    v4.sin_family = AF_INET;
    v4.sin_port = htons(ear.port);
    ip_mreqn membership{};
    membership.imr_multiaddr = v4.sin_addr;
    membership.imr_ifindex = static_cast<int>(index);
    return set(socket, IPPROTO_IP, IP_MULTICAST_ALL, 0) &&
           ::bind(socket, reinterpret_cast<const sockaddr*>(&v4), sizeof v4) == 0 &&
           set(socket, IPPROTO_IP, IP_ADD_MEMBERSHIP, membership);
  }
  sockaddr_in6 v6{};
  if (::inet_pton(AF_INET6, ear.group.c_str(), &v6.sin6_addr) != 1) return false;
  v6.sin6_family = AF_INET6;
  v6.sin6_port = htons(ear.port);
  v6.sin6_scope_id = index;
  ipv6_mreq membership{};
  membership.ipv6mr_multiaddr = v6.sin6_addr;
  membership.ipv6mr_interface = index;
  return ::bind(socket, reinterpret_cast<const sockaddr*>(&v6), sizeof v6) == 0 &&
         set(socket, IPPROTO_IPV6, IPV6_ADD_MEMBERSHIP, membership);
}

std::string text_of(const sockaddr_storage& address) {
  std::array<char, INET6_ADDRSTRLEN> text{};
  const bool is_v4 = address.ss_family == AF_INET;
  const void* octets = is_v4 ? static_cast<const void*>(&reinterpret_cast<const sockaddr_in&>(address).sin_addr)
                             : static_cast<const void*>(&reinterpret_cast<const sockaddr_in6&>(address).sin6_addr);
  return ::inet_ntop(address.ss_family, octets, text.data(), text.size()) == nullptr ? "" : text.data();
}

/// The groups beside a group of IPv4 that differ from it in their last number; none for IPv6.
std::vector<std::string> groups_beside(const std::string& group) {
  in_addr address{};
  std::vector<std::string> beside;
  if (::inet_pton(AF_INET, group.c_str(), &address) != 1) return beside;
  const std::string front = group.substr(0, group.rfind('.') + 1);
  const int last = static_cast<int>(ntohl(address.s_addr) & 0xffU);
  for (int number = std::max(0, last - neighbouring_groups); number <= std::min(255, last + neighbouring_groups);
       ++number)
    beside.push_back(front + std::to_string(number));
  return beside;
}

}  // namespace

Sockets::~Sockets() {
  for (const int number : numbers) ::close(number);
}

int Sockets::open(int family, int type, int protocol) {
  const int number = ::socket(family, type | SOCK_CLOEXEC | SOCK_NONBLOCK, protocol);
  if (number >= 0) numbers.push_back(number);
  return number;
}

void listen(const Sockets& sockets, std::chrono::milliseconds time, const std::function<void(int)>& take) {
  std::vector<pollfd> waiting;
  for (const int number : sockets.numbers) waiting.push_back({.fd = number, .events = POLLIN, .revents = 0});
  const auto end = std::chrono::steady_clock::now() + time;
  while (!waiting.empty()) {
    const auto left =
        std::chrono::duration_cast<std::chrono::milliseconds>(end - std::chrono::steady_clock::now()).count();
    if (left <= 0) break;
    if (::poll(waiting.data(), waiting.size(), static_cast<int>(left)) <= 0) continue;
    for (const pollfd& one : waiting) {
      if (one.revents != 0) take(one.fd);
    }
  }
}

Places places_beside(const Habits& ours) {
  std::set<std::uint16_t> ports;
  for (const int centre : {static_cast<int>(usual_port), static_cast<int>(ours.port)}) {
    for (int port = std::max(1, centre - neighbouring_ports); port <= std::min(65535, centre + neighbouring_ports);
         ++port)
      ports.insert(static_cast<std::uint16_t>(port));
  }
  std::set<std::string> groups(ours.groups.begin(), ours.groups.end());
  groups.insert({usual_group_v4, usual_group_v6});
  std::set<std::string> beside;
  for (const std::string& group : groups) {
    for (std::string& one : groups_beside(group)) {
      if (!groups.contains(one)) beside.insert(std::move(one));
    }
  }
  return {.ports = {ports.begin(), ports.end()},
          .groups = {groups.begin(), groups.end()},
          .next_groups = {beside.begin(), beside.end()}};
}

std::vector<Overheard> overhear_neighbouring(const std::vector<std::string>& interfaces, const Habits& ours,
                                             std::chrono::milliseconds time) {
  Sockets sockets;
  std::map<int, Ear> ears;  // by descriptor
  const auto add = [&](const Ear& ear) {
    const bool is_v6 = ear.group.find(':') != std::string::npos;
    const int socket = sockets.open(is_v6 ? AF_INET6 : AF_INET, SOCK_DGRAM, 0);
    if (socket >= 0 && attend(socket, ear)) ears[socket] = ear;
  };
  const Places places = places_beside(ours);
  for (const std::string& interface : interfaces) {
    for (const std::string& group : places.groups) {
      for (const std::uint16_t port : places.ports) add({interface, group, port});
    }
    for (const std::string& group : places.next_groups) {
      for (const std::uint16_t port : std::set<std::uint16_t>{usual_port, ours.port}) add({interface, group, port});
    }
  }
  std::set<Overheard> heard;
  std::array<unsigned char, 2048> octets{};
  listen(sockets, time, [&](int socket) {
    sockaddr_storage from{};
    socklen_t from_size = sizeof from;
    const ssize_t size =
        ::recvfrom(socket, octets.data(), octets.size(), MSG_DONTWAIT, reinterpret_cast<sockaddr*>(&from), &from_size);
    const auto ear = ears.find(socket);
    if (size <= 0 || ear == ears.end()) return;
    Overheard one{.interface = ear->second.interface,
                  .source = text_of(from),
                  .group = ear->second.group,
                  .port = ear->second.port,
                  .participant = {}};
    if (!read_announcement(std::span(octets).first(static_cast<std::size_t>(size)), one.participant)) return;
    if (heard.size() < max_overheard) heard.insert(std::move(one));
  });
  return {heard.begin(), heard.end()};
}

}  // namespace geminga::doctor
