// A team as it starts, and while nothing happens.
#include "bench/discovery/measures.hpp"

#include <poll.h>

#include <cmath>
#include <cstdio>
#include <vector>

#include "bench/table.hpp"
#include "bench/times.hpp"
#include "support/process_figures.hpp"

namespace geminga::bench {
namespace {

/// Octets of Ethernet, IPv4 and UDP before each datagram.
constexpr double header_octets = 42;

}  // namespace

void rest(int time_ms) { ::poll(nullptr, 0, time_ms); }

Measures::Measures(std::size_t hosts, const Targets& targets, const Effort& effort)
    : targets_(targets), effort_(effort), team_(hosts) {
  if (targets.loss > 0) team_.lab().lose(targets.loss);
}

void Measures::start() {
  const auto began = Clock::now();
  team_.start_together();
  expect_right();
  const double time = milliseconds_since(began);
  const auto sent = team_.sent();
  const double octets = (sent.octets + header_octets * sent.datagrams) / static_cast<double>(team_.size());
  row("all started together, all know all", time, "ms", targets_.start_ms);
  row("octets that a host has sent by then, headers included", octets, "B", targets_.start_octets);
  rest(effort_.settling_seconds * 1000);
}

void Measures::steady() {
  (void)team_.departures();
  std::vector<double> processor;
  for (std::size_t host = 0; host < team_.size(); ++host) {
    processor.push_back(-system::processor_ms(team_.lab().daemon(host).pid()));
  }
  const auto before = team_.sent();
  const auto began = Clock::now();
  rest(effort_.quiet_seconds * 1000);
  const double time = milliseconds_since(began);
  const auto after = team_.sent();
  std::vector<double> memory;
  for (std::size_t host = 0; host < team_.size(); ++host) {
    const pid_t daemon = team_.lab().daemon(host).pid();
    processor[host] = (processor[host] + system::processor_ms(daemon)) * 1000 / time;
    memory.push_back(system::resident_mb(daemon));
  }
  const double datagrams = after.datagrams - before.datagrams;
  steady_octets_ = (after.octets - before.octets) / time;
  const double octets = (after.octets - before.octets + header_octets * datagrams) * 1000 / time;
  row("octets a second that a host sends, headers included", octets / static_cast<double>(team_.size()), "B/s",
      targets_.steady_octets);
  // No host is the target. A target of 0 would mean that there is none, so it is half a host.
  row("living hosts that one was told are gone, events", static_cast<double>(team_.departures()), "", 0.5);
  row("processor time of a daemon a second, median", quantile(processor, 0.5), "ms", targets_.processor_ms);
  row("resident memory of a daemon, largest", quantile(memory, 1), "MB", 7);
}

void Measures::row(const std::string& name, double figure, const std::string& unit, double target) const {
  bench::row(name, size(), figure, unit, {.limit = target});
}

void Measures::complain(const std::string& what) const { row_without(what, size(), "failed"); }

std::string Measures::size() const {
  return std::to_string(team_.size()) + ", " + std::to_string(std::lround(targets_.loss * 100)) + " %";
}

void Measures::expect_right() {
  if (team_.wait_until_right()) return;
  complain("a team in which all is right");
  for (std::size_t host = 0; host < team_.size(); ++host) {
    if (team_.is_running(host)) std::fputs(team_.knowledge(host).c_str(), stderr);
  }
}

}  // namespace geminga::bench
