// geminga-simulate: teams of real participants in virtual time, on air that a seed makes bad.
#include <sys/resource.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <iostream>
#include <string>
#include <thread>
#include <vector>

#include "scenarios/command_line.hpp"
#include "scenarios/moment.hpp"
#include "scenarios/progress_line.hpp"
#include "scenarios/report.hpp"
#include "scenarios/scenarios.hpp"
#include "scenarios/seeds.hpp"
#include "scenarios/simulation.hpp"
#include "scenarios/sites.hpp"
#include "scenarios/starts.hpp"
#include "shell/options.hpp"
#include "shell/report.hpp"

namespace geminga::scenarios {
namespace {

constexpr const char* program = "geminga-simulate";
constexpr const char* examples = R"(Examples:
  tools/simulate --participants 1000 --minutes 60 --loss 30% --seed 7
  tools/simulate --scenario tunnel --seed 3
  tools/simulate --participants 12 --minutes 20 --loss 30% --burst 10%x300 --restarts 5 --partitions 2
  tools/simulate --seeds 1..10000 --faults
  tools/simulate --seeds 1..200 --start --loss 30%
  tools/simulate --sites 1000 --loss 10%

The same command prints the same trace on every machine. Each run is watched by checkers (tests/scenarios/README.md); what one
of them finds is printed, and with the command that runs the seed again.

Exit status: 0 nothing was found, 1 a checker found a violation, 2 wrong usage.)";

using RealClock = std::chrono::steady_clock;

Cost cost_since(RealClock::time_point began) {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return {.real_seconds = std::chrono::duration<double>(RealClock::now() - began).count(),
          .peak_octets = static_cast<std::uint64_t>(usage.ru_maxrss) * 1024};
}

void list() {
  for (const Scenario& one : all_scenarios()) {
    std::cout << one.name << std::string(one.name.size() < 20 ? 20 - one.name.size() : 1, ' ') << one.summary << "\n";
  }
}

int run_one(const Flags& flags) {
  const Conditions conditions = flags.conditions();
  const bool is_told = !flags.is_json && !flags.is_quiet;
  const auto began = RealClock::now();
  ProgressLine progress(conditions);
  const Result result = simulate(
      conditions,
      [&](const std::string& line) {
        progress.clear();
        if (is_told) std::cout << line << std::endl;
      },
      progress.on_terminal());
  progress.clear();
  const Cost cost = cost_since(began);
  if (flags.is_json) {
    print_json(std::cout, conditions, result, cost);
  } else {
    print_report(std::cout, conditions, result, cost);
  }
  if (result.violations.empty()) return 0;
  shell::complain(program, result.violations.front());
  shell::complain(program, "run it again: " + flags.replay(flags.seed));
  return 1;
}

/// "0.2 s / 0.4 s / 1.1 s of 90"
std::string spread(const std::vector<base::Duration>& all) {
  if (all.empty()) return "-";
  return in_words(quantile(all, 50)) + " / " + in_words(quantile(all, 95)) + " / " + in_words(quantile(all, 100)) +
         " of " + std::to_string(all.size());
}

int run_many(const Flags& flags, const Seeds& seeds) {
  const std::size_t processors = std::max(1U, std::thread::hardware_concurrency());
  const auto began = RealClock::now();
  auto told = began;
  const auto progress = [&](std::uint64_t done) {
    if (RealClock::now() - told < std::chrono::seconds(10)) return;
    told = RealClock::now();
    std::cerr << done << " of " << seeds.last - seeds.first + 1 << " seeds\n";
  };
  const auto conditions = [&](std::uint64_t seed) {
    Flags one = flags;
    one.seed = seed;
    return one.conditions();
  };
  Tally tally;
  const auto failure = run_seeds(seeds, flags.threads == 0 ? processors : flags.threads, conditions, progress, &tally);
  const Cost cost = cost_since(began);
  if (!failure) {
    std::cout << seeds.last - seeds.first + 1 << " seeds in " << static_cast<int>(cost.real_seconds)
              << " s: nothing was found\n"
              << std::chrono::duration<double, std::ratio<3600>>(tally.simulated).count()
              << " hours of a team: " << tally.false_departures << " living ones told to be gone, "
              << tally.octets_per_host_second
              << " octets a second a host; deaths told, p50 / p95 / max: " << spread(tally.deaths) << "\n";
    return 0;
  }
  shell::complain(program, "seed " + std::to_string(failure->seed) + ": " + failure->violation);
  shell::complain(program, "run it again: " + flags.replay(failure->seed));
  return 1;
}

int run_starts(const Flags& flags, const Seeds& seeds) {
  std::vector<base::Duration> times;
  Start worst;
  double octets = 0;
  for (Flags one = flags; one.seed <= seeds.last; ++one.seed) {
    if (one.seed < seeds.first) one.seed = seeds.first;
    const bool is_told = seeds.first == seeds.last && !flags.is_quiet;
    const Start start =
        measure_start(one.conditions(), is_told ? [](const std::string& line) { std::cout << line << "\n"; } : Tell());
    times.push_back(start.took);
    octets += static_cast<double>(start.octets);
    if (start.took > worst.took) worst = start;
  }
  std::cout << "all know all, p50 / p95 / max: " << spread(times) << ", the last with seed " << worst.seed << "; "
            << octets / static_cast<double>(times.size()) << " octets a host in " << in_words(settled_after) << "\n";
  return 0;
}

int run_sites(const Flags& flags) {
  SiteConditions conditions{.seed = flags.seed, .sites = *flags.sites, .loss = flags.conditions().air.loss};
  if (flags.minutes) conditions.time = std::chrono::milliseconds(static_cast<std::int64_t>(*flags.minutes * 60'000));
  Conditions shown;
  shown.participants = conditions.sites;
  shown.time = conditions.time;
  ProgressLine progress(shown);
  const auto began = RealClock::now();
  const OnProgress on_terminal = progress.on_terminal();
  const SiteResult result = simulate_sites(conditions, [&](base::Duration simulated, std::uint64_t messages) {
    if (on_terminal) on_terminal(simulated, messages);
  });
  progress.clear();
  print_sites(std::cout, conditions, result, cost_since(began));
  return result.missing == 0 || conditions.loss > 0 ? 0 : 1;
}

int run(int argc, char** argv) {
  CLI::App app("Simulates teams of Geminga participants on bad air, in virtual time.", program);
  app.footer(examples);
  Flags flags;
  flags.add_to(app);
  if (const auto status = shell::parse(app, argc, argv)) return static_cast<int>(*status);
  if (flags.is_list) {
    list();
    return 0;
  }
  try {
    if (flags.sites) return run_sites(flags);
    const auto seeds = flags.range();
    if (flags.is_start) return run_starts(flags, seeds.value_or(Seeds{.first = flags.seed, .last = flags.seed}));
    return seeds ? run_many(flags, *seeds) : run_one(flags);
  } catch (const CLI::ValidationError& error) {
    shell::complain(program, std::string(error.what()) + ": see tools/simulate --help");
    return 2;
  }
}

}  // namespace
}  // namespace geminga::scenarios

int main(int argc, char** argv) { return geminga::scenarios::run(argc, argv); }
