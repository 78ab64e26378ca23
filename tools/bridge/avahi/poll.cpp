#include "bridge/avahi/poll.hpp"

#include <fcntl.h>
#include <sys/time.h>

#include <algorithm>
#include <chrono>
#include <memory>

using geminga::client::Reactor;
using geminga::client::Socket;

// Avahi leaves these two to the event loop.

struct AvahiWatch {
  int descriptor = -1;  ///< Avahi's
  /// A copy, since D-Bus watches one descriptor twice and epoll takes each once.
  Socket copy;
  AvahiWatchCallback callback = nullptr;
  void* user = nullptr;
  AvahiWatchEvent happened{};
  Reactor::Watch watch{};
};

struct AvahiTimeout {
  AvahiTimeout(Reactor& its_reactor, AvahiTimeoutCallback its_callback, void* its_user)
      : reactor(its_reactor), timer(its_reactor, [this, its_callback, its_user] { its_callback(this, its_user); }) {}
  Reactor& reactor;
  Reactor::Timer timer;
};

namespace geminga::bridge {
namespace {

AvahiWatchEvent events(bool reads, bool writes) {
  // NOLINTNEXTLINE(clang-analyzer-optin.core.EnumCastOutOfRange): Avahi's enumeration names the bits of a set.
  return static_cast<AvahiWatchEvent>((reads ? AVAHI_WATCH_IN : 0) | (writes ? AVAHI_WATCH_OUT : 0));
}

void update_watch(AvahiWatch* watch, AvahiWatchEvent wanted) {
  watch->watch.want((wanted & AVAHI_WATCH_IN) != 0, (wanted & AVAHI_WATCH_OUT) != 0);
}

AvahiWatch* new_watch(const AvahiPoll* api, int descriptor, AvahiWatchEvent wanted, AvahiWatchCallback callback,
                      void* user) {
  Reactor& reactor = *static_cast<Reactor*>(api->userdata);
  auto watch = std::make_unique<AvahiWatch>();
  watch->descriptor = descriptor;
  watch->copy = Socket(::fcntl(descriptor, F_DUPFD_CLOEXEC, 0));
  watch->callback = callback;
  watch->user = user;
  AvahiWatch* const raw = watch.get();
  watch->watch = reactor.watch(watch->copy, [raw](Reactor::Ready ready) {
    raw->happened = events(ready.can_read, ready.can_write);
    raw->callback(raw, raw->descriptor, raw->happened, raw->user);  // may free the watch
  });
  update_watch(raw, wanted);
  return watch.release();
}

AvahiWatchEvent watch_events(AvahiWatch* watch) { return watch->happened; }

void free_watch(AvahiWatch* watch) {
  watch->watch.stop();
  delete watch;
}

/// Avahi states the wall clock's time; nothing: never.
base::Instant instant(const Reactor& reactor, const timeval* at) {
  if (at == nullptr) return base::never;
  timeval now{};
  ::gettimeofday(&now, nullptr);
  const auto wait =
      std::chrono::seconds(at->tv_sec - now.tv_sec) + std::chrono::microseconds(at->tv_usec - now.tv_usec);
  return reactor.now() + std::clamp<std::chrono::microseconds>(wait, std::chrono::seconds(0), std::chrono::hours(24));
}

AvahiTimeout* new_timeout(const AvahiPoll* api, const timeval* at, AvahiTimeoutCallback callback, void* user) {
  auto timeout = std::make_unique<AvahiTimeout>(*static_cast<Reactor*>(api->userdata), callback, user);
  timeout->timer.set(instant(timeout->reactor, at));
  return timeout.release();
}

void update_timeout(AvahiTimeout* timeout, const timeval* at) { timeout->timer.set(instant(timeout->reactor, at)); }

void free_timeout(AvahiTimeout* timeout) { delete timeout; }

}  // namespace

Poll::Poll(client::Reactor& reactor)
    : api_{.userdata = &reactor,
           .watch_new = new_watch,
           .watch_update = update_watch,
           .watch_get_events = watch_events,
           .watch_free = free_watch,
           .timeout_new = new_timeout,
           .timeout_update = update_timeout,
           .timeout_free = free_timeout} {}

}  // namespace geminga::bridge
