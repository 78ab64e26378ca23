// A newcomer that has nothing but a server of NATS between itself and a site of whole daemons behind a relay.
#include "bench/discovery/over_server.hpp"

#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <deque>
#include <string>
#include <vector>

#include "bench/discovery/measures.hpp"
#include "bench/table.hpp"
#include "bench/times.hpp"
#include "support/lab.hpp"
#include "system/folder.hpp"

namespace geminga::bench {
namespace {

using system::Lab;
using system::Process;
using system::Talk;

constexpr const char* server_program = "/usr/sbin/nats-server";
constexpr int services_of_host = 9;
constexpr int joinings = 5;

/// The flags of a daemon that has a bridge as its peer.
std::vector<std::string> beside_bridge(std::vector<std::string> flags) {
  flags.insert(flags.end(), {"--interface", "lo", "--peer", "127.0.0.1:4720"});
  return flags;
}

/// Octets that the host's wireless interface has received.
double received_octets(const Lab& lab, std::size_t host) {
  const std::string all = system::run(lab.on(host, {"/bin/cat", "/proc/net/dev"})).said;
  const std::string name = lab.interface_of(host) + ':';
  const auto at = all.find(name);
  return at == std::string::npos ? 0 : std::strtod(all.c_str() + at + name.size(), nullptr);
}

}  // namespace

void measure_over_server(std::size_t hosts) {
  const std::string name = "a newcomer beyond a server of NATS is told of all services";
  if (::access(server_program, X_OK) != 0) return row_without(name, std::to_string(hosts), "needs nats-server");
  const system::Folder folder;
  const std::string key = folder.path("team.key");
  (void)system::run({.words = {system::program("gemingad"), "--generate-key", key}, .environment = {}, .before = {}});
  Lab lab(hosts);
  const std::size_t last = hosts - 1;
  const std::string address = lab.address_of(0);
  Process server(lab.on(0, {server_program, "-a", address}));
  if (!server.wait_for("Server is ready")) return row_without(name, std::to_string(hosts), "nats-server has failed");
  std::deque<Process> bridges;
  for (const std::size_t host : {std::size_t{0}, last}) {
    Process& bridge = bridges.emplace_back(
        lab.on(host, {system::program("geminga-bridge-nats"), "nats://" + address, "--team", "bench"}));
    if (!bridge.wait_for("carrying words")) return row_without(name, std::to_string(hosts), bridge.said());
  }
  for (std::size_t host = 0; host < last; ++host) {
    const std::vector<std::string> flags{"--interface", "wlan0", "--key-file", key};
    auto relay = beside_bridge(flags);
    relay.emplace_back("--relay");
    lab.begin(host, host == 0 ? relay : flags);
  }
  std::deque<Talk> providers;
  for (std::size_t host = 0; host < last; ++host) {
    lab.wait_until_ready(host);
    Talk& provider = providers.emplace_back(lab.talk(host));
    for (int service = 1; service <= services_of_host; ++service) {
      const std::string number = std::to_string(service);
      provider.say(number + " pub create mode=otm/stream text=ball port=" + number);
    }
  }
  if (!lab.wait_for_participants(0, last)) return row_without(name, std::to_string(hosts), "the site did not meet");

  std::vector<double> times;
  for (int joining = 0; joining < joinings; ++joining) {
    lab.start(last, beside_bridge({"--key-file", key}));
    Talk consumer = lab.talk(last);
    const auto began = Clock::now();
    consumer.say("7 sub create mode=otm/stream reach=any text=ball");
    for (std::size_t left = last * services_of_host; left > 0; --left) {
      if (!consumer.line_with({"7 pub add"})) return row_without(name, std::to_string(hosts), "not all were told");
    }
    times.push_back(milliseconds_since(began));
    lab.daemon(last).signal(SIGKILL);
    if (!lab.wait_for_participants(0, last)) return row_without(name, std::to_string(hosts), "the dead are kept");
  }
  const auto told = [&](const std::string& which, double share) {
    row(name + ", " + which + " of " + std::to_string(joinings), std::to_string(hosts), quantile(times, share), "ms",
        {.limit = 2000});
  };
  told("median", 0.5);
  told("slowest", 1);
}

void measure_crowd_over_server(std::size_t count, bool keeps) {
  constexpr std::size_t services = 3;
  const std::string name = std::string("a newcomer beyond a server of NATS ") + (keeps ? "with" : "without") +
                           " JetStream is told of one service of each host of a site";
  const std::string size = std::to_string(count);
  if (::access(server_program, X_OK) != 0) return row_without(name, size, "needs nats-server");
  const system::Folder folder;
  const std::string key = folder.path("team.key");
  (void)system::run({.words = {system::program("gemingad"), "--generate-key", key}, .environment = {}, .before = {}});
  Lab lab(2);
  const std::string address = lab.address_of(0);
  std::vector<std::string> words{server_program, "-a", address};
  if (keeps) words.insert(words.end(), {"-js", "-sd", folder.path("js")});
  Process server(lab.on(0, words));
  if (!server.wait_for("Server is ready")) return row_without(name, size, "nats-server has failed");
  std::deque<Process> bridges;
  for (const std::size_t host : {0U, 1U}) {
    Process& bridge = bridges.emplace_back(
        lab.on(host, {system::program("geminga-bridge-nats"), "nats://" + address, "--team", "bench"}));
    if (!bridge.wait_for(keeps ? "words are kept" : "keeps no words")) return row_without(name, size, bridge.said());
  }
  auto flags = beside_bridge({"--key-file", key});
  flags.insert(flags.end(), {"--peer", "127.0.0.2:4717", "--relay"});
  lab.start(0, flags);
  Process crowd(lab.on(0, {system::program("crowd"), "127.0.0.2", "127.0.0.1", key, size, std::to_string(services)}));
  if (!crowd.wait_for("all said") || !lab.wait_for_participants(0, count + 2))
    return row_without(name, size, "the site did not meet");
  if (keeps) rest(3000);  // until all is kept
  std::vector<double> times;
  std::vector<double> octets;
  for (int joining = 0; joining < joinings; ++joining) {
    const double before = received_octets(lab, 1);
    lab.start(1, beside_bridge({"--key-file", key}));
    Talk consumer = lab.talk(1);
    const auto began = Clock::now();
    consumer.say("7 sub create mode=otm/stream text=ball");
    std::size_t told = 0;
    while (told < count && consumer.line_with({"7 pub add"})) ++told;
    if (told < count) return row_without(name, size, "told of " + std::to_string(told));
    times.push_back(milliseconds_since(began));
    octets.push_back(received_octets(lab, 1) - before);
    lab.daemon(1).signal(SIGKILL);
    if (!lab.wait_for_participants(0, count + 2)) return row_without(name, size, "the dead are kept");
  }
  row(name + ", median of " + std::to_string(joinings), size, quantile(times, 0.5), "ms", {.limit = 2000});
  row(name + ", slowest of " + std::to_string(joinings), size, quantile(times, 1), "ms", {.limit = 2000});
  row("octets that reach that host from the server meanwhile, median", size, quantile(octets, 0.5), "B");
}

}  // namespace geminga::bench
