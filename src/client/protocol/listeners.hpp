// The listeners of a stream over UDP: those that said hello within the last seconds.
#ifndef GEMINGA_CLIENT_PROTOCOL_LISTENERS_HPP
#define GEMINGA_CLIENT_PROTOCOL_LISTENERS_HPP

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "base/time.hpp"
#include "client/protocol/limits.hpp"
#include "client/protocol/peer_address.hpp"
#include "client/protocol/places.hpp"
#include "geminga/channel.hpp"

namespace geminga::client {

/// At most max_listeners, which share their places by address. All but expire() and next_end() is logarithmic, and
/// linear in the addresses where all places are taken.
class Listeners {
 public:
  struct Listener {
    PeerAddress address;
    Life life = no_life;
    std::uint64_t challenge = 0;
    std::uint64_t counter = 0;  ///< of its last sealed frame
    base::Instant until{};
    Places::Number place = 0;
  };
  struct Added {
    bool is_added = false;
    std::optional<Listener> loser{};  ///< has lost its place to the new one
  };

  /// The listener at this address; null if there is none.
  [[nodiscard]] Listener* find(const PeerAddress& address) {
    const auto found = listeners_.find(address);
    return found == listeners_.end() ? nullptr : &found->second;
  }
  /// Adds a listener in the place of one with the same address.
  Added add(Listener listener, base::Instant now) {
    end(listener.address);
    listener.place = ++last_;
    listener.until = now + listener_patience;
    const auto given = places_.take(listener.place, listener.address);
    Added added{given.is_taken, {}};
    if (given.loser) {
      added.loser = listeners_.extract(by_place_.extract(*given.loser).mapped()).mapped();
    }
    if (!given.is_taken) return added;
    by_place_[listener.place] = listener.address;
    listeners_[listener.address] = listener;
    return added;
  }
  void end(const PeerAddress& address) {
    const auto found = listeners_.find(address);
    if (found == listeners_.end()) return;
    places_.leave(found->second.place);
    by_place_.erase(found->second.place);
    listeners_.erase(found);
  }
  void expire(base::Instant now) {
    std::vector<PeerAddress> over;
    for (const auto& [address, listener] : listeners_) {
      if (listener.until <= now) over.push_back(address);
    }
    for (const PeerAddress& address : over) end(address);
  }
  /// The next instant at which one falls silent.
  [[nodiscard]] base::Instant next_end() const {
    base::Instant next = base::never;
    for (const auto& [address, listener] : listeners_) next = std::min(next, listener.until);
    return next;
  }
  [[nodiscard]] const std::map<PeerAddress, Listener>& all() const { return listeners_; }
  [[nodiscard]] const Places& places() const { return places_; }

 private:
  Places places_{max_listeners};
  std::map<PeerAddress, Listener> listeners_;
  std::map<Places::Number, PeerAddress> by_place_;
  Places::Number last_ = 0;
};

}  // namespace geminga::client

#endif
