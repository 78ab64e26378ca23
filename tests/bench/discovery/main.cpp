// Measures a team of whole daemons on bad air: how soon it is told of services, whom it loses, when it notices a death,
// how it starts and recovers, and what it takes. Each receiver loses datagrams for itself, by nftables on the bridge
// between the namespaces. With --hundred a hundred of them without loss: start, steady state and telling; with --relays
// thirty on three links with relays between them, at 30 % loss and without (with --smoke behind it: nine, for seconds);
// with --server one more that knows a hundred over a server of NATS alone; with --crowd one that learns of a thousand
// (or COUNT) so. Writes tab-separated rows `name, size, figure, ratio, target, verdict` for tools/bench.
#include <array>
#include <cstdlib>
#include <span>
#include <string_view>

#include "bench/discovery/measures.hpp"
#include "bench/discovery/over_server.hpp"
#include "bench/discovery/relays.hpp"
#include "bench/table.hpp"

namespace geminga::bench {
namespace {

/// The targets for ten robots and for thirty, in the order of the members of Targets.
constexpr std::array<Targets, 4> of_ten = {{
    {0.0, 150, 1200, 3, 4500, 170, 36, 150, 0.1},
    {0.1, 200, 1200, 10, 4500, 230, 36, 0, 0.1},
    {0.3, 300, 1200, 20, 5000, 330, 45, 400, 0.1},
    {0.5, 800, 1200, 60, 6000, 690, 60, 0, 0.1},
}};
constexpr std::array<Targets, 4> of_thirty = {{
    {0.0, 300, 0, 3, 4500, 0, 60, 0, 0.2},
    {0.1, 400, 0, 10, 4500, 0, 60, 0, 0.2},
    {0.3, 800, 0, 20, 5000, 1000, 60, 0, 0.2},
    {0.5, 1500, 0, 60, 6000, 0, 60, 0, 0.2},
}};

/// Of a hundred, without loss: tools/bench does not run it. No target but that of the field for quiet hosts.
constexpr Targets of_hundred = {0.0, 0, 0, 0, 0, 0, 0, 0, 0};

void measure(std::size_t hosts, const Targets& targets, const Effort& effort) {
  Measures measures(hosts, targets, effort);
  measures.start();
  measures.steady();
  measures.telling();
  measures.death();
  measures.restart();
  measures.partition();
}

void measure_all(std::size_t hosts, std::span<const Targets> all) {
  for (const Targets& targets : all) {
    if (targets.loss > 0 && !system::Lab::can_lose()) {
      return row_without("a team under loss", std::to_string(hosts),
                         "needs network namespaces and nft (Debian package nftables)");
    }
    measure(hosts, targets, {.changes = 20, .settling_seconds = 5, .quiet_seconds = 100, .partition_seconds = 30});
  }
}

}  // namespace
}  // namespace geminga::bench

int main(int argc, char** argv) {
  using namespace geminga::bench;
  if (argc > 1 && std::string_view(argv[1]) == "--smoke") {
    measure(4, of_ten.front(), {.changes = 1, .settling_seconds = 0, .quiet_seconds = 1, .partition_seconds = 1});
    return 0;
  }
  if (argc > 1 && std::string_view(argv[1]) == "--hundred") {
    Measures measures(100, of_hundred,
                      {.changes = 20, .settling_seconds = 5, .quiet_seconds = 30, .partition_seconds = 0});
    measures.start();
    measures.steady();
    measures.telling();
    return 0;
  }
  if (argc > 1 && std::string_view(argv[1]) == "--relays") {
    if (!geminga::system::Lab::can_lose()) return 77;
    const bool is_smoke = argc > 2 && std::string_view(argv[2]) == "--smoke";
    if (is_smoke) {
      return measure_relays(0, {.on_link = 3, .changes = 3, .quiet_seconds = 1, .settling = 0, .until_given_up = 6000})
                 ? 0
                 : 1;
    }
    bool is_right = true;
    for (const double loss : {0.0, 0.3}) is_right = measure_relays(loss, {}) && is_right;
    return is_right ? 0 : 1;
  }
  if (argc > 1 && std::string_view(argv[1]) == "--server") {
    measure_over_server(100);
    return 0;
  }
  if (argc > 1 && std::string_view(argv[1]) == "--crowd") {
    const std::size_t count = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 1000;
    for (const bool keeps : {true, false}) measure_crowd_over_server(count, keeps);
    return 0;
  }
  measure_all(10, of_ten);
  if (std::getenv("GEMINGA_BENCH_FULL") != nullptr) measure_all(30, of_thirty);
}
