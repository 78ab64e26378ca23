#include "bench/discovery/relays.hpp"

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <map>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "bench/discovery/measures.hpp"
#include "bench/discovery/told.hpp"
#include "bench/table.hpp"

namespace geminga::bench {
namespace {

using system::Lab;

/// The numbers of hosts: so many on each of three links, in the order of the links, and the router behind them.
struct Hosts {
  std::size_t on_link;

  [[nodiscard]] std::size_t robots() const { return 3 * on_link; }
  [[nodiscard]] std::size_t near_relay() const { return on_link - 1; }       ///< on the first link and on the second
  [[nodiscard]] std::size_t inner_relay() const { return 2 * on_link - 1; }  ///< on the second link, behind the router
  [[nodiscard]] std::size_t outer_relay() const { return 2 * on_link; }      ///< on the third link
  [[nodiscard]] std::size_t router() const { return robots(); }              ///< it has no daemon
  [[nodiscard]] bool is_relay(std::size_t host) const {
    return host == near_relay() || host == inner_relay() || host == outer_relay();
  }
  /// The relays between two hosts, which are no relays themselves.
  [[nodiscard]] std::size_t relays_between(std::size_t one, std::size_t other) const {
    const std::size_t lower = std::min(one, other) / on_link;
    const std::size_t upper = std::max(one, other) / on_link;
    const std::size_t over_first = lower == 0 && upper > 0 ? 1 : 0;
    return over_first + (lower < 2 && upper == 2 ? 2U : 0U);
  }
  [[nodiscard]] std::vector<std::size_t> of_link(std::size_t link) const {
    std::vector<std::size_t> hosts(on_link);
    std::iota(hosts.begin(), hosts.end(), link * on_link);
    return hosts;
  }
};

// In the order in which they are added; the first link of all hosts is 0.
constexpr std::size_t second_link = 1;
constexpr std::size_t third_link = 2;
constexpr std::size_t inner_link = 3;  ///< of the inner relay and the router alone

/// The targets: p95 over one relay and over two, and a relay's restart.
constexpr double one_relay_ms = 60;
constexpr double two_relays_ms = 120;
constexpr double healed_ms = 1000;
/// The pause until the copies of a change are out, in milliseconds.
constexpr int between_changes = 1000;

/// A file of a key, which goes with it.
class TeamKey {
 public:
  TeamKey() : path_(std::filesystem::temp_directory_path() / ("relays-" + std::to_string(::getpid()) + ".key")) {
    const auto made = system::run(
        {.words = {system::program("gemingad"), "--generate-key", path_.string()}, .environment = {}, .before = {}});
    if (made.status != 0) std::cerr << made.said;
  }
  ~TeamKey() { std::filesystem::remove(path_); }
  TeamKey(const TeamKey&) = delete;
  TeamKey& operator=(const TeamKey&) = delete;
  [[nodiscard]] std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

std::vector<std::string> flags_of(const Hosts& hosts, std::size_t host, const std::string& key) {
  std::vector<std::string> flags{"--key-file", key};
  if (hosts.is_relay(host)) flags.emplace_back("--relay");
  if (host == hosts.inner_relay()) {
    flags.insert(flags.end(), {"--peer", Lab::address_on(third_link, hosts.outer_relay())});
  }
  if (host == hosts.outer_relay()) flags.insert(flags.end(), {"--peer", Lab::address_on(third_link, hosts.router())});
  return flags;
}

void lay_links(Lab& lab, const Hosts& hosts) {
  lab.add_link(hosts.near_relay(), hosts.of_link(second_link));
  lab.add_link(hosts.router(), hosts.of_link(third_link));
  lab.add_link(hosts.inner_relay(), {hosts.router()});
  lab.translate(hosts.router(), "wlan2", Lab::address_on(inner_link, hosts.inner_relay()));
  lab.route(hosts.inner_relay(), "10.47.19.0/24", Lab::address_on(inner_link, hosts.router()));
}

}  // namespace

bool measure_relays(double loss, const RelayEffort& effort) {
  const TeamKey key;
  const Hosts hosts{effort.on_link};
  system::LabTeam team(hosts.robots(), 1, [&](std::size_t host) { return flags_of(hosts, host, key.path()); });
  lay_links(team.lab(), hosts);
  if (loss > 0) team.lab().lose(loss);
  const std::string size =
      "3 x " + std::to_string(effort.on_link) + ", loss " + std::to_string(static_cast<int>(loss * 100)) + " %";
  bool is_right = true;
  const auto expect_right = [&](const std::string& when) {
    if (team.wait_until_right()) return;
    is_right = false;
    std::cerr << when << ": " << team.knowledge(0);
  };
  auto began = Clock::now();
  team.start_together();
  expect_right("start");
  row("three links: all started know each other", size, milliseconds_since(began), "ms");
  rest(effort.settling);
  (void)team.departures();
  rest(effort.quiet_seconds * 1000);
  row("three links: departures of the living in " + std::to_string(effort.quiet_seconds) + " s", size,
      static_cast<double>(team.departures()), "", {.limit = 0});
  std::map<std::size_t, std::vector<double>> told;  // by the number of relays between
  for (int change = 0; change < effort.changes; ++change) {
    const std::size_t host = (static_cast<std::size_t>(change) % 3) * hosts.on_link + hosts.on_link / 3;
    const auto id = static_cast<std::uint32_t>(100 + change);
    const auto times = times_until_told(team, host, "40 pub add ", [&] { team.publish(host, id, "news"); });
    for (std::size_t other = 0; other < hosts.robots(); ++other) {
      if (other != host && !hosts.is_relay(other)) told[hosts.relays_between(host, other)].push_back(times[other]);
    }
    rest(between_changes);
  }
  for (const auto& [relays, times] : told) {
    const double limit = relays == 1 ? one_relay_ms : relays == 2 ? two_relays_ms : 0;
    row("three links: a new service told, relays between: " + std::to_string(relays) + ", p50", size,
        quantile(times, 0.5), "ms");
    row("three links: a new service told, relays between: " + std::to_string(relays) + ", p95", size,
        quantile(times, 0.95), "ms", {.limit = limit});
  }
  (void)team.end(hosts.near_relay(), SIGKILL);
  rest(effort.until_given_up);
  began = Clock::now();
  team.start(hosts.near_relay());
  expect_right("restart of a relay");
  row("three links: all right after a relay's restart", size, milliseconds_since(began), "ms", {.limit = healed_ms});
  return is_right;
}

}  // namespace geminga::bench
