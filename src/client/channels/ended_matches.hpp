// Providers over TCP that have ended while the daemon still matches them (src/client/CHANNELS.md, How a channel ends).
#ifndef GEMINGA_CLIENT_CHANNELS_ENDED_MATCHES_HPP
#define GEMINGA_CLIENT_CHANNELS_ENDED_MATCHES_HPP

#include <functional>
#include <map>

#include "client/channels/reactor.hpp"
#include "geminga/event.hpp"
#include "geminga/service.hpp"

namespace geminga::client {

/// Gives a match back when again_patience has passed and the daemon has not taken it back. Neither copies nor moves.
class EndedMatches {
 public:
  /// Takes the last event about a match, told as an `add`. May call every function of its EndedMatches.
  using GiveBack = std::function<void(const ServiceEvent&)>;

  EndedMatches(Reactor& reactor, GiveBack give_back);

  /// The provider of this event has ended.
  void keep(const ServiceEvent& event);
  /// The daemon says something else of a match, if it is kept.
  void modify(const ServiceEvent& event);
  /// The daemon has taken a match back, or states it anew.
  void forget(const ServiceKey& service) { ended_.erase(service); }
  /// The daemon is gone.
  void forget_all() { ended_.clear(); }

 private:
  struct Ended {
    ServiceEvent event;
    base::Instant until;
  };

  void give_due_back();

  Reactor& reactor_;
  GiveBack give_back_;
  std::map<ServiceKey, Ended> ended_;
  Reactor::Timer timer_;
};

}  // namespace geminga::client

#endif
