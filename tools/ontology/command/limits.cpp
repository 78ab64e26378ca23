#include "ontology/command/limits.hpp"

#include <sys/resource.h>
#include <sys/time.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <string_view>

#include "ontology/command/exit_status.hpp"

namespace geminga::ontology {
namespace {

/// Goes to the begin of the line of progress on a terminal, so that the words overwrite it. Makes only calls that are
/// safe in a signal handler.
void begin_line() {
  termios terminal{};
  if (tcgetattr(STDERR_FILENO, &terminal) != 0) return;
  [[maybe_unused]] const auto written = write(STDERR_FILENO, "\r", 1);
}

/// Makes only calls that are safe in a signal handler.
void on_asking_too_long(int) {
  constexpr std::string_view words =
      "geminga-ontology: the query takes too much processor time: ask for less at once, or give --time-limit\n";
  begin_line();
  [[maybe_unused]] const auto written = write(STDERR_FILENO, words.data(), words.size());
  _exit(static_cast<int>(Exit::timed_out));
}

/// Makes only calls that are safe in a signal handler.
void on_time_out(int) {
  constexpr std::string_view words =
      "geminga-ontology: the time limit is over and nothing is settled: raise --time-limit, or split the ontology\n";
  begin_line();
  [[maybe_unused]] const auto written = write(STDERR_FILENO, words.data(), words.size());
  _exit(static_cast<int>(Exit::timed_out));
}

}  // namespace

base::Budget budget_of(const WorkLimits& limits) { return budget_of(limits, limits.steps); }

base::Budget budget_of(const WorkLimits& limits, std::uint64_t steps) {
  if (limits.seconds == 0) return base::Budget(steps);
  const auto end = limits.start + std::chrono::seconds(limits.seconds);
  return base::Budget(steps, [end] { return std::chrono::steady_clock::now() >= end; });
}

WorkLimits first_half(const WorkLimits& limits) {
  WorkLimits half = limits;
  half.seconds = (limits.seconds + 1) / 2;
  return half;
}

WorkLimits three_quarters(const WorkLimits& limits) {
  WorkLimits most = limits;
  most.seconds = (3 * limits.seconds + 3) / 4;
  return most;
}

std::size_t graph_octets(const WorkLimits& limits) {
  if (limits.graph_mib != 0) return std::size_t{limits.graph_mib} << 20U;
  if (limits.memory_mib != 0) return (std::size_t{limits.memory_mib} << 20U) / 2;
  return std::size_t{WorkLimits::default_graph_mib} << 20U;
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
