// Runs the registered benchmarks and writes one row each in the form that tools/bench puts into its table.
#ifndef GEMINGA_TESTS_BENCH_ROWS_HPP
#define GEMINGA_TESTS_BENCH_ROWS_HPP

#include <map>
#include <string>
#include <vector>

namespace geminga::bench {

/// The target of a figure: a multiple of another benchmark's time in the same run.
struct Target {
  std::string baseline{};  ///< the name of the other benchmark, without its size; empty: there is none
  double at_most = 0;      ///< 0: the ratio is shown and judged by nobody
  double limit = 0;        ///< without a baseline: at most so many nanoseconds
};

/// Targets by the name of the benchmark, without its size.
using Targets = std::map<std::string, Target>;

/// The sizes of a run: small ones with `--smoke`.
[[nodiscard]] const std::vector<long>& sizes();

/// Reads the command line (`--smoke`, and what Google Benchmark reads), lets `register_all` register, runs, and writes
/// for each benchmark the tab-separated row `name, size, time, ratio, target, verdict`; a field that does not apply is
/// `-`, the verdict `ok` or `over`. Always 0: a figure over its target is seen in the table and fails no test, because
/// times move from machine to machine.
int run(int argc, char** argv, const Targets& targets, void (*register_all)());

}  // namespace geminga::bench

#endif
