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

void print_sites(std::ostream& out, const SiteConditions& conditions, const SiteResult& result, const Cost& cost) {
  const auto row = [&](const std::string& name, const std::string& figure) {
    out << "  " << name << std::string(name.size() < 60 ? 60 - name.size() : 1, ' ') << figure << "\n";
  };
  row("sites, clusters, minutes", std::to_string(conditions.sites) + ", " + std::to_string(conditions.clusters) + ", " +
                                      decimal(seconds(conditions.time) / 60));
  row("questions, answers sent", std::to_string(result.questions) + ", " + std::to_string(result.answers));
  row("octets a second that a site receives (formula)",
      decimal(result.received_octets) + " (" + decimal(result.expected_received) + ")");
  row("octets a second that a site sends", decimal(result.sent_octets));
  row("octets a second between clusters, all together", decimal(result.gateway_octets));
  row("answers that a site remembers (formula)",
      decimal(result.remembered) + " (" + decimal(result.expected_remembered) + ")");
  row("told after an interest began, p50 / p95 / max", quantiles(result.told));
  row("told of a change of magnitude, p50 / p95 / max", quantiles(result.changed));
  row("offerers of interests; unknown; known and gone",
      std::to_string(result.pairs) + "; " + std::to_string(result.missing) + "; " + std::to_string(result.surplus));
  row("expansions; not answered", std::to_string(result.expansions) + "; " + std::to_string(result.unanswered));
  row("octets a second of expansions and listings of a site", decimal(result.listing_octets));
  row("services listed after they were asked for, p50 / p95 / max", quantiles(result.listed));
  row("peak memory of all", decimal(static_cast<double>(cost.peak_octets) / (1 << 20)) + " MiB");
  row("seconds", decimal(cost.real_seconds));
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
