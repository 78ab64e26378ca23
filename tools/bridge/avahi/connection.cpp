#include "bridge/avahi/connection.hpp"

#include <avahi-common/error.h>

#include <utility>

#include "bridge/avahi/limits.hpp"

namespace geminga::bridge {

Connection::Connection(client::Reactor& reactor, Told told)
    : reactor_(reactor), told_(std::move(told)), poll_(reactor), timer_(reactor, [this] { restart(); }) {}

Connection::~Connection() {
  if (client_ == nullptr) return;
  told_.lost();
  avahi_client_free(client_);
}

void Connection::start() { restart(); }

void Connection::restart() {
  if (client_ != nullptr) {
    told_.lost();
    avahi_client_free(std::exchange(client_, nullptr));
  }
  is_ready_ = false;
  int error = 0;
  const auto on_change = [](AvahiClient* client, AvahiClientState state, void* user) {
    // The library calls this within avahi_client_new(), too, which may still fail and free the client.
    auto& self = *static_cast<Connection*>(user);
    if (client == self.client_) self.on_state(state);
  };
  AvahiClient* const client = avahi_client_new(poll_.api(), AVAHI_CLIENT_NO_FAIL, on_change, this, &error);
  if (client == nullptr) return lose(avahi_strerror(error));
  client_ = client;
  on_state(avahi_client_get_state(client));
}

void Connection::on_state(AvahiClientState state) {
  switch (state) {
    case AVAHI_CLIENT_S_RUNNING:
      last_line_.clear();
      if (!std::exchange(is_ready_, true)) told_.log("Avahi is there");
      return told_.ready(client_);
    case AVAHI_CLIENT_S_REGISTERING:
    case AVAHI_CLIENT_S_COLLISION:
      return told_.renaming();
    case AVAHI_CLIENT_CONNECTING:
      return tell_once("no Avahi on the system's bus: start avahi-daemon");
    case AVAHI_CLIENT_FAILURE:
      return lose(avahi_strerror(avahi_client_errno(client_)));
  }
}

void Connection::lose(const std::string& why) {
  tell_once("Avahi is away (" + why + "): start dbus and avahi-daemon");
  timer_.set(reactor_.now() + avahi_pause);  // not here: the library is within its client
}

void Connection::tell_once(const std::string& line) {
  if (std::exchange(last_line_, line) != line) told_.log(line);
}

}  // namespace geminga::bridge
