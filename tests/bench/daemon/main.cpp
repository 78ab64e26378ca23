// Measures whole daemons in a lab of network namespaces: start, memory, idling, and how soon a service is told
// elsewhere. Writes tab-separated rows `name, size, figure, ratio, target, verdict` for tools/bench.
#include <poll.h>

#include <string>
#include <string_view>
#include <vector>

#include "bench/table.hpp"
#include "bench/times.hpp"
#include "support/lab.hpp"
#include "support/process_figures.hpp"

namespace geminga::bench {
namespace {

using system::Lab;
using system::Process;
using system::Talk;

/// The pause between two services, in milliseconds: the copies of the last change are out, so the sender may burst.
constexpr int pause_between = 700;

std::vector<std::string> with_soccer() {
  const std::string folder = std::string(GEMINGA_SOURCE_DIR) + "/ontology/";
  return {"--ontology", folder + "core.ttl", "--ontology", folder + "robot-soccer.ttl"};
}

/// Ends the benchmark: something that must happen did not.
void complain(const std::string& what) { row_without(what, "-", "failed"); }

void measure_start(int runs) {
  std::vector<double> times;
  double resident = 0;
  double own = 0;
  for (int run = 0; run < runs; ++run) {
    Lab lab(1);
    std::vector<std::string> words{system::program("gemingad")};
    for (const std::string& word : with_soccer()) words.push_back(word);
    if (!lab.has_namespaces()) {
      words.insert(words.end(), {"--interface", "lo", "--gcnp", "127.0.0.1:" + std::to_string(lab.gcnp_port(0))});
    }
    const auto began = Clock::now();
    Process daemon(lab.on(0, words));
    for (bool is_answered = false; !is_answered;) {
      try {
        Talk talk = lab.talk(0);
        is_answered = !talk.query("ontology").empty();
      } catch (const std::exception&) {
        ::poll(nullptr, 0, 1);  // nobody listens yet
      }
    }
    times.push_back(milliseconds_since(began));
    resident = system::resident_mb(daemon.pid());
    own = system::anonymous_mb(daemon.pid());
  }
  row("start to the first answered query, median", "1", quantile(times, 0.5), "ms", {.limit = 200});
  row("start to the first answered query, worst", "1", quantile(times, 1), "ms");
  row("resident memory with robot-soccer.ttl", "1", resident, "MB", {.limit = 10});
  row("resident memory that is shared with nobody", "1", own, "MB");
}

void measure_idling(int seconds) {
  constexpr std::size_t hosts = 10;
  Lab lab(hosts);
  lab.start_all(with_soccer());
  for (std::size_t host = 0; host < hosts; ++host) {
    Talk talk = lab.talk(host);
    talk.say("1 pub create mode=otm/stream concept=soccer:BallInfo port=5000");
    if (!talk.lines_until_pong().empty()) complain("a publication without a word");
    if (!lab.wait_for_participants(host, hosts)) complain("a host that sees the whole team");
  }
  std::vector<double> before;
  for (std::size_t host = 0; host < hosts; ++host) before.push_back(system::processor_ms(lab.daemon(host).pid()));
  ::poll(nullptr, 0, seconds * 1000);
  std::vector<double> per_second;
  for (std::size_t host = 0; host < hosts; ++host) {
    per_second.push_back((system::processor_ms(lab.daemon(host).pid()) - before[host]) / seconds);
  }
  row("processor time of an idle daemon a second, median", std::to_string(hosts), quantile(per_second, 0.5), "ms",
      {.limit = 1});
  row("processor time of an idle daemon a second, worst", std::to_string(hosts), quantile(per_second, 1), "ms");
}

void measure_telling(int services) {
  Lab lab(2);
  lab.start_all(with_soccer());
  Talk consumer = lab.talk(1);
  consumer.say("1 sub create mode=otm/stream concept=soccer:BallInfo");
  Talk provider = lab.talk(0);
  std::vector<double> times;
  const auto publish = [&](int number, const std::string& identity) {
    const auto began = Clock::now();
    provider.say(std::to_string(number) + " pub create mode=otm/stream " + identity + " port=5000");
    if (!consumer.line_with({" pub add "})) complain("a service that is told");
    times.push_back(milliseconds_since(began));
    provider.say(std::to_string(number) + " pub remove");
    if (!consumer.line_with({" pub del "})) complain("the end of a service that is told");
    ::poll(nullptr, 0, pause_between);  // a peer that changes its services without end is slowed down on purpose
  };
  publish(1, "concept=soccer:BallInfo");
  times.clear();  // the first one has warmed everybody up
  for (int number = 0; number < services; ++number) publish(number + 10, "concept=soccer:BallInfo");
  row("a new service told on another host, median", std::to_string(times.size()), quantile(times, 0.5), "ms",
      {.limit = 5});
  row("a new service told on another host, p95", std::to_string(times.size()), quantile(times, 0.95), "ms",
      {.limit = 5});
  row("a new service told on another host, worst", std::to_string(times.size()), quantile(times, 1), "ms");
}

}  // namespace
}  // namespace geminga::bench

int main(int argc, char** argv) {
  using namespace geminga::bench;
  const bool is_smoke = argc > 1 && std::string_view(argv[1]) == "--smoke";
  measure_start(is_smoke ? 2 : 15);
  measure_telling(is_smoke ? 2 : 40);
  measure_idling(is_smoke ? 1 : 20);
}
