#include "env/asio/named_peer.hpp"

#include <algorithm>
#include <utility>

namespace geminga::env {

using boost::asio::ip::address;
using boost::asio::ip::udp;

NamedPeer::NamedPeer(HostPort name, Clock::time_point now) : name_(std::move(name)), next_look_(now) {
  boost::system::error_code error;
  const address numeric = boost::asio::ip::make_address(name_.host, error);
  is_by_name_ = static_cast<bool>(error);
  if (!error) routes_.push_back({{numeric, name_.port}, std::nullopt});
}

void NamedPeer::take(const std::vector<address>& addresses, Clock::time_point now) {
  looked_ = now;
  next_look_ = now + pause_;
  if (addresses.empty()) return;
  if (was_heard_since(now - peer_silence)) {
    next_look_ = std::max(next_look_, *heard_ + peer_silence);
  } else {
    pause_ = std::min(2 * pause_, slowest_look);
  }
  const address before = routes_.empty() ? address() : routes_[chosen_].to.address();
  routes_.clear();
  const auto add = [&](bool is_v4) {
    for (const address& one : addresses) {
      if (one.is_v4() == is_v4 && routes_.size() < max_peer_addresses && !is_at(one)) {
        routes_.push_back({{one, name_.port}, std::nullopt});
      }
    }
  };
  add(true);
  add(false);
  const auto same = std::ranges::find_if(routes_, [&](const Route& route) { return route.to.address() == before; });
  chosen_ = same == routes_.end() ? 0 : static_cast<std::size_t>(same - routes_.begin());
  if (same != routes_.end() && !was_heard_since(now - resolve_refresh)) chosen_ = (chosen_ + 1) % routes_.size();
}

void NamedPeer::find_routes(std::uint16_t port,
                            const std::function<std::optional<address>(const udp::endpoint&)>& via) {
  is_ourselves_ = false;
  for (Route& route : routes_) {
    route.via = via(route.to);
    is_ourselves_ = is_ourselves_ || (route.via == route.to.address() && route.to.port() == port);
  }
}

const Route* NamedPeer::route() const { return routes_.empty() || is_ourselves_ ? nullptr : &routes_[chosen_]; }

const Route* NamedPeer::find(const address& from) const {
  const auto found = std::ranges::find_if(routes_, [&](const Route& route) { return route.to.address() == from; });
  return found == routes_.end() ? nullptr : &*found;
}

std::optional<address> NamedPeer::via(const address& from) const {
  const Route* route = find(from);
  return route == nullptr ? std::nullopt : route->via;
}

void NamedPeer::heard_from(const address& from, Clock::time_point now) {
  const Route* route = find(from);
  if (route == nullptr) return;
  chosen_ = static_cast<std::size_t>(route - routes_.data());
  heard_ = now;
  next_look_ = std::min(looked_ + resolve_refresh, now + peer_silence);
  pause_ = resolve_retry;
}

}  // namespace geminga::env
