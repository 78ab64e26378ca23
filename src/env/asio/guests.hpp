// Hosts that nobody has named, and that send to us alone with the team's key.
#ifndef GEMINGA_ENV_ASIO_GUESTS_HPP
#define GEMINGA_ENV_ASIO_GUESTS_HPP

#include <boost/asio/ip/udp.hpp>
#include <cstddef>
#include <vector>

#include "base/time.hpp"
#include "env/asio/named_peer.hpp"
#include "env/env.hpp"

namespace geminga::env {

/// The most hosts that are sent copies because they have proved themselves. Of more, the one whose time ends first
/// gives way.
inline constexpr std::size_t max_guests = 64;
/// The bounds of answers to a host that has not proved itself: one datagram of at most so many times the octets of its
/// own, so that a recording from a forged address hits nobody harder than the recording itself; and so many a second
/// for all such hosts.
inline constexpr std::size_t max_answer_ratio = 3;
inline constexpr std::size_t max_answers_per_second = 32;

/// The same where the owner has named no peer, so that nobody has asked for copies.
inline constexpr std::size_t max_unasked_guests = 8;

class Guests {
 public:
  /// Sends copies to so many hosts at most.
  explicit Guests(std::size_t room = max_guests) : room_(room) {}

  struct Sender {
    boost::asio::ip::udp::endpoint to;
    boost::asio::ip::address via;  ///< our own address that it was sent to
    InterfaceIndex interface{};
    std::size_t octets = 0;  ///< of its datagram
  };

  /// Sends copies to this host for so long; 0: of one datagram.
  void answer(const Sender& sender, base::Duration time, Clock::time_point now);
  /// The routes of the copies of a datagram of this size on this interface.
  [[nodiscard]] std::vector<Route> take_routes(std::size_t octets, InterfaceIndex interface, Clock::time_point now);
  /// The hosts that have proved themselves.
  [[nodiscard]] std::size_t count(Clock::time_point now) const;

 private:
  struct Guest {
    Sender sender;
    Clock::time_point until;
  };
  std::size_t room_;
  std::vector<Guest> guests_;
  std::vector<Sender> answered_once_;
  std::size_t answers_ = 0;     ///< since `second_`
  Clock::time_point second_{};  ///< when the current second began
};

}  // namespace geminga::env

#endif
