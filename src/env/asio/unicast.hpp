// Copies of announcements for named hosts that multicast does not reach, and the datagrams that those hosts send us.
#ifndef GEMINGA_ENV_ASIO_UNICAST_HPP
#define GEMINGA_ENV_ASIO_UNICAST_HPP

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/address.hpp>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "base/log.hpp"
#include "env/asio/endpoint.hpp"
#include "env/asio/links.hpp"
#include "env/asio/reception.hpp"

namespace geminga::env {

/// The most hosts that are named.
inline constexpr std::size_t max_unicast_peers = 64;
/// The number of the first named host as a link of its own; the others follow in their order. No interface of a kernel
/// has such a number.
inline constexpr std::uint32_t first_peer_link = std::uint32_t{1} << 30U;

/// The hosts that are sent copies.
struct UnicastCounts {
  std::size_t named = 0;   ///< by --peer
  std::size_t silent = 0;  ///< those of them that were not heard for peer_silence
  std::size_t guests = 0;  ///< hosts that nobody named, and that have the team's key
};

/// The hosts that are heard though nobody has named them.
enum class Admission : std::uint8_t {
  nobody,
  sealed,  ///< all that is heard is sealed; copies go to hosts that have proved themselves, and to nobody else
  asked,   ///< the same, and the owner wishes it: a host that has proved nothing gets what it needs for a proof
};

struct UnicastSettings {
  std::vector<HostPort> peers;  ///< the named hosts
  bool are_links = false;       ///< each of them is a link of its own, and gets only what is sent on that
  Admission admission = Admission::nobody;
  std::uint16_t port = 0;  ///< of ours
};

/// The unicast side of all interfaces. Each own address has one socket, bound to that address and the UDP port without
/// address sharing. So a second daemon of this host cannot take our datagrams (it is told that the address is in use),
/// and the multicast sockets, which are bound to group addresses, are not in the way.
///
/// A copy goes out when the participant sends on the interface that the kernel's route to the peer leads through, so it
/// carries the addresses that are valid on that way. Datagrams are taken only from the peers' own addresses, and only
/// where the peer can be: on the interface that the route to it leads through, or on one whose network it is in. So a
/// spoofed source from another network says nothing in a peer's name, whatever the kernel's rp_filter lets pass. Both
/// sides name each other. If guests are admitted (env/asio/guests.hpp), datagrams from elsewhere are handed over, too,
/// since the receiver judges them by their seal; then it is enough that one side names the other.
///
/// The handlers of its sockets share the sockets, which may outlive this object for a turn.
class Unicast {
 public:
  using Receive = std::function<void(InterfaceIndex interface, const boost::asio::ip::address& source,
                                     std::span<const std::byte> datagram)>;

  /// Adds the datagrams that are not taken to `counts`, which is borrowed for the life of this object.
  Unicast(boost::asio::io_context& context, UnicastSettings settings, base::LogSink& log, AirCounts& counts,
          Receive receive);
  ~Unicast();
  Unicast(const Unicast&) = delete;
  Unicast& operator=(const Unicast&) = delete;

  /// Sets the interfaces, and looks at the routes again. Call regularly.
  void set_links(const std::vector<Link>& links);
  void send(InterfaceIndex interface, std::span<const std::byte> datagram);
  /// The named hosts that a route through one of these interfaces leads to, as links of their own; none unless they are
  /// to be.
  [[nodiscard]] std::vector<Interface> peer_links(const std::vector<Interface>& interfaces) const;
  /// Env::send_alone(), from our own address on the route there.
  void send_alone(InterfaceIndex interface, std::string_view to, std::span<const std::byte> datagram);
  /// Env::is_sender_named(), Env::is_sender_unnamed(), Env::answer_sender().
  [[nodiscard]] bool is_sender_named() const;
  [[nodiscard]] bool is_sender_unnamed() const;
  void answer_sender(base::Duration time);
  [[nodiscard]] UnicastCounts counts() const;

 private:
  class Sockets;
  std::shared_ptr<Sockets> sockets_;
};

}  // namespace geminga::env

#endif
