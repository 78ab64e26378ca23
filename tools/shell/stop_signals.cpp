#include "shell/stop_signals.hpp"

#include <poll.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <limits>

namespace geminga::shell {
namespace {

constexpr std::array<int, 3> stopping_signals{SIGINT, SIGTERM, SIGHUP};

sigset_t stopping() {
  sigset_t set;
  sigemptyset(&set);
  for (const int signal : stopping_signals) sigaddset(&set, signal);
  return set;
}

}  // namespace

StopSignals::StopSignals() {
  const sigset_t set = stopping();
  sigprocmask(SIG_BLOCK, &set, nullptr);
  signals_ = signalfd(-1, &set, SFD_CLOEXEC | SFD_NONBLOCK);
}

StopSignals::~StopSignals() {
  take_pending();  // a pending signal would end the program when it is unblocked
  if (signals_ >= 0) close(signals_);
  const sigset_t set = stopping();
  sigprocmask(SIG_UNBLOCK, &set, nullptr);
}

void StopSignals::take_pending() const {
  signalfd_siginfo pending{};
  while (read(signals_, &pending, sizeof pending) == sizeof pending) {
  }
}

int StopSignals::pending() {
  sigset_t set;
  sigemptyset(&set);
  sigpending(&set);
  const auto* const come =
      std::ranges::find_if(stopping_signals, [&](int signal) { return sigismember(&set, signal) == 1; });
  return come == stopping_signals.end() ? 0 : *come;
}

StopSignals::Woken StopSignals::wait(int descriptor, std::optional<std::chrono::milliseconds> timeout,
                                     int other) const {
  using Steady = std::chrono::steady_clock;
  const auto begin = Steady::now();
  std::array<pollfd, 3> watched{{{signals_, POLLIN, 0}, {descriptor, POLLIN, 0}, {other, POLLIN, 0}}};
  while (true) {
    int milliseconds = -1;
    if (timeout) {
      const auto left = *timeout - std::chrono::duration_cast<std::chrono::milliseconds>(Steady::now() - begin);
      milliseconds = static_cast<int>(std::clamp<std::int64_t>(left.count(), 0, std::numeric_limits<int>::max()));
    }
    const int ready = poll(watched.data(), watched.size(), milliseconds);
    if (ready < 0 && errno == EINTR) continue;
    if (watched[0].revents != 0) return Woken::stopped;
    if (watched[1].revents != 0 || watched[2].revents != 0) return Woken::readable;
    return Woken::timed_out;
  }
}

}  // namespace geminga::shell
