// seccomp by a list of what is forbidden: what is read here needs files and memory, and nothing of the rest.
#include "sandbox.hpp"

#include <seccomp.h>
#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <string_view>

#include "command.hpp"

namespace geminga::ontology {
namespace {

/// Only calls that are safe in a signal handler.
void on_time_out(int) {
  constexpr std::string_view words =
      "geminga-ontology: the time limit is over: raise --time-limit, or split the ontology\n";
  [[maybe_unused]] const auto written = write(STDERR_FILENO, words.data(), words.size());
  _exit(static_cast<int>(Exit::timed_out));
}

}  // namespace

void forbid_the_world(bool may_execute) {
  constexpr std::array always{SCMP_SYS(socket),  SCMP_SYS(socketpair), SCMP_SYS(connect),
                              SCMP_SYS(bind),    SCMP_SYS(listen),     SCMP_SYS(accept),
                              SCMP_SYS(accept4), SCMP_SYS(sendto),     SCMP_SYS(sendmsg)};
  constexpr std::array traces{SCMP_SYS(ptrace), SCMP_SYS(process_vm_readv), SCMP_SYS(process_vm_writev)};
  constexpr std::array programs{SCMP_SYS(execve), SCMP_SYS(execveat)};
  scmp_filter_ctx filter = seccomp_init(SCMP_ACT_ALLOW);
  if (filter == nullptr) return;
  for (const int call : always) seccomp_rule_add(filter, SCMP_ACT_ERRNO(EACCES), call, 0);
  if (!may_trace) {
    for (const int call : traces) seccomp_rule_add(filter, SCMP_ACT_ERRNO(EACCES), call, 0);
  }
  if (!may_execute) {
    for (const int call : programs) seccomp_rule_add(filter, SCMP_ACT_ERRNO(EACCES), call, 0);
  }
  seccomp_load(filter);
  seccomp_release(filter);
}

void limit_memory(unsigned mebibytes) {
  if (mebibytes == 0) return;
  const rlim_t bytes = rlim_t{mebibytes} << 20U;
  const rlimit limit{bytes, bytes};
  setrlimit(RLIMIT_AS, &limit);
}

void limit_time(unsigned seconds) {
  if (seconds == 0) return;
  std::signal(SIGXCPU, on_time_out);
  const rlimit limit{seconds, rlim_t{seconds} + 1};
  setrlimit(RLIMIT_CPU, &limit);
}

}  // namespace geminga::ontology
