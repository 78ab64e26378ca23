// A newcomer that has nothing but a server of NATS between itself and a site of whole daemons behind a relay.
#include "bench/discovery/over_server.hpp"

#include <unistd.h>

#include <csignal>
#include <deque>
#include <string>
#include <vector>

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
    consumer.say("7 sub create mode=otm/stream text=ball");
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

}  // namespace geminga::bench
