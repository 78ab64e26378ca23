// Copies of announcements for named hosts, where multicast does not pass, and what those hosts send us.
#ifndef GEMINGA_ENV_ASIO_UNICAST_HPP
#define GEMINGA_ENV_ASIO_UNICAST_HPP

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/address.hpp>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "base/log.hpp"
#include "env/asio/endpoint.hpp"
#include "env/asio/links.hpp"
#include "env/asio/reception.hpp"

namespace geminga::env {

/// Between two attempts to resolve a name that could not be resolved, and between two looks at one that could.
inline constexpr std::chrono::seconds resolve_retry{5};
inline constexpr std::chrono::seconds resolve_refresh{300};

/// The unicast side of all interfaces. One socket an own address, bound to that address and the UDP port, without
/// address sharing: a second daemon of this host cannot steal our datagrams (it is told that the address is in use),
/// and the multicast sockets, which are bound to group addresses, are not in the way. A copy goes out when the
/// participant sends on the interface that the kernel's route to the peer leads through, so that it carries the
/// addresses that are valid on the way there. Only datagrams from the peers' own addresses are taken, and only where
/// the peer can be: on the interface that the route to it leads through, or on one whose network it is in. So a spoofed
/// source from another network says nothing in a peer's name, whatever the kernel's rp_filter lets pass. Both sides
/// name each other.
class Unicast {
 public:
  using Receive = std::function<void(InterfaceIndex interface, const boost::asio::ip::address& source,
                                     std::span<const std::byte> datagram)>;

  /// What is not taken is added to `counts`, which is borrowed for the life of this object.
  Unicast(boost::asio::io_context& context, std::vector<HostPort> peers, std::uint16_t port, base::LogSink& log,
          AirCounts& counts, Receive receive);
  ~Unicast();
  Unicast(const Unicast&) = delete;
  Unicast& operator=(const Unicast&) = delete;

  /// The interfaces as they are now; also looks at the routes again. To be called regularly.
  void set_links(const std::vector<Link>& links);
  void send(InterfaceIndex interface, std::span<const std::byte> datagram);

 private:
  class State;
  std::shared_ptr<State> state_;
};

}  // namespace geminga::env

#endif
