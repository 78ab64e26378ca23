// The connection to avahi-daemon over the system's D-Bus, which comes back by itself.
#ifndef GEMINGA_BRIDGE_AVAHI_CONNECTION_HPP
#define GEMINGA_BRIDGE_AVAHI_CONNECTION_HPP

#include <avahi-client/client.h>

#include <functional>
#include <string>

#include "bridge/avahi/poll.hpp"
#include "client/channels/reactor.hpp"

namespace geminga::bridge {

/// Neither copies nor moves. The reactor must outlive it.
class Connection {
 public:
  struct Told {
    std::function<void(AvahiClient*)> ready;  ///< Avahi has its host name and takes services
    /// The host name is being changed: services of ours have to be taken back.
    std::function<void()> renaming;
    /// Avahi or the bus is gone. Objects of the client have to be freed before this returns.
    std::function<void()> lost;
    std::function<void(const std::string& line)> log;
  };

  Connection(client::Reactor& reactor, Told told);
  ~Connection();
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  void start();

 private:
  void on_state(AvahiClientState state);
  void lose(const std::string& why);
  void tell_once(const std::string& line);
  void restart();

  client::Reactor& reactor_;
  Told told_;
  Poll poll_;
  AvahiClient* client_ = nullptr;
  bool is_ready_ = false;
  std::string last_line_;
  client::Reactor::Timer timer_;
};

}  // namespace geminga::bridge

#endif
