// The choice of the robots for a task of 20 roles, half or all of which may be shared.
#include <benchmark/benchmark.h>

#include <cstdint>
#include <vector>

#include "base/random.hpp"
#include "bench/rows.hpp"
#include "discovery/roles/holders.hpp"

namespace geminga::roles {
namespace {

constexpr std::size_t task_count = 64;
constexpr std::size_t role_count = 20;

/// Tasks by seed. A robot is of one of `kinds` kinds, each of which suits three roles in ten, or one in eight where all
/// are shared.
std::vector<Task> tasks(std::uint32_t robots, std::uint64_t kinds, bool has_costs, bool are_all_shared) {
  std::vector<Task> all;
  for (std::uint64_t seed = 1; seed <= task_count; ++seed) {
    base::Random random(seed);
    Task task{.robots = robots, .roles = {}, .former = {}};
    std::vector<std::uint64_t> kind;
    std::vector<std::uint32_t> cost;
    for (std::uint32_t robot = 0; robot < robots; ++robot) {
      kind.push_back(random.below(kinds));
      cost.push_back(has_costs ? static_cast<std::uint32_t>(random.below(100)) : 0);
    }
    for (std::size_t at = 0; at < role_count; ++at) {
      Role role{.count = static_cast<std::uint32_t>(1 + random.below(2)),
                .is_shared = are_all_shared || at % 2 == 0,
                .suited = {}};
      std::vector<bool> suits;
      for (std::uint64_t one = 0; one < kinds; ++one) suits.push_back(random.chance(are_all_shared ? 0.125 : 0.3));
      for (std::uint32_t robot = 0; robot < robots; ++robot) {
        if (suits[kind[robot]]) role.suited.push_back({robot, cost[robot]});
      }
      task.roles.push_back(std::move(role));
    }
    all.push_back(std::move(task));
  }
  return all;
}

/// The mean over all tasks.
void choose(benchmark::State& state, std::uint64_t kinds, bool has_costs, bool are_all_shared = false) {
  const auto all = tasks(static_cast<std::uint32_t>(state.range(0)), kinds, has_costs, are_all_shared);
  std::size_t at = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(best_holders(all[at]));
    at = (at + 1) % all.size();
  }
}

void few_kinds(benchmark::State& state) { choose(state, 12, false); }
void all_different(benchmark::State& state) { choose(state, 10'000, false); }
void few_kinds_preferred(benchmark::State& state) { choose(state, 12, true); }
void all_different_preferred(benchmark::State& state) { choose(state, 10'000, true); }
void all_shared_preferred(benchmark::State& state) { choose(state, 10'000, true, true); }

void register_all() {
  benchmark::RegisterBenchmark("few_kinds", few_kinds)->Arg(100);
  benchmark::RegisterBenchmark("all_different", all_different)->Arg(100);
  benchmark::RegisterBenchmark("few_kinds_preferred", few_kinds_preferred)->Arg(100);
  benchmark::RegisterBenchmark("all_different_preferred", all_different_preferred)->Arg(100);
  benchmark::RegisterBenchmark("all_shared_preferred", all_shared_preferred)->Arg(100);
}

}  // namespace
}  // namespace geminga::roles

int main(int argc, char** argv) {
  constexpr double ten_milliseconds = 1e7;
  const geminga::bench::Target target{.limit = ten_milliseconds};
  return geminga::bench::run(argc, argv,
                             {{"few_kinds", target},
                              {"all_different", target},
                              {"few_kinds_preferred", target},
                              {"all_different_preferred", target},
                              {"all_shared_preferred", target}},
                             geminga::roles::register_all);
}
