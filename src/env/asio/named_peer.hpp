// A host that is named by --peer: its addresses, and when its name is resolved again.
#ifndef GEMINGA_ENV_ASIO_NAMED_PEER_HPP
#define GEMINGA_ENV_ASIO_NAMED_PEER_HPP

#include <boost/asio/ip/udp.hpp>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "env/asio/endpoint.hpp"

namespace geminga::env {

using Clock = std::chrono::steady_clock;

/// The time between two attempts to resolve a name that could not be resolved, and between two look-ups of the name of
/// a host that is heard.
inline constexpr std::chrono::seconds resolve_retry{5};
inline constexpr std::chrono::seconds resolve_refresh{300};
/// A host that was not heard for so long may have moved: its name is resolved again, and after each vain look-up half
/// as often, down to once in slowest_look. Of several addresses the next one is tried each time while none was heard
/// for resolve_refresh.
inline constexpr std::chrono::seconds peer_silence{15};
inline constexpr std::chrono::seconds slowest_look{80};
/// The most addresses of one name that are used.
inline constexpr std::size_t max_peer_addresses = 8;

/// An endpoint, and our own address on the way there; nothing: no interface in use leads there.
struct Route {
  boost::asio::ip::udp::endpoint to;
  std::optional<boost::asio::ip::address> via;
};

/// Copies go to one of its addresses; datagrams from all of them are taken.
class NamedPeer {
 public:
  NamedPeer(HostPort name, Clock::time_point now);

  [[nodiscard]] const HostPort& name() const { return name_; }
  /// Whether it was given by a name, which has to be resolved.
  [[nodiscard]] bool is_by_name() const { return is_by_name_; }
  /// Whether its name is to be resolved.
  [[nodiscard]] bool is_due(Clock::time_point now) const { return is_by_name_ && now >= next_look_; }
  /// Takes in the addresses that its name was resolved to; none: it could not be resolved, and keeps those that it had.
  void take(const std::vector<boost::asio::ip::address>& addresses, Clock::time_point now);
  [[nodiscard]] bool is_resolved() const { return !routes_.empty(); }

  /// Finds our own address on the way to each endpoint by `via`. `port` is ours.
  void find_routes(
      std::uint16_t port,
      const std::function<std::optional<boost::asio::ip::address>(const boost::asio::ip::udp::endpoint&)>& via);
  /// The route of the copies; null: there is none, since its name has no address yet, or it is ourselves.
  [[nodiscard]] const Route* route() const;
  [[nodiscard]] bool is_ourselves() const { return is_ourselves_; }

  [[nodiscard]] bool is_at(const boost::asio::ip::address& from) const { return find(from) != nullptr; }
  /// Our own address on the way to one of its addresses.
  [[nodiscard]] std::optional<boost::asio::ip::address> via(const boost::asio::ip::address& from) const;
  /// Takes in that it has spoken from this address, so copies go there.
  void heard_from(const boost::asio::ip::address& from, Clock::time_point now);
  [[nodiscard]] bool was_heard_since(Clock::time_point when) const { return heard_ && *heard_ > when; }

  std::string complaint;  ///< the last one, so that each is logged once

 private:
  [[nodiscard]] const Route* find(const boost::asio::ip::address& from) const;

  HostPort name_;
  bool is_by_name_ = false;
  bool is_ourselves_ = false;
  std::vector<Route> routes_;
  std::size_t chosen_ = 0;  ///< its number among the routes
  std::optional<Clock::time_point> heard_;
  Clock::time_point looked_;  ///< when its name was resolved last
  Clock::time_point next_look_;
  std::chrono::seconds pause_ = resolve_retry;  ///< the pause after a vain look-up
};

}  // namespace geminga::env

#endif
