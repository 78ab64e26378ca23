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

constexpr std::size_t on_link = 10;
constexpr std::size_t robots = 3 * on_link;
constexpr std::size_t near_relay = on_link - 1;       ///< on the first link and on the second
constexpr std::size_t inner_relay = 2 * on_link - 1;  ///< on the second link, behind the router
constexpr std::size_t outer_relay = 2 * on_link;      ///< on the third link
constexpr std::size_t router = robots;                ///< it has no daemon
// In the order in which they are added; the first link of all hosts is 0.
constexpr std::size_t second_link = 1;
constexpr std::size_t third_link = 2;
constexpr std::size_t inner_link = 3;  ///< of the inner relay and the router alone

/// The targets: p95 over one relay and over two, and a relay's restart.
constexpr double one_relay_ms = 60;
constexpr double two_relays_ms = 120;
constexpr double healed_ms = 1000;
/// Pauses, in milliseconds: the copies of a change are out; all have noticed a death; a team has settled.
constexpr int between_changes = 1000;
constexpr int until_given_up = 20000;
constexpr int settling = 5000;

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

std::vector<std::string> flags_of(std::size_t host, const std::string& key) {
  std::vector<std::string> flags{"--key-file", key};
  if (host == near_relay || host == inner_relay || host == outer_relay) flags.emplace_back("--relay");
  if (host == inner_relay) flags.insert(flags.end(), {"--peer", Lab::address_on(third_link, outer_relay)});
  if (host == outer_relay) flags.insert(flags.end(), {"--peer", Lab::address_on(third_link, router)});
  return flags;
}

std::vector<std::size_t> hosts_of(std::size_t link) {
  std::vector<std::size_t> hosts(on_link);
  std::iota(hosts.begin(), hosts.end(), link * on_link);
  return hosts;
}

void lay_links(Lab& lab) {
  lab.add_link(near_relay, hosts_of(second_link));
  lab.add_link(router, hosts_of(third_link));
  lab.add_link(inner_relay, {router});
  lab.translate(router, "wlan2", Lab::address_on(inner_link, inner_relay));
  lab.route(inner_relay, "10.47.19.0/24", Lab::address_on(inner_link, router));
}

/// The relays between two hosts, which are no relays themselves.
std::size_t relays_between(std::size_t one, std::size_t other) {
  const std::size_t lower = std::min(one, other) / on_link;
  const std::size_t upper = std::max(one, other) / on_link;
  const std::size_t over_first = lower == 0 && upper > 0 ? 1 : 0;
  return over_first + (lower < third_link && upper == third_link ? 2U : 0U);
}

bool is_relay(std::size_t host) { return host == near_relay || host == inner_relay || host == outer_relay; }

}  // namespace

void measure_relays(double loss, int changes, int quiet_seconds) {
  const TeamKey key;
  system::LabTeam team(robots, 1, [&](std::size_t host) { return flags_of(host, key.path()); });
  lay_links(team.lab());
  if (loss > 0) team.lab().lose(loss);
  const std::string size =
      "3 x " + std::to_string(on_link) + ", loss " + std::to_string(static_cast<int>(loss * 100)) + " %";
  const auto expect_right = [&](const std::string& when) {
    if (!team.wait_until_right()) std::cerr << when << ": " << team.knowledge(0);
  };
  auto began = Clock::now();
  team.start_together();
  expect_right("start");
  row("three links: all started know each other", size, milliseconds_since(began), "ms");
  rest(settling);
  (void)team.departures();
  rest(quiet_seconds * 1000);
  row("three links: departures of the living in " + std::to_string(quiet_seconds) + " s", size,
      static_cast<double>(team.departures()), "", {.limit = 0});
  std::map<std::size_t, std::vector<double>> told;  // by the number of relays between
  for (int change = 0; change < changes; ++change) {
    const std::size_t host = (static_cast<std::size_t>(change) % 3) * on_link + 3;
    const auto id = static_cast<std::uint32_t>(100 + change);
    const auto times = times_until_told(team, host, "40 pub add ", [&] { team.publish(host, id, "news"); });
    for (std::size_t other = 0; other < robots; ++other) {
      if (other != host && !is_relay(other)) told[relays_between(host, other)].push_back(times[other]);
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
  (void)team.end(near_relay, SIGKILL);
  rest(until_given_up);
  began = Clock::now();
  team.start(near_relay);
  expect_right("restart of a relay");
  row("three links: all right after a relay's restart", size, milliseconds_since(began), "ms", {.limit = healed_ms});
}

}  // namespace geminga::bench
