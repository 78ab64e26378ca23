#include "env/asio/reception.hpp"

#include <netinet/in.h>
#include <sys/socket.h>

#include <array>
#include <cstring>

namespace geminga::env {
namespace {

using boost::asio::ip::udp;

template <typename Value>
Value read_as(const cmsghdr& header) {
  Value value{};
  std::memcpy(&value, CMSG_DATA(&header), sizeof value);
  return value;
}

bool switch_on(udp::socket& socket, int level, int option) {
  const int on = 1;
  return ::setsockopt(socket.native_handle(), level, option, &on, sizeof on) == 0;
}

}  // namespace

void Receiver::watch_drops(udp::socket& socket) { switch_on(socket, SOL_SOCKET, SO_RXQ_OVFL); }

bool Receiver::watch_interface(udp::socket& socket, bool is_v4) {
  return is_v4 ? switch_on(socket, IPPROTO_IP, IP_PKTINFO) : switch_on(socket, IPPROTO_IPV6, IPV6_RECVPKTINFO);
}

std::optional<Reception> Receiver::receive(udp::socket& socket, std::span<std::byte> buffer, AirCounts& counts) {
  Reception reception;
  iovec part{.iov_base = buffer.data(), .iov_len = buffer.size()};
  alignas(cmsghdr) std::array<std::byte, 256> control{};
  msghdr message{};
  message.msg_name = reception.from.data();
  message.msg_namelen = static_cast<socklen_t>(reception.from.capacity());
  message.msg_iov = &part;
  message.msg_iovlen = 1;
  message.msg_control = control.data();
  message.msg_controllen = control.size();
  const ssize_t size = ::recvmsg(socket.native_handle(), &message, MSG_DONTWAIT);
  if (size < 0) return std::nullopt;
  reception.from.resize(message.msg_namelen);
  reception.size = static_cast<std::size_t>(size);
  for (cmsghdr* header = CMSG_FIRSTHDR(&message); header != nullptr; header = CMSG_NXTHDR(&message, header)) {
    if (header->cmsg_level == SOL_SOCKET && header->cmsg_type == SO_RXQ_OVFL) {
      const auto drops = read_as<std::uint32_t>(*header);
      counts.overrun += drops - drops_;
      drops_ = drops;
    } else if (header->cmsg_level == IPPROTO_IP && header->cmsg_type == IP_PKTINFO) {
      reception.interface = static_cast<unsigned>(read_as<in_pktinfo>(*header).ipi_ifindex);
    } else if (header->cmsg_level == IPPROTO_IPV6 && header->cmsg_type == IPV6_PKTINFO) {
      reception.interface = read_as<in6_pktinfo>(*header).ipi6_ifindex;
    }
  }
  return reception;
}

}  // namespace geminga::env
