// A host that is named by --peer: where it is, and when its name is looked at again.
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

/// Between two attempts to resolve a name that could not be resolved, and between two looks at one whose host is heard.
inline constexpr std::chrono::seconds resolve_retry{5};
inline constexpr std::chrono::seconds resolve_refresh{300};
/// Who was not heard for so long may have moved: its name is looked at again, and after each vain look half as often,
/// down to once in slowest_look. Of several addresses another one is tried each time while none was heard for
/// resolve_refresh.
inline constexpr std::chrono::seconds peer_silence{15};
inline constexpr std::chrono::seconds slowest_look{80};
/// Addresses of one name; further ones are not used.
inline constexpr std::size_t max_peer_addresses = 8;

/// An endpoint, and our own address on the way there; nothing: there is no way through an interface in use.
struct Route {
  boost::asio::ip::udp::endpoint to;
  std::optional<boost::asio::ip::address> via;
};

/// Spoken to at one of its addresses, heard from all.
class NamedPeer {
 public:
  NamedPeer(HostPort name, Clock::time_point now);

  [[nodiscard]] const HostPort& name() const { return name_; }
  /// Told by a name, which has to be resolved.
  [[nodiscard]] bool is_by_name() const { return is_by_name_; }
  /// Whether its name is to be looked at.
  [[nodiscard]] bool is_due(Clock::time_point now) const { return is_by_name_ && now >= next_look_; }
  /// What its name was resolved to; nothing: it could not be, and keeps what it had.
  void take(const std::vector<boost::asio::ip::address>& addresses, Clock::time_point now);
  [[nodiscard]] bool is_resolved() const { return !routes_.empty(); }

  /// `via` tells our own address on the way to an endpoint, `port` is ours.
  void find_routes(
      std::uint16_t port,
      const std::function<std::optional<boost::asio::ip::address>(const boost::asio::ip::udp::endpoint&)>& via);
  /// Where copies go; null: nowhere, since its name has no address yet, or it is ourselves.
  [[nodiscard]] const Route* route() const;
  [[nodiscard]] bool is_ourselves() const { return is_ourselves_; }

  [[nodiscard]] bool is_at(const boost::asio::ip::address& from) const { return find(from) != nullptr; }
  /// Our own address on the way to one of its own.
  [[nodiscard]] std::optional<boost::asio::ip::address> via(const boost::asio::ip::address& from) const;
  /// It has spoken from this address of its own, so it is spoken to there.
  void heard_from(const boost::asio::ip::address& from, Clock::time_point now);
  [[nodiscard]] bool was_heard_since(Clock::time_point when) const { return heard_ && *heard_ > when; }

  std::string complaint;  ///< the last one, so that it is said once

 private:
  [[nodiscard]] const Route* find(const boost::asio::ip::address& from) const;

  HostPort name_;
  bool is_by_name_ = false;
  bool is_ourselves_ = false;
  std::vector<Route> routes_;
  std::size_t chosen_ = 0;  ///< of the routes
  std::optional<Clock::time_point> heard_;
  Clock::time_point looked_;  ///< when its name was resolved last
  Clock::time_point next_look_;
  std::chrono::seconds pause_ = resolve_retry;  ///< after a vain look
};

}  // namespace geminga::env

#endif
