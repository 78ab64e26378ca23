// The delay until other hosts are told of a new or withdrawn service, and its cost for the whole team.
#include "bench/discovery/measures.hpp"
#include "bench/discovery/told.hpp"
#include "bench/table.hpp"
#include "bench/times.hpp"

namespace geminga::bench {
namespace {

/// The pause between two changes, in milliseconds: the copies of the last change are out, and no sender is throttled.
constexpr int pause_between = 1000;

/// The target for the slowest host at any loss.
constexpr double slowest_ms = 1000;

}  // namespace

void Measures::telling() {
  std::vector<double> added;
  std::vector<double> removed;
  (void)team_.departures();
  const auto before = team_.sent();
  const auto began = Clock::now();
  for (int change = 0; change < effort_.changes; ++change) {
    const auto id = static_cast<std::uint32_t>(100 + change);
    const auto host = static_cast<std::size_t>(change) % team_.size();
    const auto keep = [host](std::vector<double>& all, const std::vector<double>& times) {
      for (std::size_t other = 0; other < times.size(); ++other) {
        if (other != host) all.push_back(times[other]);
      }
      rest(pause_between);
    };
    keep(added, times_until_told(team_, host, "40 pub add ", [&] { team_.publish(host, id, "news"); }));
    keep(removed, times_until_told(team_, host, "40 pub del ", [&] { team_.withdraw(host, id); }));
  }
  const double time = milliseconds_since(began);
  const double octets = team_.sent().octets - before.octets - steady_octets_ * time;
  row("a new service told on another host, p50", quantile(added, 0.5), "ms", 0);
  row("a new service told on another host, p95", quantile(added, 0.95), "ms", targets_.told_ms);
  row("a new service told on another host, slowest", quantile(added, 1), "ms", slowest_ms);
  row("a withdrawn service told on another host, p95", quantile(removed, 0.95), "ms", targets_.told_ms);
  row("a withdrawn service told on another host, slowest", quantile(removed, 1), "ms", slowest_ms);
  const std::string of_change = "octets of all hosts for one change, without headers";
  if (octets > 0) {
    row(of_change, octets / (2 * effort_.changes), "B", targets_.change_octets);
  } else {
    row_without(of_change, size(), "lost in what the presences of so many vary by");
  }
  expect_right();
}

}  // namespace geminga::bench
