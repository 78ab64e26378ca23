// The multicast sockets of one interface: joined to the team's groups there, and hearing nothing else.
#ifndef GEMINGA_ENV_ASIO_MULTICAST_HPP
#define GEMINGA_ENV_ASIO_MULTICAST_HPP

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/udp.hpp>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "env/asio/links.hpp"
#include "env/asio/reception.hpp"

namespace geminga::env {

/// Datagrams read in one turn of the event loop, before other sockets get theirs.
inline constexpr int max_datagrams_per_turn = 32;

/// The multicast side of one interface. Each group has one receiving socket, bound to the group's address and joined by
/// the interface's index, with IP_MULTICAST_ALL off: it hears its own interface and group, and nothing that another
/// socket of this host has joined. Each family has one sending socket with a port of its own, so that our own echo is
/// told from datagrams of another daemon of this host.
///
/// Sends on one family: on IPv4 if the interface has an IPv4 address and there is an IPv4 group, else on IPv6. Receives
/// on all groups that it is given. A dual-stack interface is two of these (env/asio/families.hpp): nearly everybody
/// would hear what is said on both families twice, and a datagram saved is air time of the whole team.
class MulticastLink {
 public:
  /// Takes one datagram with its sender. Must not destroy the MulticastLink.
  using Receive = std::function<void(const boost::asio::ip::address& source, std::span<const std::byte> datagram)>;

  /// Opens what can be opened. What cannot be opened is in problems(), one line each. Adds the datagrams that are not
  /// taken to `counts`, which is borrowed for the life of this object.
  MulticastLink(boost::asio::io_context& context, const Link& link, const std::vector<boost::asio::ip::address>& groups,
                std::uint16_t port, AirCounts& counts, Receive receive);
  ~MulticastLink();
  MulticastLink(const MulticastLink&) = delete;
  MulticastLink& operator=(const MulticastLink&) = delete;

  /// Sends to every group of the family in use. Never blocks. What the kernel refuses is counted and lost.
  void send(std::span<const std::byte> datagram);

  /// Takes in changed addresses. True: the sockets still fit; false: make a new MulticastLink.
  [[nodiscard]] bool update(const Link& link);
  [[nodiscard]] const Link& link() const;
  [[nodiscard]] const std::vector<std::string>& problems() const;
  /// Whether it can send, and hears the groups of the family that it sends on. If not, it is worth another attempt.
  [[nodiscard]] bool is_sound() const;
  /// Whether something could not be opened because the system had no descriptor or no memory left: then another attempt
  /// is worth it, though it may be sound.
  [[nodiscard]] bool is_short() const;
  /// The time at which a datagram last came in, our own echo among them; at which it was made where none has.
  [[nodiscard]] std::chrono::steady_clock::time_point last_heard() const;
  /// The error of the last send, or 0.
  [[nodiscard]] int last_send_error() const;
  /// Whether a send has failed since the last call. A failure of long ago tells nothing: an IPv6 side may say nothing
  /// after it for the rest of its life.
  [[nodiscard]] bool take_failure();

 private:
  struct Sockets;
  std::shared_ptr<Sockets> sockets_;  // shared with the handlers that wait on them
};

}  // namespace geminga::env

#endif
