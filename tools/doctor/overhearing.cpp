#include "doctor/overhearing.hpp"

#include <arpa/inet.h>
#include <net/ethernet.h>
#include <net/if.h>
#include <netinet/in.h>
#include <netpacket/packet.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <set>

#include "doctor/listening.hpp"

namespace geminga::doctor {
namespace {

void join_usual_groups(Sockets& sockets, unsigned index) {
  ip_mreqn v4{};
  v4.imr_ifindex = static_cast<int>(index);
  ::inet_pton(AF_INET, usual_group_v4, &v4.imr_multiaddr);
  const int socket_v4 = sockets.open(AF_INET, SOCK_DGRAM, 0);
  if (socket_v4 >= 0) (void)::setsockopt(socket_v4, IPPROTO_IP, IP_ADD_MEMBERSHIP, &v4, sizeof v4);
  ipv6_mreq v6{};
  v6.ipv6mr_interface = index;
  ::inet_pton(AF_INET6, usual_group_v6, &v6.ipv6mr_multiaddr);
  const int socket_v6 = sockets.open(AF_INET6, SOCK_DGRAM, 0);
  if (socket_v6 >= 0) (void)::setsockopt(socket_v6, IPPROTO_IPV6, IPV6_ADD_MEMBERSHIP, &v6, sizeof v6);
}

std::uint16_t number_at(std::span<const unsigned char> octets, std::size_t at) {
  return static_cast<std::uint16_t>(octets[at] << 8U | octets[at + 1]);
}

std::string text_of(int family, const unsigned char* address) {
  std::array<char, INET6_ADDRSTRLEN> text{};
  return ::inet_ntop(family, address, text.data(), text.size()) == nullptr ? "" : text.data();
}

}  // namespace

bool read_announcement(std::span<const unsigned char> octets, std::string& participant) {
  constexpr std::array<unsigned char, 5> format{0x0d, 0x47, 0x4d, 0x4e, 0x01};
  participant.clear();
  if (octets.size() >= 32 && octets[0] == 'G' && octets[1] >> 4U == 1) return true;
  if (octets.size() < 12 || !std::ranges::equal(octets.first(format.size()), format)) return false;
  if (octets[5] == 0x18 && octets[7] == 0x25) {  // the kind, and then the participant
    std::array<char, 9> text{};
    std::snprintf(text.data(), text.size(), "%02x%02x%02x%02x", octets[11], octets[10], octets[9], octets[8]);
    participant = text.data();
  }
  return true;
}

bool read_packet(std::span<const unsigned char> packet, bool is_ipv6, Overheard& into) {
  constexpr unsigned char udp = 17;
  constexpr std::size_t udp_header = 8;
  std::size_t header = is_ipv6 ? 40 : 20;
  if (packet.size() < header + udp_header) return false;
  if (is_ipv6) {
    if (packet[0] >> 4U != 6 || packet[6] != udp || packet[24] != 0xff) return false;
    into.source = text_of(AF_INET6, &packet[8]);
    into.group = text_of(AF_INET6, &packet[24]);
  } else {
    header = std::size_t{4} * (packet[0] & 0x0fU);
    if (packet[0] >> 4U != 4 || packet[9] != udp || packet[16] >> 4U != 0xe) return false;
    if (header < 20 || packet.size() < header + udp_header) return false;
    into.source = text_of(AF_INET, &packet[12]);
    into.group = text_of(AF_INET, &packet[16]);
  }
  into.port = number_at(packet, header + 2);
  return read_announcement(packet.subspan(header + udp_header), into.participant);
}

bool overhears_all() {
  Sockets sockets;
  return sockets.open(AF_PACKET, SOCK_DGRAM, htons(ETH_P_IP)) >= 0;
}

std::vector<Overheard> overhear(const std::vector<std::string>& interfaces, const Habits& ours,
                                std::chrono::milliseconds time) {
  if (!overhears_all()) return overhear_neighbouring(interfaces, ours, time);
  struct Ear {
    std::string interface;
    bool is_ipv6 = false;
  };
  Sockets sockets;
  std::map<int, Ear> ears;  // by descriptor
  for (const std::string& interface : interfaces) {
    const unsigned index = ::if_nametoindex(interface.c_str());
    if (index == 0) continue;
    for (const int protocol : {ETH_P_IP, ETH_P_IPV6}) {
      const int socket = sockets.open(AF_PACKET, SOCK_DGRAM, htons(static_cast<std::uint16_t>(protocol)));
      sockaddr_ll place{};
      place.sll_family = AF_PACKET;
      place.sll_protocol = htons(static_cast<std::uint16_t>(protocol));
      place.sll_ifindex = static_cast<int>(index);
      if (socket < 0 || ::bind(socket, reinterpret_cast<const sockaddr*>(&place), sizeof place) != 0) continue;
      ears[socket] = {interface, protocol == ETH_P_IPV6};
    }
    join_usual_groups(sockets, index);
  }
  std::set<Overheard> heard;
  std::array<unsigned char, 2048> packet{};
  listen(sockets, time, [&](int socket) {
    const ssize_t size = ::recv(socket, packet.data(), packet.size(), MSG_DONTWAIT);
    const auto ear = ears.find(socket);
    if (size <= 0 || ear == ears.end()) return;
    Overheard one;
    one.interface = ear->second.interface;
    if (!read_packet(std::span(packet).first(static_cast<std::size_t>(size)), ear->second.is_ipv6, one)) return;
    if (heard.size() < max_overheard) heard.insert(std::move(one));
  });
  return {heard.begin(), heard.end()};
}

}  // namespace geminga::doctor
