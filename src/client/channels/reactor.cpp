#include "client/channels/reactor.hpp"

#include <sys/epoll.h>
#include <sys/timerfd.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <system_error>
#include <vector>

namespace geminga::client {
namespace {

/// The sockets of one epoll_wait(), and how many of these one process() does.
constexpr int events_at_once = 64;
constexpr int rounds_at_once = 16;
/// The token of the timerfd.
constexpr std::uint64_t clock_token = 0;

}  // namespace

Reactor::Reactor(OnFailure on_failure, Clock clock)
    : on_failure_(std::move(on_failure)),
      clock_(std::move(clock)),
      poll_(::epoll_create1(EPOLL_CLOEXEC)),
      alarm_(::timerfd_create(CLOCK_MONOTONIC, TFD_CLOEXEC | TFD_NONBLOCK)) {
  epoll_event event{};
  event.events = EPOLLIN;
  event.data.u64 = clock_token;
  if (!poll_.is_open() || !alarm_.is_open() || ::epoll_ctl(poll_.get(), EPOLL_CTL_ADD, alarm_.get(), &event) != 0) {
    throw std::system_error(errno, std::generic_category(), "no descriptor is left for a node");
  }
}

Reactor::Watch& Reactor::Watch::operator=(Watch&& other) noexcept {
  if (this != &other) {
    stop();
    reactor_ = std::exchange(other.reactor_, nullptr);
    token_ = other.token_;
    socket_ = other.socket_;
    events_ = other.events_;
  }
  return *this;
}

void Reactor::Watch::want(bool reads, bool writes) {
  if (reactor_ == nullptr || !reactor_->is_own_process()) return;
  const std::uint32_t events = (reads ? EPOLLIN : 0U) | (writes ? EPOLLOUT : 0U);
  if (events == events_) return;
  events_ = events;
  epoll_event event{};
  event.events = events;
  event.data.u64 = token_;
  if (::epoll_ctl(reactor_->poll_.get(), EPOLL_CTL_MOD, socket_, &event) != 0) reactor_->fail();
}

void Reactor::Watch::stop() {
  if (reactor_ == nullptr) return;
  if (reactor_->is_own_process()) ::epoll_ctl(reactor_->poll_.get(), EPOLL_CTL_DEL, socket_, nullptr);
  reactor_->watched_.erase(token_);
  reactor_ = nullptr;
}

void Reactor::Timer::set(base::Instant at) {
  if (at == at_) return;
  if (at_ != base::never) reactor_.timers_.erase({at_, this});
  at_ = at;
  if (at_ != base::never) reactor_.timers_.insert({at_, this});
  reactor_.arm();
}

Reactor::Watch Reactor::watch(const Socket& socket, OnReady on_ready) {
  Watch watch;
  watch.token_ = ++last_token_;
  watch.socket_ = socket.get();
  watch.events_ = EPOLLIN;
  epoll_event event{};
  event.events = watch.events_;
  event.data.u64 = watch.token_;
  if (::epoll_ctl(poll_.get(), EPOLL_CTL_ADD, watch.socket_, &event) != 0) {
    fail();
    return watch;
  }
  watch.reactor_ = this;
  watched_.emplace(watch.token_, std::move(on_ready));
  return watch;
}

void Reactor::fail() { on_failure_("a socket cannot be watched: " + std::generic_category().message(errno)); }

base::Instant Reactor::system_time() {
  return base::Instant(std::chrono::duration_cast<base::Duration>(std::chrono::steady_clock::now().time_since_epoch()));
}

void Reactor::process() {
  if (!is_own_process()) return;
  std::array<epoll_event, events_at_once> events{};
  for (int round = 0; round < rounds_at_once; ++round) {
    const int count = ::epoll_wait(poll_.get(), events.data(), events_at_once, 0);
    for (int i = 0; i < count; ++i) {
      const epoll_event& event = events[static_cast<std::size_t>(i)];
      // The structure of the kernel is packed: no reference may lead into it.
      const std::uint64_t token = event.data.u64;
      if (token == clock_token) {
        std::uint64_t times = 0;
        [[maybe_unused]] const auto read = ::read(alarm_.get(), &times, sizeof times);
        armed_ = base::never;
        continue;
      }
      // A function that was called may have closed a socket of this round.
      const auto found = watched_.find(token);
      if (found == watched_.end()) continue;
      const OnReady on_ready = found->second;
      const bool has_met = (event.events & (EPOLLERR | EPOLLHUP)) != 0;
      on_ready({has_met || (event.events & EPOLLIN) != 0, has_met || (event.events & EPOLLOUT) != 0});
    }
    run_timers();
    if (count < events_at_once) break;
  }
}

void Reactor::run_timers() {
  const auto now = this->now();
  // A timer that is set again for this very instant is due with the next call.
  std::vector<std::pair<base::Instant, Timer*>> due(timers_.begin(),
                                                    timers_.lower_bound({now + base::Duration(1), nullptr}));
  for (const auto& one : due) {
    if (timers_.erase(one) == 0) continue;
    one.second->at_ = base::never;
    const auto action = one.second->action_;
    action();
  }
  arm();
}

void Reactor::arm() {
  const auto next = timers_.empty() ? base::never : timers_.begin()->first;
  if (next == armed_ || !is_own_process()) return;
  armed_ = next;
  itimerspec when{};
  if (next != base::never) {
    const auto since = std::max(next.time_since_epoch(), base::Duration(1));
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(since);
    when.it_value.tv_sec = static_cast<time_t>(seconds.count());
    when.it_value.tv_nsec = static_cast<long>((since - seconds).count());
  }
  ::timerfd_settime(alarm_.get(), TFD_TIMER_ABSTIME, &when, nullptr);
}

}  // namespace geminga::client
