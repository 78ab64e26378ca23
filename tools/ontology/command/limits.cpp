#include "ontology/command/limits.hpp"

#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>

#include <csignal>
#include <string_view>

#include "ontology/command/exit_status.hpp"

namespace geminga::ontology {
namespace {

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
