// The effect of killed daemons and parted networks on a team, and the time until all views are right again.
#include <algorithm>
#include <csignal>

#include "bench/discovery/measures.hpp"
#include "bench/times.hpp"

namespace geminga::bench {
namespace {

/// The target for a restart at any loss: the time from the start of the new daemon until all views are right.
constexpr double restart_ms = 200;

}  // namespace

void Measures::death() {
  const std::size_t victim = team_.size() - 1;
  (void)team_.departures();
  const auto began = Clock::now();
  (void)team_.end(victim, SIGKILL);
  double slowest = 0;
  for (std::size_t host = 0; host < victim; ++host) {
    if (!team_.module(host).line_with({" pub del ", "reason=expired"})) complain("a death that is told");
    slowest = std::max(slowest, milliseconds_since(began));
  }
  row("a death told on all hosts", slowest, "ms", targets_.death_ms);
  team_.start(victim);
  expect_right();
}

void Measures::restart() {
  std::vector<double> times;
  for (std::size_t host = 0; host < 3; ++host) {
    (void)team_.end(host, SIGKILL);
    const auto began = Clock::now();
    team_.start(host);
    team_.publish(host, 90, "reborn");  // so that nobody is right who knows only the life before
    expect_right();
    times.push_back(milliseconds_since(began));
    team_.withdraw(host, 90);
    expect_right();
    rest(1000);
  }
  row("all right after a kill and a restart, slowest of 3", quantile(times, 1), "ms", restart_ms);
}

void Measures::partition() {
  if (!system::Lab::can_lose()) return;
  const std::size_t last = team_.size() - 1;
  team_.lab().part(team_.size() / 2);
  team_.withdraw(0, 10);
  team_.publish(last, 90, "one");
  team_.publish(last, 91, "two");
  rest(effort_.partition_seconds * 1000);
  team_.lab().heal();
  const auto began = Clock::now();
  expect_right();
  row("all right after a partition of " + std::to_string(effort_.partition_seconds) + " s", milliseconds_since(began),
      "ms", targets_.healed_ms);
}

}  // namespace geminga::bench
