#include "bench/rows.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <string_view>

namespace geminga::bench {
namespace {

std::vector<long> run_sizes{1'000, 100'000, 1'000'000};
constexpr long smoke_sizes[] = {100, 1'000};

/// Keeps the results; of repeated runs it keeps the median.
class Collector : public benchmark::BenchmarkReporter {
 public:
  struct Row {
    std::string name;
    std::string size;
    double nanoseconds = 0;
    std::string error;
    std::int64_t family = 0;
  };

  bool ReportContext(const Context&) override { return true; }

  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      const bool is_median = run.run_type == Run::RT_Aggregate && run.aggregate_name == "median";
      const bool is_only = run.run_type == Run::RT_Iteration && run.repetitions <= 1;
      if (!is_median && !is_only) continue;
      rows_.push_back({run.run_name.function_name, run.run_name.args,
                       run.GetAdjustedCPUTime() / benchmark::GetTimeUnitMultiplier(run.time_unit) * 1e9,
                       run.error_occurred ? run.error_message : "", run.family_index});
    }
  }

  [[nodiscard]] const std::vector<Row>& rows() const { return rows_; }

  /// In the order of registration; random interleaving does not keep it.
  [[nodiscard]] std::vector<Row> in_order() const {
    std::vector<Row> ordered = rows_;
    std::ranges::sort(ordered, {}, &Row::family);
    return ordered;
  }

 private:
  std::vector<Row> rows_;
};

std::string in_words(double nanoseconds) {
  char text[32];
  if (nanoseconds < 10'000) {
    std::snprintf(text, sizeof text, "%.1f ns", nanoseconds);
  } else if (nanoseconds < 10'000'000) {
    std::snprintf(text, sizeof text, "%.1f us", nanoseconds / 1e3);
  } else {
    std::snprintf(text, sizeof text, "%.1f ms", nanoseconds / 1e6);
  }
  return text;
}

void print(const Collector::Row& row, const std::vector<Collector::Row>& rows, const Targets& targets) {
  std::string ratio = "-";
  std::string wanted = "-";
  std::string verdict = "-";
  if (const auto target = targets.find(row.name); target != targets.end()) {
    const auto baseline = std::ranges::find_if(rows, [&](const Collector::Row& other) {
      return other.name == target->second.baseline && other.size == row.size;
    });
    if (baseline != rows.end() && baseline->nanoseconds > 0) {
      char text[32];
      const double times = row.nanoseconds / baseline->nanoseconds;
      std::snprintf(text, sizeof text, "%.2f", times);
      ratio = text;
      if (target->second.at_most > 0) {
        std::snprintf(text, sizeof text, "%.1f", target->second.at_most);
        wanted = text;
        verdict = times <= target->second.at_most ? "ok" : "over";
      }
    }
    if (target->second.limit > 0) {
      wanted = in_words(target->second.limit);
      verdict = row.nanoseconds <= target->second.limit ? "ok" : "over";
    }
  }
  if (!row.error.empty()) verdict = row.error;
  std::printf("%s\t%s\t%s\t%s\t%s\t%s\n", row.name.c_str(), row.size.empty() ? "-" : row.size.c_str(),
              in_words(row.nanoseconds).c_str(), ratio.c_str(), wanted.c_str(), verdict.c_str());
}

}  // namespace

const std::vector<long>& sizes() { return run_sizes; }

int run(int argc, char** argv, const Targets& targets, void (*register_all)()) {
  std::vector<char*> arguments;
  // Random interleaving and medians keep other load of the machine out of the ratios.
  std::vector<std::string> usual{"--benchmark_repetitions=7", "--benchmark_enable_random_interleaving=true",
                                 "--benchmark_min_time=0.1"};
  for (int i = 0; i < argc; ++i) {
    if (std::string_view(argv[i]) != "--smoke") {
      arguments.push_back(argv[i]);
      continue;
    }
    run_sizes.assign(std::begin(smoke_sizes), std::end(smoke_sizes));
    usual = {"--benchmark_min_time=0.001"};
  }
  for (std::string& argument : usual) arguments.insert(arguments.begin() + 1, argument.data());
  int count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, arguments.data());
  if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) return 2;
  register_all();
  Collector collector;
  benchmark::RunSpecifiedBenchmarks(&collector);
  for (const auto& row : collector.in_order()) print(row, collector.rows(), targets);
  return 0;
}

}  // namespace geminga::bench
