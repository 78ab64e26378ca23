// Sockets and timers behind one descriptor: a function is called when one is ready.
#ifndef GEMINGA_CLIENT_CHANNELS_REACTOR_HPP
#define GEMINGA_CLIENT_CHANNELS_REACTOR_HPP

#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>

#include "base/time.hpp"
#include "client/channels/process_mark.hpp"
#include "client/channels/socket.hpp"

namespace geminga::client {

/// An epoll descriptor with a timerfd in it, level-triggered. Functions are called within process() only. Not
/// thread-safe. In a process that was forked from its own it does nothing, because the system's descriptors are shared.
class Reactor {
 public:
  /// Whether a socket can be read, or written. An error of the socket counts as both.
  struct Ready {
    bool can_read = false;
    bool can_write = false;
  };
  using OnReady = std::function<void(Ready)>;

  /// Watches a socket while it lives. Moves and does not copy; the reactor must outlive it.
  class Watch {
   public:
    Watch() = default;
    Watch(Watch&& other) noexcept
        : reactor_(std::exchange(other.reactor_, nullptr)), token_(other.token_), socket_(other.socket_) {}
    Watch& operator=(Watch&& other) noexcept;
    ~Watch() { stop(); }
    /// Says what is waited for: reads, writes, both or neither.
    void want(bool reads, bool writes);
    /// Ends the watch; before the socket is closed.
    void stop();

   private:
    friend Reactor;
    Reactor* reactor_ = nullptr;
    std::uint64_t token_ = 0;
    int socket_ = -1;
    std::uint32_t events_ = 0;
  };

  /// Calls a function once at an instant. Neither copies nor moves; the reactor must outlive it.
  class Timer {
   public:
    Timer(Reactor& reactor, std::function<void()> action) : reactor_(reactor), action_(std::move(action)) {}
    ~Timer() { set(base::never); }
    Timer(const Timer&) = delete;
    Timer& operator=(const Timer&) = delete;
    /// Sets the instant in the place of the former one; base::never for none.
    void set(base::Instant at);
    [[nodiscard]] base::Instant at() const { return at_; }

   private:
    friend Reactor;
    Reactor& reactor_;
    std::function<void()> action_;
    base::Instant at_ = base::never;
  };

  /// Called with the system's reason when a socket cannot be watched. Nothing is read from that socket.
  using OnFailure = std::function<void(std::string)>;

  using Clock = std::function<base::Instant()>;
  /// The system's monotonic clock.
  [[nodiscard]] static base::Instant system_time();

  /// With another clock than the system's, timers run in process() alone, and descriptor() does not know of them.
  explicit Reactor(OnFailure on_failure, Clock clock = system_time);

  /// Watches a socket for reading. A failure goes to `on_failure`, and the result watches nothing.
  [[nodiscard]] Watch watch(const Socket& socket, OnReady on_ready);
  /// Readable when process() has something to do.
  [[nodiscard]] int descriptor() const { return poll_.get(); }
  /// Calls the functions of what is ready and due, a bounded number of times. Never waits.
  void process();
  /// The present instant, by `clock`.
  [[nodiscard]] base::Instant now() const { return clock_(); }
  [[nodiscard]] bool is_own_process() const { return process_.is_own(); }

 private:
  void run_timers();
  void arm();
  /// Reports the failure that errno names.
  void fail();

  OnFailure on_failure_;
  Clock clock_;
  ProcessMark process_;
  Socket poll_;
  Socket alarm_;
  std::unordered_map<std::uint64_t, OnReady> watched_;
  std::set<std::pair<base::Instant, Timer*>> timers_;
  std::uint64_t last_token_ = 0;
  base::Instant armed_ = base::never;
};

}  // namespace geminga::client

#endif
