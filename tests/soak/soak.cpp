#include "soak/soak.hpp"

#include <poll.h>

#include <algorithm>
#include <csignal>
#include <cstdio>

#include "support/process_figures.hpp"

namespace geminga::soak {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

/// A time longer than a deadline, so that in some rounds the others give a robot up before it comes back.
constexpr milliseconds longest_away{9000};

/// The growth of the allocator that is allowed after the first tenth of the time. One forgotten incarnation of a robot
/// takes a few kilobytes, and an hour has some thousand incarnations. A sanitizer keeps freed memory: its quarantine
/// has 256 MB.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr double allowed_growth_mb = 256;
#else
constexpr double allowed_growth_mb = 1;
#endif

/// The service that comes and goes.
constexpr std::uint32_t changing_id = 90;

}  // namespace

Soak::Soak(const Plan& plan) : plan_(plan), random_(plan.seed), team_(plan.hosts), told_(plan.hosts) {
  if (!system::Lab::can_lose()) plan_.loss = 0;
  if (plan_.loss > 0) team_.lab().lose(plan_.loss);
}

void Soak::run() {
  began_ = Clock::now();
  team_.start_together();
  expect_right();
  slowest_ = {};  // the first time it was waited for what the team is told
  std::printf("%zu robots, %.0f %% loss, seed %llu: each module is told of %zu services\n", team_.size(),
              plan_.loss * 100, static_cast<unsigned long long>(plan_.seed), *all_told_);
  while (round_ < plan_.rounds && Clock::now() - began_ < plan_.time) round();
  report();
}

void Soak::round() {
  ++round_;
  end_some();
  change_services();
  if (random_.below(2) == 0) rest(longest_away);
  for (std::size_t host = 0; host < team_.size(); ++host) {
    if (team_.is_running(host)) continue;
    team_.start(host);
    rest(milliseconds(200));
  }
  expect_right();
  expect_no_growth();
  if (Clock::now() - began_ >= reported_ + std::chrono::minutes(1)) {
    reported_ = std::chrono::floor<std::chrono::minutes>(Clock::now() - began_);
    report();
  }
}

void Soak::end_some() {
  const std::size_t victims = 1 + random_.below(team_.size() / 2);
  for (std::size_t i = 0; i < victims; ++i) {
    const std::size_t host = 1 + random_.below(team_.size() - 1);
    if (!team_.is_running(host)) continue;
    const bool is_killed = random_.below(4) != 0;
    ++(is_killed ? killed_ : stopped_);
    told_[host] = {};
    if (!team_.end(host, is_killed ? SIGKILL : SIGTERM)) {
      throw Failure("robot" + std::to_string(host) + " ended by itself, or not at its signal:\n" +
                    team_.lab().daemon(host).said());
    }
    rest(milliseconds(500));
  }
}

void Soak::change_services() {
  const std::size_t host = random_.below(team_.size());
  if (!team_.is_running(host)) return;
  team_.publish(host, changing_id, "news");
  rest(milliseconds(500));
  team_.withdraw(host, changing_id);
}

void Soak::expect_right() {
  const auto began = Clock::now();
  if (!team_.wait_until_right()) {
    for (std::size_t host = 0; host < team_.size(); ++host) {
      std::fprintf(stderr, "robot%zu:\n%s", host, team_.knowledge(host).c_str());
    }
    throw Failure("not all robots know exactly the team");
  }
  expect_told();
  slowest_ = std::max(slowest_, std::chrono::ceil<milliseconds>(Clock::now() - began));
}

void Soak::expect_told() {
  // A team must be told again exactly what a team is told that was never harmed.
  const auto until = Clock::now() + (all_told_ ? system::patience : std::chrono::seconds(1));
  for (std::size_t host = 0; host < team_.size(); ++host) {
    Told& told = told_[host];
    do {
      for (const std::string& line : team_.module(host).lines_until_pong()) told.hear(line);
    } while (told.size() != all_told_ && Clock::now() < until && ::poll(nullptr, 0, 20) == 0);
    if (!told.faults().empty()) throw Failure("robot" + std::to_string(host) + ": " + told.faults().front());
    if (!all_told_) all_told_ = told.size();
    if (told.size() != *all_told_) {
      throw Failure("robot" + std::to_string(host) + " was told of " + std::to_string(told.size()) + " services, not " +
                    std::to_string(*all_told_));
    }
  }
}

Soak::Figures Soak::figures() {
  const pid_t daemon = team_.lab().daemon(0).pid();
  return {system::anonymous_mb(daemon), system::descriptors(daemon)};
}

void Soak::expect_no_growth() {
  team_.lab().daemon(0).listen();
  if (Clock::now() - began_ < plan_.time / 10 && round_ < plan_.rounds / 10) return;
  const Figures now = figures();
  if (!at_first_) at_first_ = now;
  if (now.memory_mb > at_first_->memory_mb + allowed_growth_mb) {
    throw Failure("the memory of robot0 grew from " + std::to_string(at_first_->memory_mb) + " to " +
                  std::to_string(now.memory_mb) + " MB");
  }
  if (now.descriptors > at_first_->descriptors) {
    throw Failure("the descriptors of robot0 grew from " + std::to_string(at_first_->descriptors) + " to " +
                  std::to_string(now.descriptors));
  }
}

void Soak::report() {
  const Figures now = figures();
  std::printf(
      "%3ld min: %zu rounds, %zu killed, %zu stopped, all right after %ld ms at the most; robot0: %.1f MB, %zu "
      "descriptors\n",
      std::chrono::floor<std::chrono::minutes>(Clock::now() - began_).count(), round_, killed_, stopped_,
      slowest_.count(), now.memory_mb, now.descriptors);
}

void Soak::rest(milliseconds longest) {
  ::poll(nullptr, 0, static_cast<int>(random_.below(static_cast<std::uint64_t>(longest.count()))));
}

}  // namespace geminga::soak
