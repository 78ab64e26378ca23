// Measures whole daemons in a lab of network namespaces: start, memory, idling, and how soon a service is told
// elsewhere. Writes tab-separated rows `name, size, figure, ratio, target, verdict` for tools/bench.
#include <poll.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "support/lab.hpp"

namespace geminga::system {
namespace {

using Clock = std::chrono::steady_clock;

/// Between two services, in milliseconds: by then the copies of the last change are out and the sender may burst again.
constexpr int pause_between = 700;

double milliseconds(Clock::duration duration) { return std::chrono::duration<double, std::milli>(duration).count(); }

double quantile(std::vector<double> values, double share) {
  std::ranges::sort(values);
  return values.at(static_cast<std::size_t>(share * static_cast<double>(values.size() - 1)));
}

std::vector<std::string> with_soccer() {
  const std::string folder = std::string(GEMINGA_SOURCE_DIR) + "/ontology/";
  return {"--ontology", folder + "core.ttl", "--ontology", folder + "robot-soccer.ttl"};
}

/// A row with a figure that has a target, or with none (0).
void row(const std::string& name, std::size_t size, double figure, const std::string& unit, double target) {
  std::printf("%s\t%zu\t%.3g %s\t-\t", name.c_str(), size, figure, unit.c_str());
  if (target == 0) {
    std::printf("-\t-\n");
  } else {
    std::printf("%g %s\t%s\n", target, unit.c_str(), figure <= target ? "ok" : "over");
  }
}

/// Something did not happen that must.
void complain(const std::string& what) { std::printf("%s\t-\t-\t-\t-\tfailed\n", what.c_str()); }

/// The number behind `key` in a file of /proc/PID.
double number_of(pid_t pid, const std::string& file, const std::string& key) {
  std::ifstream lines("/proc/" + std::to_string(pid) + '/' + file);
  std::string line;
  while (std::getline(lines, line)) {
    if (line.starts_with(key)) return std::stod(line.substr(key.size()));
  }
  return -1;
}

/// Processor time of a process in milliseconds, as the scheduler counts it in nanoseconds.
double processor_time(pid_t pid) { return number_of(pid, "schedstat", "") / 1e6; }

void measure_start(int runs) {
  std::vector<double> times;
  double resident = 0;
  double own = 0;
  for (int run = 0; run < runs; ++run) {
    Lab lab(1);
    std::vector<std::string> words{program("gemingad")};
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
    times.push_back(milliseconds(Clock::now() - began));
    resident = number_of(daemon.pid(), "status", "VmRSS:") * 1024 / 1e6;
    own = number_of(daemon.pid(), "status", "RssAnon:") * 1024 / 1e6;
  }
  row("start to the first answered query, median", 1, quantile(times, 0.5), "ms", 200);
  row("start to the first answered query, worst", 1, quantile(times, 1), "ms", 0);
  row("resident memory with robot-soccer.ttl", 1, resident, "MB", 10);
  row("resident memory that is shared with nobody", 1, own, "MB", 0);
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
  for (std::size_t host = 0; host < hosts; ++host) before.push_back(processor_time(lab.daemon(host).pid()));
  ::poll(nullptr, 0, seconds * 1000);
  std::vector<double> per_second;
  for (std::size_t host = 0; host < hosts; ++host) {
    per_second.push_back((processor_time(lab.daemon(host).pid()) - before[host]) / seconds);
  }
  row("processor time of an idle daemon a second, median", hosts, quantile(per_second, 0.5), "ms", 1);
  row("processor time of an idle daemon a second, worst", hosts, quantile(per_second, 1), "ms", 0);
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
    times.push_back(milliseconds(Clock::now() - began));
    provider.say(std::to_string(number) + " pub remove");
    if (!consumer.line_with({" pub del "})) complain("the end of a service that is told");
    ::poll(nullptr, 0, pause_between);  // a peer that changes its services without end is slowed down on purpose
  };
  publish(1, "concept=soccer:BallInfo");
  times.clear();  // the first one has warmed everybody up
  for (int number = 0; number < services; ++number) publish(number + 10, "concept=soccer:BallInfo");
  row("a new service told on another host, median", times.size(), quantile(times, 0.5), "ms", 5);
  row("a new service told on another host, p95", times.size(), quantile(times, 0.95), "ms", 5);
  row("a new service told on another host, worst", times.size(), quantile(times, 1), "ms", 0);
}

}  // namespace
}  // namespace geminga::system

int main(int argc, char** argv) {
  using namespace geminga::system;
  const bool is_smoke = argc > 1 && std::string_view(argv[1]) == "--smoke";
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  measure_start(is_smoke ? 2 : 15);
  measure_telling(is_smoke ? 2 : 40);
  measure_idling(is_smoke ? 1 : 20);
}
