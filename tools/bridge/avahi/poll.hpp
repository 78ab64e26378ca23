// The event loop that libavahi-client asks for, over the reactor of the client library.
#ifndef GEMINGA_BRIDGE_AVAHI_POLL_HPP
#define GEMINGA_BRIDGE_AVAHI_POLL_HPP

#include <avahi-common/watch.h>

#include "client/channels/reactor.hpp"

namespace geminga::bridge {

/// Watches descriptors and times for Avahi. The library's objects must end before it, and the reactor outlive it.
/// Neither copies nor moves.
class Poll {
 public:
  explicit Poll(client::Reactor& reactor);
  Poll(const Poll&) = delete;
  Poll& operator=(const Poll&) = delete;

  [[nodiscard]] const AvahiPoll* api() const { return &api_; }

 private:
  AvahiPoll api_{};
};

}  // namespace geminga::bridge

#endif
