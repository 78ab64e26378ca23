#include "scenarios/report.hpp"

#include <boost/json/array.hpp>
#include <boost/json/object.hpp>
#include <boost/json/value.hpp>
#include <cstdio>

#include "base/text.hpp"
#include "scenarios/moment.hpp"
#include "shell/json.hpp"

namespace geminga::scenarios {
namespace {

double seconds(base::Duration duration) { return std::chrono::duration<double>(duration).count(); }

std::string decimal(double number, const char* format = "%.1f") {
  char text[40];
  std::snprintf(text, sizeof text, format, number);
  return text;
}

double speed(const Result& result, const Cost& cost) {
  return cost.real_seconds > 0 ? seconds(result.simulated) / cost.real_seconds : 0;
}

std::string quantiles(const std::vector<base::Duration>& durations) {
  if (durations.empty()) return "-";
  return in_words(quantile(durations, 50)) + " / " + in_words(quantile(durations, 95)) + " / " +
         in_words(quantile(durations, 100)) + "   of " + std::to_string(durations.size());
}

boost::json::value quantiles_of(const std::vector<base::Duration>& durations) {
  if (durations.empty()) return nullptr;
  return boost::json::object{{"p50", seconds(quantile(durations, 50))},
                             {"p95", seconds(quantile(durations, 95))},
                             {"max", seconds(quantile(durations, 100))},
                             {"count", durations.size()}};
}

}  // namespace

void print_report(std::ostream& out, const Conditions& conditions, const Result& result, const Cost& cost) {
  const auto row = [&](const std::string& name, const std::string& figure) {
    out << "  " << name << std::string(name.size() < 46 ? 46 - name.size() : 1, ' ') << figure << "\n";
  };
  out << "\n";
  row("all know all after the start", in_words(result.agreed_after));
  row("told of a new service, p50 / p95 / max", quantiles(result.delays.told));
  row("told of a withdrawn one, p50 / p95 / max", quantiles(result.delays.withdrawn));
  row("told of a death, p50 / p95 / max", quantiles(result.delays.crashed));
  row("never told in time", std::to_string(result.never_told));
  row("living ones told to be gone", std::to_string(result.false_departures));
  row("octets a second a host, headers included", decimal(result.octets_per_host_second()));
  row("datagrams, events", std::to_string(result.datagrams) + ", " + std::to_string(result.events));
  row("peak memory", decimal(static_cast<double>(cost.peak_octets) / (1 << 20)) + " MiB");
  row("simulated seconds in a second", decimal(speed(result, cost)));
  row("violations", std::to_string(result.violations.size()));
  row("trace, seed " + std::to_string(conditions.seed), base::to_hex(result.trace_hash, 16));
}

void print_json(std::ostream& out, const Conditions& conditions, const Result& result, const Cost& cost) {
  boost::json::array violations;
  for (const std::string& violation : result.violations) violations.emplace_back(violation);
  const boost::json::object document{
      {"scenario", conditions.name},
      {"seed", conditions.seed},
      {"participants", conditions.participants},
      {"simulated_s", seconds(result.simulated)},
      {"loss", conditions.air.loss},
      {"trace", base::to_hex(result.trace_hash, 16)},
      {"agreed_after_s", seconds(result.agreed_after)},
      {"told_s", quantiles_of(result.delays.told)},
      {"withdrawn_s", quantiles_of(result.delays.withdrawn)},
      {"death_s", quantiles_of(result.delays.crashed)},
      {"never_told", result.never_told},
      {"false_departures", result.false_departures},
      {"octets_per_host_second", result.octets_per_host_second()},
      {"datagrams", result.datagrams},
      {"events", result.events},
      {"peak_memory_octets", cost.peak_octets},
      {"simulated_per_second", speed(result, cost)},
      {"violations", violations},
  };
  shell::print(out, document);
}

}  // namespace geminga::scenarios
