// The listeners of a stream over UDP: those that said hello within the last seconds.
#ifndef GEMINGA_CLIENT_PROTOCOL_LISTENERS_HPP
#define GEMINGA_CLIENT_PROTOCOL_LISTENERS_HPP

#include <algorithm>
#include <vector>

#include "base/time.hpp"
#include "client/protocol/limits.hpp"
#include "client/protocol/peer_address.hpp"

namespace geminga::client {

/// At most max_listeners, in the order in which they came. One more is not heard until one has fallen silent.
class Listeners {
 public:
  struct Listener {
    PeerAddress address;
    base::Instant until;
  };

  /// Adds a listener, or renews it. False if there is no room for one more.
  bool hello(const PeerAddress& address, base::Instant now) {
    const auto known = std::ranges::find(listeners_, address, &Listener::address);
    if (known != listeners_.end()) {
      known->until = now + listener_patience;
      return true;
    }
    if (listeners_.size() == max_listeners) return false;
    listeners_.push_back({address, now + listener_patience});
    return true;
  }
  void end(const PeerAddress& address) {
    std::erase_if(listeners_, [&](const Listener& one) { return one.address == address; });
  }
  void expire(base::Instant now) {
    std::erase_if(listeners_, [now](const Listener& one) { return one.until <= now; });
  }
  /// The next instant at which one falls silent.
  [[nodiscard]] base::Instant next_end() const {
    base::Instant next = base::never;
    for (const Listener& one : listeners_) next = std::min(next, one.until);
    return next;
  }
  [[nodiscard]] const std::vector<Listener>& all() const { return listeners_; }

 private:
  std::vector<Listener> listeners_;
};

}  // namespace geminga::client

#endif
