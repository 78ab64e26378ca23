// Reading datagrams with the kernel's information about each, and the counts of those that are not taken.
#ifndef GEMINGA_ENV_ASIO_RECEPTION_HPP
#define GEMINGA_ENV_ASIO_RECEPTION_HPP

#include <boost/asio/ip/udp.hpp>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace geminga::env {

/// The datagrams that reached this host and were not handed over, since the start.
struct AirCounts {
  std::uint64_t off_link = 0;   ///< sent to a group from an address that is not on that link
  std::uint64_t no_peer = 0;    ///< sent to us alone by a host that we do not name by --peer
  std::uint64_t wrong_way = 0;  ///< has a peer's address as source, and came in where that peer cannot be
  std::uint64_t overrun = 0;    ///< came faster than they were read: the kernel dropped them
};

/// A datagram's properties, as the kernel tells them.
struct Reception {
  boost::asio::ip::udp::endpoint from;
  std::size_t size = 0;
  unsigned interface = 0;  ///< the interface that it came in on; 0 unless watch_interface() was called
};

/// Reads the datagrams of one socket.
class Receiver {
 public:
  /// Asks the kernel to tell how many datagrams it drops. A kernel that cannot tell is not asked again.
  void watch_drops(boost::asio::ip::udp::socket& socket);
  /// Asks the kernel to tell where each datagram came in. False with errno.
  [[nodiscard]] static bool watch_interface(boost::asio::ip::udp::socket& socket, bool is_v4);

  /// The next datagram that waits, cut to the buffer; nothing with errno. Adds to `counts.overrun`.
  [[nodiscard]] std::optional<Reception> receive(boost::asio::ip::udp::socket& socket, std::span<std::byte> buffer,
                                                 AirCounts& counts);

 private:
  std::uint32_t drops_ = 0;  ///< the kernel's last count for this socket, modulo 2^32
};

}  // namespace geminga::env

#endif
