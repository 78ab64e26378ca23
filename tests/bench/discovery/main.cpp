// Measures a team of whole daemons on bad air: how soon it is told of services, whom it loses, when it notices a death,
// and what it sends. Each receiver loses datagrams for itself, by nftables on the bridge between the namespaces.
// Writes tab-separated rows `name, size, figure, ratio, target, verdict` for tools/bench.
#include <poll.h>
#include <signal.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "support/lab.hpp"

namespace geminga::system {
namespace {

using Clock = std::chrono::steady_clock;

/// Octets of Ethernet, IPv4 and UDP before each datagram.
constexpr double header_octets = 42;

/// Stands for a service that was not told before patience ended.
constexpr double never_ms = 1e6;

double milliseconds(Clock::duration duration) { return std::chrono::duration<double, std::milli>(duration).count(); }

double quantile(std::vector<double> values, double share) {
  std::ranges::sort(values);
  return values.empty() ? 0 : values.at(static_cast<std::size_t>(share * static_cast<double>(values.size() - 1)));
}

void rest(int time_ms) { ::poll(nullptr, 0, time_ms); }

/// What is asked of a team at one loss (the table of the issue that this was built for).
struct Targets {
  double loss = 0;
  double told_ms = 0;
  double death_ms = 0;
  double octets = 0;
};

class Measurement {
 public:
  Measurement(std::size_t hosts, const Targets& targets) : hosts_(hosts), targets_(targets), lab_(hosts) {
    if (targets.loss > 0) lab_.lose(targets.loss);
    lab_.start_all();
    for (std::size_t host = 0; host < hosts; ++host) state(host);
    for (std::size_t host = 0; host < hosts; ++host) {
      if (!lab_.wait_for_participants(host, hosts)) complain("a host that sees the whole team");
    }
    rest(5000);
    for (auto& talk : talks_) (void)talk.lines_until_pong();
  }

  void measure(int changes, int quiet_seconds) {
    const auto sent = octets_sent();
    const auto began = Clock::now();
    rest(quiet_seconds * 1000);
    const double seconds = milliseconds(Clock::now() - began) / 1000;
    const auto octets = (octets_sent() - sent) / seconds / static_cast<double>(hosts_);
    std::size_t departures = 0;
    for (auto& talk : talks_) departures += expired(talk.lines_until_pong());
    measure_telling(changes);
    row("octets a second that a host sends, headers included", octets, "B/s", targets_.octets);
    row("living hosts that one was told are gone, events", static_cast<double>(departures), "", 0.5);
    measure_death();
  }

 private:
  /// Nine services and seven requests on each host (paper section 4).
  void state(std::size_t host) {
    auto& talk = talks_.emplace_back(lab_.talk(host));
    for (int i = 0; i < 9; ++i) {
      talk.say(std::to_string(10 + i) + " pub create mode=otm/stream text=service" + std::to_string(i) +
               " port=" + std::to_string(5000 + i));
    }
    for (int i = 0; i < 7; ++i) {
      talk.say(std::to_string(30 + i) + " sub create mode=otm/stream text=service" + std::to_string(i));
    }
    talk.say("40 sub create mode=otm/stream text=news");
    (void)talk.lines_until_pong();
  }

  void measure_telling(int changes) {
    std::vector<double> times;
    for (int change = 0; change < changes; ++change) {
      const std::string number = std::to_string(100 + change);
      const auto provider = static_cast<std::size_t>(change) % hosts_;
      const auto began = Clock::now();
      talks_[provider].say(number + " pub create mode=otm/stream text=news port=6000");
      std::vector<double> told(hosts_);
      {
        std::vector<std::jthread> watchers;
        for (std::size_t host = 0; host < hosts_; ++host) {
          if (host == provider) continue;
          watchers.emplace_back([this, host, began, &told] {
            const bool is_told = talks_[host].line_with({"40 pub add "}).has_value();
            told[host] = is_told ? milliseconds(Clock::now() - began) : never_ms;
          });
        }
      }
      told.erase(told.begin() + static_cast<std::ptrdiff_t>(provider));
      times.insert(times.end(), told.begin(), told.end());
      talks_[provider].say(number + " pub remove");
      rest(1500);
      for (auto& talk : talks_) (void)talk.lines_until_pong();
    }
    row("a new service told on another host, p95", quantile(times, 0.95), "ms", targets_.told_ms);
    row("a new service told on another host, worst", quantile(times, 1), "ms", 1000);
  }

  void measure_death() {
    const auto began = Clock::now();
    ::kill(lab_.daemon(hosts_ - 1).pid(), SIGKILL);
    double worst = 0;
    for (std::size_t host = 0; host + 1 < hosts_; ++host) {
      if (!talks_[host].line_with({" pub del ", "reason=expired"})) complain("a death that is told");
      worst = std::max(worst, milliseconds(Clock::now() - began));
    }
    row("a death told on all hosts", worst, "ms", targets_.death_ms);
  }

  double octets_sent() {
    double octets = 0;
    for (auto& talk : talks_) {
      const auto status = talk.query("status");
      octets += std::stod(field(status.at(0), "bytes_sent"));
      octets += header_octets * std::stod(field(status.at(0), "datagrams_sent"));
    }
    return octets;
  }

  static std::size_t expired(const std::vector<std::string>& lines) {
    return static_cast<std::size_t>(std::ranges::count_if(lines, [](const std::string& line) {
      return line.find(" del ") != std::string::npos && line.find("reason=expired") != std::string::npos;
    }));
  }

  void row(const std::string& name, double figure, const std::string& unit, double target) const {
    std::printf("%s, %g %% loss\t%zu\t%.3g %s\t-\t%g %s\t%s\n", name.c_str(), targets_.loss * 100, hosts_, figure,
                unit.c_str(), target, unit.c_str(), figure <= target ? "ok" : "over");
  }
  static void complain(const std::string& what) { std::printf("%s\t-\t-\t-\t-\tfailed\n", what.c_str()); }

  std::size_t hosts_;
  Targets targets_;
  Lab lab_;
  std::vector<Talk> talks_;
};

}  // namespace
}  // namespace geminga::system

int main(int argc, char** argv) {
  using namespace geminga::system;
  const bool is_smoke = argc > 1 && std::string_view(argv[1]) == "--smoke";
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  constexpr std::array<Targets, 4> all = {
      {{0, 3, 4500, 36}, {0.1, 10, 4500, 36}, {0.3, 20, 5000, 45}, {0.5, 60, 6000, 60}}};
  for (const auto& targets : all) {
    if (is_smoke && targets.loss > 0) break;
    if (targets.loss > 0 && !Lab::can_lose()) {
      std::printf("a team under loss\t-\t-\t-\t-\tneeds network namespaces and nft (Debian package nftables)\n");
      break;
    }
    Measurement(is_smoke ? 3 : 10, targets).measure(is_smoke ? 1 : 20, is_smoke ? 2 : 100);
  }
}
