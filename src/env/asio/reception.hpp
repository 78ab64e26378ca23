// Reading datagrams with what the kernel knows of each; and the count of those that are not taken.
#ifndef GEMINGA_ENV_ASIO_RECEPTION_HPP
#define GEMINGA_ENV_ASIO_RECEPTION_HPP

#include <boost/asio/ip/udp.hpp>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace geminga::env {

/// Datagrams that reached this host and that nobody was told of, since the start.
struct AirCounts {
  std::uint64_t off_link = 0;   ///< sent to a group from an address that is not on that link
  std::uint64_t no_peer = 0;    ///< sent to us alone by a host that we do not name by --peer
  std::uint64_t wrong_way = 0;  ///< claims a peer's address and came in where that peer cannot be
  std::uint64_t overrun = 0;    ///< came faster than they were read: the kernel dropped them
};

/// What the kernel says of one datagram.
struct Reception {
  boost::asio::ip::udp::endpoint from;
  std::size_t size = 0;
  unsigned interface = 0;  ///< where it came in; 0 unless watch_interface() was called
};

/// Reads the datagrams of one socket.
class Receiver {
 public:
  /// Asks the kernel to say how many datagrams it drops. What it does not know is not counted.
  void watch_drops(boost::asio::ip::udp::socket& socket);
  /// Asks the kernel to say where each datagram came in. False with errno.
  [[nodiscard]] static bool watch_interface(boost::asio::ip::udp::socket& socket, bool is_v4);

  /// The next datagram that waits, cut to the buffer; nothing with errno. Adds to `counts.overrun`.
  [[nodiscard]] std::optional<Reception> receive(boost::asio::ip::udp::socket& socket, std::span<std::byte> buffer,
                                                 AirCounts& counts);

 private:
  std::uint32_t drops_ = 0;  ///< of this socket, as the kernel last said; it counts modulo 2^32
};

}  // namespace geminga::env

#endif
