#include "env/asio/multicast.hpp"

#include <net/if.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <boost/asio/ip/v6_only.hpp>
#include <cerrno>
#include <cstring>
#include <optional>
#include <system_error>
#include <utility>

#include "env/asio/event_sink.hpp"

namespace geminga::env {
namespace {

namespace net = boost::asio;
using net::ip::address;
using net::ip::udp;

/// The receive buffer that the kernel is asked for: a burst of a few hundred datagrams.
constexpr int receive_buffer_bytes = 1 << 20;

bool set_option(udp::socket& socket, int level, int option, const void* value, std::size_t size) {
  return ::setsockopt(socket.native_handle(), level, option, value, static_cast<socklen_t>(size)) == 0;
}

bool set_int(udp::socket& socket, int level, int option, int value) {
  return set_option(socket, level, option, &value, sizeof value);
}

std::string reason() { return std::generic_category().message(errno); }

bool is_shortage(int error) { return error == EMFILE || error == ENFILE || error == ENOBUFS || error == ENOMEM; }

/// Joins the group on the interface, and hears only what was joined. False with errno.
bool join(udp::socket& socket, const address& group, int index) {
  if (group.is_v4()) {
    ip_mreqn request{};
    request.imr_multiaddr.s_addr = htonl(group.to_v4().to_uint());
    request.imr_ifindex = index;
    return set_int(socket, IPPROTO_IP, IP_MULTICAST_ALL, 0) &&
           set_option(socket, IPPROTO_IP, IP_ADD_MEMBERSHIP, &request, sizeof request);
  }
  ipv6_mreq request{};
  const auto bytes = group.to_v6().to_bytes();
  std::memcpy(&request.ipv6mr_multiaddr, bytes.data(), bytes.size());
  request.ipv6mr_interface = static_cast<unsigned>(index);
  return set_int(socket, IPPROTO_IPV6, IPV6_MULTICAST_ALL, 0) &&
         set_option(socket, IPPROTO_IPV6, IPV6_ADD_MEMBERSHIP, &request, sizeof request);
}

/// Sends on this interface and no further than the link (TTL 1), and lets other daemons of this host hear it.
bool aim(udp::socket& socket, bool is_v4, int index) {
  if (is_v4) {
    ip_mreqn request{};
    request.imr_ifindex = index;
    return set_option(socket, IPPROTO_IP, IP_MULTICAST_IF, &request, sizeof request) &&
           set_int(socket, IPPROTO_IP, IP_MULTICAST_TTL, 1) && set_int(socket, IPPROTO_IP, IP_MULTICAST_LOOP, 1);
  }
  return set_int(socket, IPPROTO_IPV6, IPV6_MULTICAST_IF, index) &&
         set_int(socket, IPPROTO_IPV6, IPV6_MULTICAST_HOPS, 1) && set_int(socket, IPPROTO_IPV6, IPV6_MULTICAST_LOOP, 1);
}

/// The address with the interface as its scope, if its family needs one.
address scoped(const address& group, int index) {
  if (group.is_v4()) return group;
  net::ip::address_v6 v6 = group.to_v6();
  v6.scope_id(static_cast<net::ip::scope_id_type>(index));
  return v6;
}

}  // namespace

struct MulticastLink::Sockets : std::enable_shared_from_this<MulticastLink::Sockets> {
  struct Socket {
    udp::socket socket;
    bool is_v4;
    Receiver receiver;
  };

  Link link;
  Receive receive;
  AirCounts* counts = nullptr;
  std::vector<Socket> receivers;
  std::optional<udp::socket> sender;
  std::vector<udp::endpoint> targets;
  udp::endpoint own;  // the sender's; its address may be unspecified
  std::vector<std::string> problems;
  std::chrono::steady_clock::time_point heard = std::chrono::steady_clock::now();
  int send_error = 0;
  bool has_failed = false;
  bool is_short = false;
  bool is_closed = false;

  /// The kernel's index.
  [[nodiscard]] int index() const {
    return static_cast<int>(link.interface.ipv6_side_of.value_or(link.interface.index));
  }

  void open_receiver(net::io_context& context, const address& group, std::uint16_t port) {
    udp::socket socket(context);
    boost::system::error_code error;
    socket.open(group.is_v4() ? udp::v4() : udp::v6(), error);
    if (!error && group.is_v6()) socket.set_option(net::ip::v6_only(true), error);
    if (!error) socket.set_option(net::socket_base::reuse_address(true), error);
    if (!error) socket.bind({scoped(group, index()), port}, error);
    if (error) {
      is_short = is_short || is_shortage(error.value());
      problems.push_back("cannot listen to " + group.to_string() + " on " + link.interface.name + ": " +
                         error.message());
      return;
    }
    if (!join(socket, group, index())) {
      is_short = is_short || is_shortage(errno);
      problems.push_back("cannot join " + group.to_string() + " on " + link.interface.name + ": " + reason());
      return;
    }
    set_int(socket, SOL_SOCKET, SO_RCVBUF, receive_buffer_bytes);  // a smaller buffer works, too
    Receiver receiver;
    receiver.watch_drops(socket);
    receivers.push_back({std::move(socket), group.is_v4(), receiver});
  }

  void open_sender(net::io_context& context, const std::vector<address>& groups, std::uint16_t port) {
    const auto v4 = link.first_v4();
    const bool on_v4 = v4 && std::ranges::any_of(groups, &address::is_v4);
    for (const address& group : groups) {
      if (group.is_v4() == on_v4) targets.emplace_back(scoped(group, index()), port);
    }
    if (targets.empty()) return;
    udp::socket socket(context);
    boost::system::error_code error;
    socket.open(on_v4 ? udp::v4() : udp::v6(), error);
    // Bound to the interface's own address: the kernel would not choose 127.0.0.1 for a datagram to a group.
    if (!error) socket.bind(on_v4 ? udp::endpoint(*v4, 0) : udp::endpoint(udp::v6(), 0), error);
    if (!error) own = socket.local_endpoint(error);
    if (!error && !aim(socket, on_v4, index())) error.assign(errno, boost::system::generic_category());
    if (error) {
      is_short = is_short || is_shortage(error.value());
      problems.push_back("cannot send on " + link.interface.name + ": " + error.message());
      return;
    }
    sender = std::move(socket);
  }

  void await(std::size_t number) {
    receivers[number].socket.async_wait(net::socket_base::wait_read,
                                        [self = shared_from_this(), number](const boost::system::error_code& error) {
                                          if (error || self->is_closed) return;
                                          self->drain(number);
                                          if (!self->is_closed) self->await(number);
                                        });
  }

  void drain(std::size_t number) {
    std::array<std::byte, max_datagram_bytes + 1> buffer;
    for (int turn = 0; turn < max_datagrams_per_turn && !is_closed; ++turn) {
      Socket& on = receivers[number];
      const auto reception = on.receiver.receive(on.socket, buffer, *counts);
      if (!reception) return;  // drained, or a pending error of the socket that reading has cleared
      heard = std::chrono::steady_clock::now();
      const address source = without_scope(reception->from.address());
      if (is_echo(source, reception->from.port())) continue;
      if (!link.is_on_link(source)) {
        ++counts->off_link;
        continue;
      }
      receive(source, std::span(buffer).first(reception->size));
    }
  }

  [[nodiscard]] static address without_scope(const address& given) {
    return given.is_v6() ? address(net::ip::address_v6(given.to_v6().to_bytes())) : given;
  }

  [[nodiscard]] bool is_echo(const address& source, std::uint16_t port) const {
    return sender && port == own.port() && source.is_v4() == own.address().is_v4() && link.has_address(source);
  }
};

MulticastLink::MulticastLink(net::io_context& context, const Link& link, const std::vector<address>& groups,
                             std::uint16_t port, AirCounts& counts, Receive receive)
    : sockets_(std::make_shared<Sockets>()) {
  sockets_->link = link;
  sockets_->counts = &counts;
  sockets_->receive = std::move(receive);
  for (const address& group : groups) sockets_->open_receiver(context, group, port);
  sockets_->open_sender(context, groups, port);
  for (std::size_t number = 0; number < sockets_->receivers.size(); ++number) sockets_->await(number);
}

MulticastLink::~MulticastLink() {
  sockets_->is_closed = true;
  boost::system::error_code ignored;
  for (auto& receiver : sockets_->receivers) receiver.socket.close(ignored);
  if (sockets_->sender) sockets_->sender->close(ignored);
}

void MulticastLink::send(std::span<const std::byte> datagram) {
  if (!sockets_->sender) return;
  for (const udp::endpoint& target : sockets_->targets) {
    const ssize_t sent = ::sendto(sockets_->sender->native_handle(), datagram.data(), datagram.size(),
                                  MSG_DONTWAIT | MSG_NOSIGNAL, target.data(), static_cast<socklen_t>(target.size()));
    sockets_->send_error = sent < 0 ? errno : 0;
    sockets_->has_failed = sockets_->has_failed || sent < 0;
  }
}

bool MulticastLink::update(const Link& link) {
  const auto had_v6 = std::ranges::any_of(sockets_->link.prefixes, [](const Prefix& p) { return p.address.is_v6(); });
  const auto has_v6 = std::ranges::any_of(link.prefixes, [](const Prefix& p) { return p.address.is_v6(); });
  if (link.first_v4() != sockets_->link.first_v4() || had_v6 != has_v6) return false;
  sockets_->link = link;
  return true;
}

bool MulticastLink::is_sound() const {
  if (!sockets_->sender) return false;
  return std::ranges::any_of(sockets_->receivers, [&](const Sockets::Socket& receiver) {
    return receiver.is_v4 == sockets_->own.address().is_v4();
  });
}

bool MulticastLink::is_short() const { return sockets_->is_short; }
const Link& MulticastLink::link() const { return sockets_->link; }
const std::vector<std::string>& MulticastLink::problems() const { return sockets_->problems; }
std::chrono::steady_clock::time_point MulticastLink::last_heard() const { return sockets_->heard; }
int MulticastLink::last_send_error() const { return sockets_->send_error; }
bool MulticastLink::take_failure() { return std::exchange(sockets_->has_failed, false); }

}  // namespace geminga::env
