#include "ontology/command/limits.hpp"

#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <string_view>

#include "ontology/command/exit_status.hpp"

namespace geminga::ontology {
namespace {

/// Makes only calls that are safe in a signal handler.
void on_asking_too_long(int) {
  constexpr std::string_view words =
      "geminga-ontology: the query takes too much processor time: ask for less at once, or give --time-limit\n";
  [[maybe_unused]] const auto written = write(STDERR_FILENO, words.data(), words.size());
  _exit(static_cast<int>(Exit::timed_out));
}

/// Makes only calls that are safe in a signal handler.
void on_time_out(int) {
  constexpr std::string_view words =
      "geminga-ontology: the time limit is over and nothing is settled: raise --time-limit, or split the ontology\n";
  [[maybe_unused]] const auto written = write(STDERR_FILENO, words.data(), words.size());
  _exit(static_cast<int>(Exit::timed_out));
}

}  // namespace

base::Budget budget_of(const WorkLimits& limits) {
  if (limits.seconds == 0) return base::Budget(limits.steps);
  const auto end = limits.start + std::chrono::seconds(limits.seconds);
  return base::Budget(limits.steps, [end] { return std::chrono::steady_clock::now() >= end; });
}

std::size_t graph_octets(const WorkLimits& limits) {
  constexpr std::size_t by_default = std::size_t{1} << 30U;
  return limits.memory_mib == 0 ? by_default : (std::size_t{limits.memory_mib} << 20U) / 2;
}

void limit_asking(const WorkLimits& limits) {
  if (limits.seconds != 0) return;
  std::signal(SIGXCPU, on_asking_too_long);
  // A limit of the process, because the cage lets no timer be set.
  rusage used{};
  rlimit limit{};
  if (getrusage(RUSAGE_SELF, &used) != 0 || getrlimit(RLIMIT_CPU, &limit) != 0) return;
  const auto seconds = static_cast<rlim_t>(used.ru_utime.tv_sec + used.ru_stime.tv_sec + 1);
  limit.rlim_cur = std::min(limit.rlim_max, seconds + WorkLimits::default_asking_seconds);
  setrlimit(RLIMIT_CPU, &limit);
}

void limit_memory(unsigned mebibytes) {
  if (mebibytes == 0) return;
  const rlim_t bytes = rlim_t{mebibytes} << 20U;
  const rlimit limit{bytes, bytes};
  setrlimit(RLIMIT_AS, &limit);
}

void limit_time(unsigned seconds) {
  if (seconds == 0) return;
  std::signal(SIGALRM, on_time_out);
  itimerval timer{};
  timer.it_value.tv_sec = static_cast<time_t>(seconds) + seconds / 4 + 1;
  setitimer(ITIMER_REAL, &timer, nullptr);
}

}  // namespace geminga::ontology
